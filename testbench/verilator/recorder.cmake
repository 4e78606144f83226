# Writes a module that records the pins of TOP, bound to it, and a manifest of what TOP is made of.
#   cmake -DOUT=FOLDER -DTARGET=NAME -DTOP=MODULE -DPACKAGE=FILE "-DSOURCES=FILE|FILE..."
#         "-DOPTIONS=-GName=value|..." -DINCLUDE=FOLDER -P recorder.cmake
string(REPLACE "|" ";" SOURCES "${SOURCES}")
string(REPLACE "|" ";" OPTIONS "${OPTIONS}")
set(parameters)
set(manifest "top ${TOP}\npackage ${PACKAGE}\n")
foreach(option ${OPTIONS})
  if(option MATCHES "^-G([A-Za-z0-9_]+)=(.*)$")
    string(APPEND parameters " -chparam ${CMAKE_MATCH_1} ${CMAKE_MATCH_2}")
    string(APPEND manifest "parameter ${CMAKE_MATCH_1} ${CMAKE_MATCH_2}\n")
  endif()
endforeach()
foreach(source ${SOURCES})
  string(APPEND manifest "source ${source}\n")
endforeach()
list(JOIN SOURCES " " files)
set(ports ${OUT}/${TARGET}_ports.json)
execute_process(
  COMMAND yosys -q -p "read_verilog -sv -I${INCLUDE} ${PACKAGE} ${files}; hierarchy -top ${TOP} ${parameters}; blackbox =*; write_json ${ports}"
  COMMAND_ERROR_IS_FATAL ANY)
file(READ ${ports} json)
string(JSON ports GET "${json}" modules ${TOP} ports)
string(JSON count LENGTH "${ports}")
math(EXPR last "${count} - 1")
set(clocked FALSE)
set(reset FALSE)
set(declarations)
set(names_input)
set(names_output)
foreach(i RANGE ${last})
  string(JSON name MEMBER "${ports}" ${i})
  string(JSON direction GET "${ports}" ${name} direction)
  string(JSON width LENGTH "${ports}" ${name} bits)
  math(EXPR high "${width} - 1")
  list(APPEND declarations "  input logic [${high}:0] ${name}")
  if(name STREQUAL clk_i)
    set(clocked TRUE)
  else()
    if(name STREQUAL rst_ni)
      set(reset TRUE)
    endif()
    list(APPEND names_${direction} ${name})
    string(APPEND manifest "${direction} ${name} ${width}\n")
  endif()
endforeach()
list(JOIN declarations ",\n" declarations)
list(JOIN names_input ", " inputs)
list(JOIN names_output ", " outputs)
if(clocked)
  set(when "always @(posedge clk_i)")
else()
  set(when "always @(${inputs})")
endif()
set(on_reset)
if(reset AND clocked)
  set(on_reset "  always @(negedge rst_ni) if (file != 0) begin\n    $fdisplay(file, \"R\");\n    $fflush(file);\n  end\n")
endif()
file(WRITE ${OUT}/${TARGET}.manifest "${manifest}clocked ${clocked}\n")
file(WRITE ${OUT}/${TARGET}_recorder.sv "/* verilator lint_off WIDTH */
/* verilator lint_off UNUSED */
/* verilator lint_off UNOPTFLAT */
/* verilator lint_off BLKSEQ */
/* verilator lint_off SYNCASYNCNET */
module ${TARGET}_recorder (
${declarations}
);
  import \"DPI-C\" context function string kagesen_record_file(input string target);
  import \"DPI-C\" context function int kagesen_record_more(input string target);
  integer file;
  initial begin
    file = 0;
    if (kagesen_record_file(\"${TARGET}\") != \"\") begin
      file = $fopen(kagesen_record_file(\"${TARGET}\"), \"a\");
      $fdisplay(file, \"N\");
      $fflush(file);
    end
  end
${on_reset}  ${when}
    if (file != 0 && kagesen_record_more(\"${TARGET}\") != 0) begin
      $fdisplay(file, \"%h %h\", {${inputs}}, {${outputs}});
      $fflush(file);  // the next instance writes behind it
    end
endmodule
bind ${TOP} ${TARGET}_recorder recorder (.*);
")
