# Who may include whom (docs: CONTRIBUTING.md). Reads the include lines of every room and fails where a wall is broken.
#   rule: ROOM REGEX = no include line in ROOM may match REGEX
set(rules
    "generator [\"<]restrip/"                                            # the generator never sees its product
    "verify [\"<](restrip/|.*generator/|.*replay/|.*runtime/|.*tables/)" # the verifier sees nothing of ours
    "runtime <(boost|fmt|nauty|openssl|CLI|nlohmann|OpenMesh)"           # the runtime needs the standard library only
    "tables [\"<](boost|fmt|vector|string|restrip/(operations|strip_mesh|rules))"
    "replay [\"<](.*generator/|.*verify/|restrip/tables/)"
    "bench [\"<](.*generator/|.*verify/)")
set(broken 0)
set(seen 0)
foreach(rule IN LISTS rules)
  string(REGEX MATCH "^([a-z]+) (.*)$" _ "${rule}")
  set(room ${CMAKE_MATCH_1})
  set(forbidden "${CMAKE_MATCH_2}")
  file(GLOB_RECURSE sources ${ROOT}/${room}/*.hpp ${ROOT}/${room}/*.cpp)
  # The program that prints the compiled tables for the verifier, and the adapters to other libraries, stand in runtime/ on purpose.
  list(FILTER sources EXCLUDE REGEX "/adapters/|/verify/formal/")
  foreach(source IN LISTS sources)
    file(STRINGS ${source} includes REGEX "^#include")
    foreach(line IN LISTS includes)
      math(EXPR seen "${seen} + 1")
      if(line MATCHES "${forbidden}")
        message(SEND_ERROR "${source}: ${line}: ${room}/ must not include this")
        set(broken 1)
      endif()
    endforeach()
  endforeach()
endforeach()
if(seen LESS 50)
  message(FATAL_ERROR "only ${seen} include lines were read; has a room moved?")
endif()
# The check itself must be able to fail.
if(NOT "#include <restrip/rules.hpp>" MATCHES "[\"<]restrip/")
  message(FATAL_ERROR "the pattern of the generator's wall matches nothing")
endif()
message(STATUS "${seen} include lines, no wall broken")
