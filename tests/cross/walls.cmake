# Checks who may include whom (CONTRIBUTING.md). Reads the include lines of every room; what is not allowed is forbidden.
# Allowed everywhere: standard headers, and quoted files in the same room.
set(std "<[a-z_0-9]+>")
set(allowed_in_common "${std}|\"common/.*\"|<(fmt|nlohmann|openssl)/.*>|<(fcntl|signal|unistd|sys/stat|sys/types).h>")
set(allowed_in_generator "${std}|\"common/.*\"|<(fmt|nauty|openssl|CLI|nlohmann)/.*>|<unistd.h>")
set(allowed_in_verify "${std}|\"common/(counted|digest|json|printable|progress|reading|share).hpp\"|<(boost|fmt|nlohmann|openssl|CLI)/.*>|<(unistd|stdlib|spawn|fcntl|sys/wait).h>")
set(allowed_in_runtime "${std}|\"(restrip|mesh|operations|output|search|formats|live)/.*\"|RESTRIP_USER_CONFIG")
set(allowed_in_tables "${std}|\"restrip/tables/(([a-z_]+_)?format|operations/[a-z0-9_]+).hpp\"")
set(allowed_in_tools "${std}|\"(restrip|mesh|search|formats|common|measure|meshes|pictures|lod|replay|paper|app)/.*\"|<(fmt|CLI|nlohmann)/.*>|<(png|unistd).h>")
set(allowed_in_examples "${std}|[\"<]restrip/.*[\">]|<(restrip|stdio|stdlib).h>|<OpenMesh/.*>")
set(allowed_in_web "${std}|\"restrip/restrip.hpp\"")
set(allowed_in_bindings/js "${std}|\"restrip.h\"")
set(allowed_in_bindings/c "${std}|<std(def|int).h>|\"restrip.h\"|\"restrip/.*\"")
set(allowed_in_bench "${std}|[\"<]restrip/.*[\">]|<(benchmark|fmt|nlohmann|OpenMesh|meshoptimizer)[./].*>|<meshoptimizer.h>|<(malloc|unistd).h>")
string(APPEND allowed_in_bench "|\"(common|measure|meshes|lod|replay)/.*\"|\"rm_tristripper.h\"|<string.h>")  # bench/ measures the mesh programs too
# Private headers of the library.
set(door_private "\"(formats|live|mesh|operations|output|search)/[a-z_]+.hpp\"")
# The program that prints what the compiled look-ups answer.
set(door_dump "\"restrip/(rules|operations)/[a-z]+.hpp\"")
# Only the verifying programs write files.
set(door_reports "\"common/(output|system_calls).hpp\"")
# The page "Make a rule": one file is the generator's, one the verifier's; what is below them has neither.
set(door_maker "\"common/[^\"]*\"|<nlohmann/json.hpp>|<stdio.h>")
set(door_maker_generator "\"commands/pipeline.hpp\"")
set(door_maker_verify "\"explain/explanation.hpp\"|\"model/input.hpp\"|\"verify.hpp\"")
# The readers and the simplifier of the program, for JavaScript.
set(door_readers "\"(lod/(coloring_check|mesh_formats|simplifier)|meshes/(mend|soup)).hpp\"")
# The C header that the generator writes includes what programs of C need.
set(door_templates "<std(bool|int).h>")
set(door_check "<(stdio|stdlib|string).h>|\"restrip_(automaton|tables|rule_of_@name@).h\"")
set(never_in_tools "restrip/tables/")
# Bodies are private to the floor of their manual; see below. Searches that have no public header (runtime/src/search) are
# open to baking, to the method of the paper and to tests.
set(never_in_bindings/c "restrip/tables/")

# The floors, lowest first: a file includes its own folder and lower floors, never a higher floor or another folder of the same floor.
set(floors_runtime tables precondition.hpp fwd.hpp rules|mesh operations|output search|formats live_mesh.hpp live restrip.hpp)
set(floors_generator common describe solve certify tables automaton emit commands)
set(floors_verify common model definition certificate judge explain automaton)
set(floors_tools restrip|mesh|search|formats common measure meshes pictures lod replay paper app)

