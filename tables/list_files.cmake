# Writes include/restrip/tables/shipped_operations.hpp, which visits the tables of all operations. Then adds to the
# MANIFEST of a folder of tables what lies there and was not written with the rules: the descriptions, this header, those
# written by hand, and the custom operations. Lines of these files that it already has are made from scratch.
#   cmake -DTABLES=FOLDER -P list_files.cmake
cmake_policy(SET CMP0057 NEW)
get_filename_component(TABLES ${TABLES} ABSOLUTE)

file(GLOB names RELATIVE ${TABLES}/operations ${TABLES}/operations/*.json)
list(TRANSFORM names REPLACE "[.]json$" "")
list(SORT names)
set(includes "")
set(calls "")
foreach(name IN LISTS names)
  string(REPLACE - _ identifier ${name})
  string(APPEND includes "#include \"restrip/tables/operations/${identifier}.hpp\"\n")
  string(APPEND calls "  visit(\"${name}\", ${identifier}_rules);\n")
endforeach()
file(WRITE ${TABLES}/include/restrip/tables/shipped_operations.hpp
"// Visits the tables of tables/operations. Written by the target `regenerate`. Do not edit.
#pragma once

${includes}
namespace restrip::tables {

/// Calls visit(name, table) for each shipped operation, in the order of their names.
template <class Visit>
constexpr void for_each_operation(Visit&& visit) {
${calls}}

}  // namespace restrip::tables
")

file(STRINGS ${TABLES}/MANIFEST lines)
list(POP_FRONT lines heading)
set(listed "")
set(by_path "")
foreach(line IN LISTS lines)
  string(REGEX MATCH "[^ ]+$" path "${line}")
  if(path MATCHES "[.]json$|operations[/.]|format[.]hpp$|_dump[.]hpp$|^dump/")
    continue()
  endif()
  list(APPEND listed ${path})
  list(APPEND by_path "${path} ${line}")
endforeach()

# The number of rows of a certificate is in its last line; a header has the same number as its certificate.
function(rows_of path out)
  string(REGEX REPLACE "^include/restrip/tables/(.*)[.]hpp$" "certificates/\\1.cert" certificate ${path})
  string(REPLACE _ - certificate ${certificate})
  set(rows 0)
  if(certificate MATCHES "[.]cert$" AND EXISTS ${TABLES}/${certificate})
    file(STRINGS ${TABLES}/${certificate} last REGEX "^end [0-9]+ ")
    string(REGEX REPLACE "^end ([0-9]+) .*" "\\1" rows "${last}")
  endif()
  set(${out} ${rows} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE files RELATIVE ${TABLES} ${TABLES}/*)
list(FILTER files EXCLUDE REGEX "^MANIFEST$|CMakeLists[.]txt$|[.]cmake$")
foreach(path IN LISTS files)
  if(path IN_LIST listed)
    continue()
  endif()
  file(SHA256 ${TABLES}/${path} hash)
  file(SIZE ${TABLES}/${path} bytes)
  rows_of(${path} rows)
  list(APPEND by_path "${path} ${hash} ${bytes} ${rows} ${path}")
endforeach()
list(SORT by_path COMPARE STRING)
list(TRANSFORM by_path REPLACE "^[^ ]+ (.*)$" "\\1")
list(PREPEND by_path "${heading}")
list(JOIN by_path "\n" text)
file(WRITE ${TABLES}/MANIFEST "${text}\n")
