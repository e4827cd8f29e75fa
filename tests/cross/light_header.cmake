# With the compiled library, live_mesh.hpp includes these headers of ours and no other: a file with a member of its type must
# compile about as fast as one that includes the same standard headers.
set(expected fwd.hpp live_mesh.hpp mesh/cost.hpp mesh/mesh.hpp mesh/refusal.hpp mesh/strip_mesh.hpp mesh/triangle_list.hpp
             operations/result.hpp output/strip_format.hpp precondition.hpp)
# headers_of(FLAGS OUT): the headers of restrip that it reaches.
function(headers_of flags out)
  file(WRITE ${SCRATCH}.cpp "#include <restrip/live_mesh.hpp>\n")
  execute_process(COMMAND ${COMPILER} -std=c++20 ${flags} -I ${ROOT}/runtime/include -I ${ROOT}/tables/include -MM ${SCRATCH}.cpp
                  OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "include/restrip/[^ \\\n]+" headers "${printed}")
  list(TRANSFORM headers REPLACE "include/restrip/" "")
  list(SORT headers)
  set(${out} "${headers}" PARENT_SCOPE)
endfunction()
headers_of("-DRESTRIP_COMPILED" light)
if(NOT light STREQUAL expected)
  message(FATAL_ERROR "live_mesh.hpp includes\n  ${light}\ninstead of\n  ${expected}")
endif()
headers_of("" all)
list(LENGTH all count)
if(count LESS 50)
  message(FATAL_ERROR "without the library live_mesh.hpp must include all bodies, but it includes only ${all}")
endif()