# floor_of(ROOM FOLDER OUT): the number of the floor, or -1.
function(floor_of room folder out)
  set(${out} -1 PARENT_SCOPE)
  set(number 0)
  foreach(floor IN LISTS floors_${room})
    if(folder MATCHES "^(${floor})$")
      set(${out} ${number} PARENT_SCOPE)
    endif()
    math(EXPR number "${number} + 1")
  endforeach()
endfunction()

# judge_floor(ROOM FOLDER WHAT OUT): OUT is true if a file of FOLDER ("search") must not include WHAT
# because of its floor.
function(judge_floor room folder what out)
  set(${out} FALSE PARENT_SCOPE)
  if(NOT what MATCHES "^\"(restrip/)?([a-z_.]+)(/.*)?\"$")
    return()
  endif()
  set(there ${CMAKE_MATCH_2})
  if(room STREQUAL "tools" AND what MATCHES "^\"restrip/")
    return()
  endif()
  string(REGEX REPLACE "/.*" "" here "${folder}")
  if(here STREQUAL there)
    return()
  endif()
  floor_of(${room} "${here}" from)
  floor_of(${room} "${there}" to)
  if(from EQUAL -1 OR to EQUAL -1 OR NOT to LESS from)
    set(${out} TRUE PARENT_SCOPE)
  endif()
endfunction()

