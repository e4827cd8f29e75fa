# The program itself, with custom operations.
# Compiled tables: shipped ones, and generated ones for operations of the corpus.
set(corpus ${RESTRIP_CORPUS_DIR}/operations)
set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated)
foreach(path IN ITEMS bisect-costs merge-face-matching families/hub-goes families/spoke-flips)
  list(APPEND corpus_files ${corpus}/${path}.json)
  get_filename_component(name ${path} NAME)
  string(REPLACE - _ header ${name})
  list(APPEND corpus_headers ${generated}/include/restrip/tables/operations/${header}.hpp)
endforeach()
add_custom_command(
  OUTPUT ${corpus_headers}
  COMMAND restrip-generate rules --operation ${corpus_files} --max-k 6 --out ${generated}
  DEPENDS restrip-generate ${corpus_files}
  VERBATIM)
add_executable(print_operations print_operations.cpp ${corpus_headers})
target_include_directories(print_operations PRIVATE ${RESTRIP_TABLES_DIR}/include ${generated}/include)
target_link_libraries(print_operations PRIVATE restrip_own_flags restrip_brief_runs)

# The program itself: each shipped operation, as shown by --help for one; and options that conflict.
function(operation_program_test name expected)
  add_test(NAME verify.operations.program.${name} COMMAND restrip-verify ${ARGN})
  set_tests_properties(verify.operations.program.${name} PROPERTIES PASS_REGULAR_EXPRESSION "${expected}")
endfunction()
file(GLOB shipped CONFIGURE_DEPENDS RELATIVE ${RESTRIP_TABLES_DIR}/operations ${RESTRIP_TABLES_DIR}/operations/*.json)
list(LENGTH shipped shipped_count)
if(shipped_count LESS 10)
  message(FATAL_ERROR "${RESTRIP_TABLES_DIR}/operations has ${shipped_count} operations only")
endif()
foreach(file IN LISTS shipped)  # the certificate and the compiled table
  string(REPLACE .json "" name ${file})
  set(${name} --operation ${RESTRIP_TABLES_DIR}/operations/${name}.json --certificate
              ${RESTRIP_TABLES_DIR}/certificates/operations/${name}.cert)
  string(REPLACE - _ header ${name})
  operation_program_test(shipped.${name} "\nverified: .*/${name}.json: .* answers of the table, " ${${name}}
                         --header ${RESTRIP_TABLES_DIR}/include/restrip/tables/operations/${header}.hpp --dump-command "$<TARGET_FILE:print_operations> ${name}")
endforeach()
operation_program_test(json "\"verified\": true" ${bisect} --json -)
operation_program_test(wrong_certificate "merge.cert:2: expected \"operation bisect\"" --operation
                       ${RESTRIP_TABLES_DIR}/operations/bisect.json --certificate
                       ${RESTRIP_TABLES_DIR}/certificates/operations/merge.cert)
operation_program_test(nothing_to_check "--operation needs --certificate, --header or, of a family, --dump-command" --operation
                       ${RESTRIP_TABLES_DIR}/operations/bisect.json)
operation_program_test(without_operation "--certificate requires --operation" --certificate
                       ${RESTRIP_TABLES_DIR}/certificates/operations/bisect.cert)
set(tables ${RESTRIP_TABLES_DIR}/include/restrip/tables/operations)
operation_program_test(failing_dump "found the end.*NOT verified: " --operation ${RESTRIP_TABLES_DIR}/operations/bisect.json --header
                       ${tables}/bisect.hpp --dump-command false)
operation_program_test(dump_that_cannot_be_run "no-such-program: cannot be run\n$" --operation ${RESTRIP_TABLES_DIR}/operations/bisect.json
                       --header ${tables}/bisect.hpp --dump-command no-such-program)
operation_program_test(unread_header "--dump-command with --operation needs --header" ${bisect} --dump-command true)
operation_program_test(other_header "was not run.*NOT verified: " --operation ${RESTRIP_TABLES_DIR}/operations/bisect.json --header
                       ${tables}/merge.hpp --dump-command "$<TARGET_FILE:print_operations> bisect")
foreach(other IN ITEMS --tables-dir=tables --family=split --headers)
  string(REGEX REPLACE "=.*" "" option ${other})
  operation_program_test(excludes${option} "--operation excludes ${option}|${option} excludes --operation" ${bisect} ${other})
endforeach()
foreach(file IN LISTS corpus_files)
  get_filename_component(name ${file} NAME_WE)
  string(REPLACE - _ header ${name})
  set(max_k "")
  if(file MATCHES "operations/families/")
    set(max_k --max-k 6)
  endif()
  operation_program_test(compiled.${name} "\nverified: .*/${name}.json: .* answers of the table, " --operation ${file} ${max_k}
                         --certificate ${generated}/certificates/operations/${name}.cert --header
                         ${generated}/include/restrip/tables/operations/${header}.hpp --dump-command
                         "$<TARGET_FILE:print_operations> ${name}")
endforeach()
operation_program_test(header_of_fewer_positions "expected .*, 14, [0-9]+, [0-9]+> spoke_flips.*was not run.*NOT verified: " --operation ${corpus}/families/spoke-flips.json
                       --max-k 7 --header ${generated}/include/restrip/tables/operations/spoke_flips.hpp --dump-command
                       "$<TARGET_FILE:print_operations> spoke-flips")
operation_program_test(other_table "line 2: (expected \"operation merge\", found \"operation bisect\"|\"table bisect\" is not a table)" --operation
                       ${RESTRIP_TABLES_DIR}/operations/merge.json --header ${tables}/merge.hpp --dump-command "$<TARGET_FILE:print_operations> bisect")

# The schema agrees with the reader.
if(RESTRIP_LONG_TESTS AND NOT RESTRIP_SANITIZE)
  file(GLOB schema_files ${RESTRIP_TABLES_DIR}/operations/*.json ${corpus}/*.json ${corpus}/families/*.json
                         ${PROJECT_SOURCE_DIR}/examples/*.json)
  add_test(NAME verify.operations.schema
           COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/schema_test.py ${PROJECT_SOURCE_DIR}/docs/operation.schema.json
                   $<TARGET_FILE:restrip-verify> ${CMAKE_CURRENT_BINARY_DIR}/schema 9 ${schema_files})
  file(GLOB small_certificates ${RESTRIP_CORPUS_DIR}/accept/small/certificates/*.cert)
  add_test(NAME verify.operations.reasons_by_script
           COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/reasons_test.py ${reasons_script}
                   $<TARGET_FILE:restrip-generate> ${RESTRIP_TABLES_DIR} ${corpus} ${CMAKE_CURRENT_BINARY_DIR}/reasons
                   ${small_certificates})
endif()
