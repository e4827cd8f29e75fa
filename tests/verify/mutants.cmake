# restrip_verify_mutants(PROGRAM HEADER TEST START): the deliberate faults that HEADER lists, all in one PROGRAM, which is run
# once for each as TEST.NAME. The names are read from the header into mutant_names.hpp (named_mutant.hpp); the compiler warns
# about one that is not found. What the program prints begins with START (a regular expression) and says that the fault
# `none` survived; only then does it mean anything that another one is killed.
include_guard(GLOBAL)

function(restrip_verify_mutants program header test start)
  file(STRINGS ${header} names REGEX "^  [a-z_]+,? *(//.*)?$")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
  list(TRANSFORM names REPLACE "^  ([a-z_]+).*" "\\1")
  list(TRANSFORM names REPLACE "(.+)" " X(\\1)" OUTPUT_VARIABLE items)
  string(CONCAT items ${items})
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/mutants/mutant_names.hpp
       CONTENT "#define RESTRIP_EACH_MUTANT(X)@items@\n" @ONLY)
  target_include_directories(${program} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR} ${CMAKE_CURRENT_BINARY_DIR}/mutants)
  foreach(name IN LISTS names)
    add_test(NAME ${test}.${name} COMMAND ${program} ${name})
    if(name STREQUAL "none")
      set_tests_properties(${test}.none PROPERTIES PASS_REGULAR_EXPRESSION "${start}survived" FIXTURES_SETUP ${test})
    else()
      set_tests_properties(${test}.${name} PROPERTIES PASS_REGULAR_EXPRESSION "${start}killed by: " FIXTURES_REQUIRED ${test})
    endif()
  endforeach()
endfunction()
