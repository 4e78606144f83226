// `CHECK(name, condition)`: an assertion in a clocked block. Stops a Verilator run, is a property
// for the proofs, and nothing in synthesis.
`ifndef KAGESEN_CHECK_SVH
`define KAGESEN_CHECK_SVH
`ifdef VERILATOR
`define CHECK(name, condition) name: assert (condition) else $error("%m");
`elsif FORMAL
`define CHECK(name, condition) assert (condition);
`else
`define CHECK(name, condition)
`endif
`endif
