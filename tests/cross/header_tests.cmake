# Each public header of the runtime has a test of the same name: tests/runtime has the folders of
# runtime/include/restrip. The test includes the header before
# all other headers of the project. So if the test is compiled alone (in every preset without shared units), the header
# is shown to be self-contained. Headers that declare what others define are tested with those, and compiled alone by
# cross.declarations.

# judge(HEADER TEST OUT): the fault of TEST, a file, as the test of HEADER, a path from runtime/include; empty if none.
function(judge header test out)
  set(${out} "" PARENT_SCOPE)
  if(NOT EXISTS ${test})
    set(${out} "${test} is missing" PARENT_SCOPE)
    return()
  endif()
  file(STRINGS ${test} includes REGEX "^#include \"restrip/")
  file(STRINGS ${test} tests REGEX "^(TYPED_)?TEST(_F|_P)?\\(")
  set(first "")
  if(includes)
    list(GET includes 0 first)
  endif()
  if(NOT first STREQUAL "#include \"${header}\"")
    set(${out} "${test} does not include it before all others" PARENT_SCOPE)
  elseif(NOT tests)
    set(${out} "${test} tests nothing" PARENT_SCOPE)
  endif()
endfunction()

# test_of(HEADER OUT)
function(test_of header out)
  string(REGEX REPLACE "^restrip/(.*).hpp$" "\\1" name "${header}")
  set(${out} ${ROOT}/tests/runtime/${name}_test.cpp PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE headers RELATIVE ${ROOT}/runtime/include ${ROOT}/runtime/include/*.hpp)
list(LENGTH headers seen)
foreach(name IN LISTS DECLARATIONS)
  list(FIND headers restrip/${name}.hpp place)
  if(place EQUAL -1)
    message(SEND_ERROR "restrip/${name}.hpp does not exist")
  endif()
  list(REMOVE_ITEM headers restrip/${name}.hpp)
endforeach()
foreach(header IN LISTS headers)
  test_of(${header} test)
  judge(${header} ${test} fault)
  if(fault)
    message(SEND_ERROR "${header} has no test of its name: ${fault} (CONTRIBUTING.md, \"Folders\")")
  endif()
endforeach()
if(seen LESS 20)
  message(FATAL_ERROR "only ${seen} public headers were found; has the folder moved?")
endif()

# The check itself must be able to fail: header | the file that is to be its test.
foreach(wrong IN ITEMS "restrip/search/any.hpp|tests/runtime/search/any_test.cpp"
                       "restrip/search/keeper.hpp|tests/runtime/search/tunnel_test.cpp"
                       "restrip/mesh/checks.hpp|runtime/include/restrip/operations/refine.hpp")
  string(REPLACE "|" ";" wrong "${wrong}")
  list(GET wrong 0 header)
  list(GET wrong 1 test)
  judge(${header} ${ROOT}/${test} fault)
  if(NOT fault)
    message(SEND_ERROR "${test} was taken for the test of ${header}")
  endif()
endforeach()
