# kagesen_verilate(TARGET TOP SOURCES... [PACKAGE FILE] [OPTIONS ...]): a module of the RTL as a C++
# class V<TARGET>, in a library of that name. PACKAGE: the shadow_pkg.sv it is built with.
find_program(VERILATOR verilator REQUIRED)
set(VERILATOR_INCLUDE /usr/share/verilator/include CACHE PATH "Verilator's runtime")
set(KAGESEN_RTL ${CMAKE_SOURCE_DIR}/rtl)

option(KAGESEN_RECORD "Tests can record the pins of what they drive (testbench/mutation)" OFF)

function(kagesen_verilate target top)
  cmake_parse_arguments(arg "" "PACKAGE" "SOURCES;OPTIONS" ${ARGN})
  set(dir ${CMAKE_CURRENT_BINARY_DIR}/${target}_verilated)
  set(archive ${dir}/V${target}__ALL.a)
  set(recorder)
  if(KAGESEN_RECORD)
    set(recorder ${CMAKE_BINARY_DIR}/recorders/${target}_recorder.sv)
    list(JOIN arg_SOURCES "|" sources)
    list(JOIN arg_OPTIONS "|" options)
    add_custom_command(OUTPUT ${recorder}
      COMMAND ${CMAKE_COMMAND} -DOUT=${CMAKE_BINARY_DIR}/recorders -DTARGET=${target} -DTOP=${top}
        -DPACKAGE=${arg_PACKAGE} "-DSOURCES=${sources}" "-DOPTIONS=${options}"
        -DINCLUDE=${KAGESEN_RTL}/common -P ${CMAKE_SOURCE_DIR}/testbench/verilator/recorder.cmake
      DEPENDS ${arg_PACKAGE} ${arg_SOURCES} ${CMAKE_SOURCE_DIR}/testbench/verilator/recorder.cmake VERBATIM)
  endif()
  add_custom_command(OUTPUT ${archive}
    COMMAND ${VERILATOR} --cc --build -Mdir ${dir} --prefix V${target} --top-module ${top} -Wall
      --assert -O3 --x-assign unique --x-initial unique -I${KAGESEN_RTL}/common
      -CFLAGS -O1 --output-split 20000 ${arg_OPTIONS} ${KAGESEN_RTL}/common/waivers.vlt
      ${arg_PACKAGE} ${arg_SOURCES} ${recorder}
    DEPENDS ${arg_PACKAGE} ${arg_SOURCES} ${recorder} ${KAGESEN_RTL}/common/check.svh
    COMMENT "Verilating ${target}" VERBATIM)
  add_custom_target(${target}_archive DEPENDS ${archive})
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_archive)
  target_include_directories(${target} SYSTEM INTERFACE ${dir})
  target_link_libraries(${target} INTERFACE ${archive} kagesen_verilated)
endfunction()
