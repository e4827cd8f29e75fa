# Who may include whom (docs: CONTRIBUTING.md). Reads the include lines of every room; what is not allowed is forbidden.
# Allowed everywhere: standard headers, and quoted files that lie in the room itself.
set(std "<[a-z_0-9]+>")
set(allowed_in_files "${std}|\"files/.*\"|<fmt/.*>|<(fcntl|signal|unistd|sys/stat|sys/types).h>")
set(allowed_in_generator "${std}|\"files/.*\"|<(fmt|nauty|openssl|CLI|nlohmann)/.*>|<unistd.h>")
set(allowed_in_verify "${std}|<(boost/graph|fmt|nauty|openssl|CLI)/.*>|<(unistd|stdlib|spawn|fcntl|sys/wait).h>")
set(allowed_in_runtime "${std}|\"restrip/.*\"")
set(allowed_in_tables "\"restrip/rule_table.hpp\"")
set(allowed_in_replay "${std}|\"(files|restrip)/.*\"|<(fmt|CLI|nlohmann|OpenMesh)/.*>|<unistd.h>")
set(allowed_in_bench "${std}|[\"<]restrip/.*[\">]|<(benchmark|fmt|nlohmann|OpenMesh|meshoptimizer)[./].*>|<meshoptimizer.h>|<(malloc|unistd).h>")
# Doors that are there on purpose: adapters to other libraries, the other backend of batches.
set(door_adapters "<(OpenMesh|CGAL)/.*>")
set(door_parallel_ranges "<tbb/.*>")
# restrip-sat writes files as the other programs do. What the verifier reads, it reads by itself.
set(door_sat "\"files/(output|system_calls).hpp\"")
set(never_in_replay "restrip/tables/")

# judge(ROOM SOURCE LINE OUT): OUT is true when the include line breaks a wall.
function(judge room source line out)
  set(${out} TRUE PARENT_SCOPE)
  string(REGEX REPLACE "^#include +([<\"][^>\"]+[>\"]).*$" "\\1" what "${line}")
  if(DEFINED never_in_${room} AND what MATCHES "${never_in_${room}}")
    return()
  endif()
  if(source MATCHES "/adapters/" AND what MATCHES "^(${door_adapters})$"
     OR source MATCHES "/parallel_ranges" AND what MATCHES "^(${door_parallel_ranges})$"
     OR source MATCHES "/verify/sat/" AND what MATCHES "^(${door_sat})$"
     OR what MATCHES "^(${allowed_in_${room}})$")
    set(${out} FALSE PARENT_SCOPE)
    return()
  endif()
  if(what MATCHES "^\"([^\"/.]+/)?([^\"/]+)\"$")
    get_filename_component(folder "${source}" DIRECTORY)
    string(REPLACE "\"" "" name "${what}")
    if(EXISTS "${folder}/${name}" OR EXISTS "${ROOT}/${room}/${name}")
      set(${out} FALSE PARENT_SCOPE)
    endif()
    # bench/ measures the mesh programs too.
    if(room STREQUAL "bench" AND EXISTS "${ROOT}/replay/${name}")
      set(${out} FALSE PARENT_SCOPE)
    endif()
  endif()
endfunction()

set(seen 0)
foreach(room IN ITEMS files generator verify runtime tables replay bench)
  file(GLOB_RECURSE sources ${ROOT}/${room}/*.hpp ${ROOT}/${room}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/verify/formal/")  # printers of their own, compiled by its script
  foreach(source IN LISTS sources)
    file(STRINGS ${source} includes REGEX "^ *# *include")
    foreach(line IN LISTS includes)
      math(EXPR seen "${seen} + 1")
      judge(${room} ${source} "${line}" broken)
      if(broken)
        message(SEND_ERROR "${source}: ${line}: ${room}/ must not include this")
      endif()
    endforeach()
  endforeach()
endforeach()
if(seen LESS 500)
  message(FATAL_ERROR "only ${seen} include lines were read; has a room moved?")
endif()

# The check itself must be able to fail, for every room.
foreach(wrong IN ITEMS "generator|\"restrip/rules.hpp\"" "generator|<restrip/tables/split.hpp>" "verify|\"restrip/rules.hpp\""
                       "verify|\"../generator/patch.hpp\"" "runtime|<fmt/format.h>" "runtime|<boost/graph/graph_traits.hpp>"
                       "runtime|<OpenMesh/Core/Mesh/Handles.hh>" "tables|<vector>" "tables|\"restrip/rules.hpp\""
                       "verify|\"files/output.hpp\"" "files|\"restrip/rules.hpp\"" "files|\"soup.hpp\""
                       "replay|\"restrip/tables/split.hpp\"" "replay|\"section.hpp\"" "bench|\"judgment.hpp\"")
  string(REPLACE "|" ";" wrong "${wrong}")
  list(GET wrong 0 room)
  list(GET wrong 1 what)
  judge(${room} ${ROOT}/${room}/any.cpp "#include ${what}" broken)
  if(NOT broken)
    message(SEND_ERROR "the wall around ${room}/ lets ${what} through")
  endif()
endforeach()
message(STATUS "${seen} include lines, no wall broken")