# judge(ROOM SOURCE LINE OUT): OUT is true if the include line breaks a wall.
function(judge room source line out)
  set(${out} TRUE PARENT_SCOPE)
  string(REGEX REPLACE "^#include +([<\"][^>\"]+[>\"]|[A-Z_]+).*$" "\\1" what "${line}")
  if(DEFINED never_in_${room} AND what MATCHES "${never_in_${room}}")
    return()
  endif()
  if(DEFINED floors_${room})
    string(REGEX REPLACE "^${ROOT}/${room}/(include/restrip/|src/)?" "" path "${source}")
    # Programs that print the answers of headers and the text of templates are above all floors; a file without a folder is
    # a separate floor.
    if((path MATCHES "/" AND NOT path MATCHES "^emit/templates/") OR path MATCHES "^(restrip|precondition).hpp$")
      string(REGEX REPLACE "/[^/]*$" "" folder "${path}")
      judge_floor(${room} "${folder}" "${what}" wrong_floor)
      if(wrong_floor)
        return()
      endif()
    endif()
  endif()
  if(source MATCHES "/runtime/src/" AND what MATCHES "^(${door_private})$"
     OR source MATCHES "/tables/dump/" AND what MATCHES "^(${door_dump})$"
     OR source MATCHES "/verify/((main|[a-z]+/commands?).cpp|model/program.hpp)" AND what MATCHES "^(${door_reports})$"
     OR source MATCHES "/web/maker/module/" AND what MATCHES "^(${door_maker})$"
     OR source MATCHES "/web/maker/module/generator.cpp$" AND what MATCHES "^(${door_maker_generator})$"
     OR source MATCHES "/web/maker/module/verify.cpp$" AND what MATCHES "^(${door_maker_verify})$"
     OR source MATCHES "/web/readers/" AND what MATCHES "^(${door_readers})$"
     OR source MATCHES "/generator/emit/templates/" AND what MATCHES "^(${door_templates})$"
     OR source MATCHES "/generator/emit/templates/(automaton|operation|tables)_check.c$" AND what MATCHES "^(${door_check})$"
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
  endif()
endfunction()

set(seen 0)
foreach(room IN ITEMS common generator verify runtime tables tools examples bench web bindings/c bindings/js)
  file(GLOB_RECURSE sources ${ROOT}/${room}/*.hpp ${ROOT}/${room}/*.cpp ${ROOT}/${room}/*.h ${ROOT}/${room}/*.c)
  list(FILTER sources EXCLUDE REGEX "/verify/formal/")  # separate printers, compiled by its script
  foreach(source IN LISTS sources)
    file(STRINGS ${source} includes REGEX "^ *# *include")
    foreach(line IN LISTS includes)
      math(EXPR seen "${seen} + 1")
      judge(${room} ${source} "${line}" broken)
      if(broken)
        message(SEND_ERROR "${source}: ${line}: must not be included here (CONTRIBUTING.md, \"Folders\")")
      endif()
    endforeach()
  endforeach()
endforeach()
if(seen LESS 500)
  message(FATAL_ERROR "only ${seen} include lines were read; has a room moved?")
endif()

# The check itself must be able to fail, for every room and floor: path from the top | a forbidden include.
foreach(wrong IN ITEMS "generator/any.cpp|\"restrip/rules/rules.hpp\"" "generator/any.cpp|<restrip/tables/split.hpp>" "generator/any.cpp|<stdint.h>"
                       "generator/emit/templates/any.h|<stdlib.h>"
                       "generator/describe/any.cpp|\"solve/section.hpp\"" "generator/solve/any.cpp|\"certify/certificate.hpp\""
                       "generator/certify/any.hpp|\"tables/layout.hpp\"" "generator/tables/any.hpp|\"automaton/automaton.hpp\""
                       "generator/automaton/any.cpp|\"emit/emit.hpp\"" "generator/emit/any.cpp|\"commands/pipeline.hpp\""
                       "verify/any.cpp|\"restrip/rules/rules.hpp\"" "verify/any.cpp|\"../generator/patch.hpp\""
                       "runtime/include/restrip/rules/any.hpp|<fmt/format.h>"
                       "runtime/include/restrip/mesh/any.hpp|<boost/graph/graph_traits.hpp>"
                       "tables/include/restrip/tables/any.hpp|<fmt/format.h>" "tables/include/restrip/tables/any.hpp|\"restrip/rules/rules.hpp\""
                       "verify/any.cpp|\"common/output.hpp\"" "verify/model/any.hpp|\"judge/worlds.hpp\""
                       "verify/certificate/any.hpp|\"judge/report.hpp\"" "common/any.cpp|\"restrip/rules/rules.hpp\""
                       "common/any.cpp|\"meshes/soup.hpp\"" "tools/app/any.cpp|\"restrip/tables/split.hpp\""
                       "tools/app/any.cpp|\"section.hpp\"" "bench/any.cpp|\"judgment.hpp\"" "examples/any.cpp|\"meshes/soup.hpp\""
                       "runtime/include/restrip/rules/any.hpp|\"restrip/mesh/strip_mesh.hpp\""
                       "runtime/include/restrip/mesh/any.hpp|\"restrip/rules/rules.hpp\""
                       "runtime/include/restrip/mesh/any.hpp|\"restrip/operations/operations.hpp\""
                       "runtime/include/restrip/operations/any.hpp|\"restrip/search/keeper.hpp\""
                       "runtime/include/restrip/operations/any.hpp|\"restrip/output/strips.hpp\""
                       "runtime/include/restrip/output/any.hpp|\"restrip/operations/operations.hpp\""
                       "runtime/include/restrip/search/any.hpp|\"restrip/restrip.hpp\""
                       "runtime/src/mesh/any.cpp|\"operations/halves.hpp\""
                       "runtime/include/restrip/precondition.hpp|\"restrip/mesh/refusal.hpp\""
                       "tools/common/any.cpp|\"meshes/soup.hpp\"" "tools/meshes/any.cpp|\"lod/simplify.hpp\""
                       "tools/lod/any.cpp|\"replay/replay.hpp\"" "tools/replay/any.cpp|\"paper/paper.hpp\""
                       "tools/paper/any.cpp|\"app/options.hpp\""
                       "bench/any.cpp|\"operations/patch_walk.hpp\"" "bindings/js/glue/any.cpp|\"lod/simplify.hpp\"" "web/readers/any.cpp|\"lod/simplify.hpp\""
                       "web/maker/module/generate.cpp|\"verify.hpp\"" "web/maker/module/judge.cpp|\"commands/pipeline.hpp\""
                       "bindings/js/glue/any.cpp|\"restrip/rules/rules.hpp\""
                       "bindings/c/any.cpp|\"lod/simplify.hpp\"" "bindings/c/any.cpp|<fmt/format.h>"
                       "examples/any.c|<unistd.h>")
  string(REPLACE "|" ";" wrong "${wrong}")
  list(GET wrong 0 source)
  list(GET wrong 1 what)
  string(REGEX MATCH "^(bindings/)?[^/]+" room "${source}")
  judge(${room} ${ROOT}/${source} "#include ${what}" broken)
  if(NOT broken)
    message(SEND_ERROR "${source} may include ${what}")
  endif()
endforeach()
message(STATUS "${seen} include lines, no wall broken")
