// How the carries of additions are made; techmap takes it before Yosys' own map.
