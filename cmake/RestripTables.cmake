# Tables made in a user's build: restrip_generate_tables() and restrip_verify_tables(). docs/how-to/cmake.md is the manual.
#
# Set the global property RESTRIP_VERSION before including this file. Afterwards define the programs as targets
# restrip::generate, restrip::verify and restrip::dump-tables: programs for this machine, from the same build or imported.
# An installed package and a subdirectory both use this file.
include_guard(GLOBAL)

# The largest fans that the generator makes, and that the verifier judges.
set_property(GLOBAL PROPERTY RESTRIP_LARGEST_FAN 13)
set_property(GLOBAL PROPERTY RESTRIP_LARGEST_VERIFIED_FAN 10)
# The largest first number of a position in the table of a custom family.
set_property(GLOBAL PROPERTY RESTRIP_LARGEST_OWN_FAMILY 10)
# The languages that the generator writes.
set_property(GLOBAL PROPERTY RESTRIP_LANGUAGES c c++ glsl json rust wgsl)

set(RESTRIP_HOST_PROGRAMS "" CACHE PATH "Folder of restrip-generate and the other programs, to run on this machine")

# _restrip_import_programs(WHY): imports the programs as they are found; WHY is what is missing, or empty.
function(_restrip_import_programs why)
  set(${why} "" PARENT_SCOPE)
  foreach(name IN ITEMS generate verify dump-tables)
    if(TARGET restrip::${name})
      continue()
    endif()
    set(program "program-NOTFOUND")
    if(RESTRIP_HOST_PROGRAMS)
      find_program(program restrip-${name} PATHS ${RESTRIP_HOST_PROGRAMS} NO_CACHE NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
    else()
      find_program(program restrip-${name} NO_CACHE NO_CMAKE_FIND_ROOT_PATH)
    endif()
    if(NOT program)
      set(${why} "restrip-${name} was not found; install restrip with its programs, or name their folder by RESTRIP_HOST_PROGRAMS"
          PARENT_SCOPE)
      return()
    endif()
    add_executable(restrip::${name} IMPORTED GLOBAL)
    set_target_properties(restrip::${name} PROPERTIES IMPORTED_LOCATION ${program})
  endforeach()
  # Detects a program for another machine or of another version before the build starts.
  get_target_property(program restrip::generate IMPORTED_LOCATION)
  if(NOT program)  # as written by install(EXPORT)
    get_target_property(configurations restrip::generate IMPORTED_CONFIGURATIONS)
    list(GET configurations 0 configuration)
    get_target_property(program restrip::generate IMPORTED_LOCATION_${configuration})
  endif()
  get_property(version GLOBAL PROPERTY RESTRIP_VERSION)
  execute_process(COMMAND ${program} --version OUTPUT_VARIABLE found RESULT_VARIABLE result ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT result EQUAL 0)
    set(${why} "${program} does not run on this machine; name the folder of programs that do by RESTRIP_HOST_PROGRAMS" PARENT_SCOPE)
  elseif(NOT found STREQUAL version)
    set(${why} "${program} has version ${found}, these headers have ${version}; name the folder of programs of the same version by RESTRIP_HOST_PROGRAMS"
        PARENT_SCOPE)
  endif()
endfunction()

# _restrip_check_programs(CALLER): stops unless programs for this machine exist.
function(_restrip_check_programs caller)
  if(NOT TARGET restrip::generate)
    message(FATAL_ERROR "${caller}: the target restrip::generate is missing. With a package: find_package(restrip COMPONENTS generator). "
                        "As a subdirectory: set RESTRIP_BUILD_GENERATOR, or name the folder of installed programs by RESTRIP_HOST_PROGRAMS")
  endif()
  get_target_property(imported restrip::generate IMPORTED)
  if(CMAKE_CROSSCOMPILING AND NOT imported AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    message(FATAL_ERROR "${caller}: this build makes programs for another machine; name the folder of programs of this "
                        "machine by RESTRIP_HOST_PROGRAMS")
  endif()
endfunction()

# restrip_generate_tables(TARGET t [MAX_K n] [LANGUAGE name…] [OPERATION file…])
function(restrip_generate_tables)
  set(known "TARGET, MAX_K, LANGUAGE, OPERATION")
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET;MAX_K" "LANGUAGE;OPERATION")
  if(DEFINED arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "restrip_generate_tables: ${arg_UNPARSED_ARGUMENTS}: unknown; known are ${known}")
  endif()
  if(DEFINED arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "restrip_generate_tables: ${arg_KEYWORDS_MISSING_VALUES}: a value must follow")
  endif()
  if(NOT DEFINED arg_TARGET)
    message(FATAL_ERROR "restrip_generate_tables: TARGET is missing: the name of the library to be made")
  endif()
  if(TARGET ${arg_TARGET})
    message(FATAL_ERROR "restrip_generate_tables: TARGET ${arg_TARGET}: there is a target of this name")
  endif()
  _restrip_check_programs(restrip_generate_tables)
  # Operations alone leave the shipped tables in place.
  set(with_tables TRUE)
  if(DEFINED arg_OPERATION AND NOT DEFINED arg_MAX_K)
    set(with_tables FALSE)
  endif()
  set(options "")
  set(max_k "")
  if(DEFINED arg_MAX_K)
    set(max_k --max-k=${arg_MAX_K})
  else()
    set(arg_MAX_K 8)
  endif()
  get_property(largest GLOBAL PROPERTY RESTRIP_LARGEST_FAN)
  if(NOT arg_MAX_K MATCHES "^[0-9]+$" OR arg_MAX_K LESS 3 OR arg_MAX_K GREATER largest)
    message(FATAL_ERROR "restrip_generate_tables: MAX_K ${arg_MAX_K}: expected a number from 3 to ${largest}, the triangles of "
                        "the largest fans in the tables; larger fans are answered without a table")
  endif()
  list(APPEND options --max-k ${arg_MAX_K})
  get_property(languages GLOBAL PROPERTY RESTRIP_LANGUAGES)
  foreach(language IN LISTS arg_LANGUAGE)
    if(NOT language IN_LIST languages)
      list(JOIN languages ", " expected)
      message(FATAL_ERROR "restrip_generate_tables: LANGUAGE ${language}: expected one of ${expected}")
    endif()
  endforeach()
  if(DEFINED arg_LANGUAGE)
    list(REMOVE_ITEM arg_LANGUAGE c++)  # is always made
  endif()

  set(operations "")
  set(own "")  # the descriptions of operations
  foreach(file IN LISTS arg_OPERATION)
    get_filename_component(file ${file} ABSOLUTE)
    if(NOT EXISTS ${file})
      message(FATAL_ERROR "restrip_generate_tables: OPERATION ${file}: file not found")
    endif()
    list(APPEND operations ${file})
    list(APPEND own --operation=${file})
    _restrip_is_family(${file} is_family)
    get_property(largest GLOBAL PROPERTY RESTRIP_LARGEST_OWN_FAMILY)
    if(is_family AND arg_MAX_K GREATER largest)
      message(FATAL_ERROR "restrip_generate_tables: MAX_K ${arg_MAX_K}: ${file} describes a family, whose table has positions "
                          "up to ${largest}; make it in a separate TARGET, without MAX_K")
    endif()
    if(is_family AND NOT max_k IN_LIST own)
      list(APPEND own ${max_k})
    endif()
  endforeach()

  # A file with the options, since Make does not rebuild when a command changes.
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/restrip/${arg_TARGET})
  list(JOIN options " " content)
  file(CONFIGURE OUTPUT ${folder}.options CONTENT "${content} ${arg_LANGUAGE} ${operations}\n" @ONLY)
  set(made "")
  set(commands "")  # for other languages
  set(check "")
  set(other_languages ${arg_LANGUAGE})
  if(arg_LANGUAGE)
    list(TRANSFORM arg_LANGUAGE PREPEND --language=)
  endif()
  if(with_tables)
    set(headers automaton collapse flip rows split)
    list(TRANSFORM headers REPLACE "(.+)" "${folder}/include/restrip/tables/\\1.hpp")
    add_custom_command(
      OUTPUT ${folder}.stamp  # unchanged files keep their time
      BYPRODUCTS ${folder}/MANIFEST ${headers}
      COMMAND restrip::generate tables --out ${folder} --threads 0 ${options}
      COMMAND ${CMAKE_COMMAND} -E touch ${folder}.stamp
      DEPENDS ${folder}.options $<TARGET_FILE:restrip::generate>
      COMMENT "Generating the tables of ${arg_TARGET}"
      VERBATIM)
    list(APPEND made ${folder}.stamp)
    list(APPEND commands COMMAND restrip::generate tables --out ${folder}-languages --threads 0 ${options} ${arg_LANGUAGE})
    if(--language=c IN_LIST arg_LANGUAGE)
      set(check ${folder}-languages/restrip_tables_check.c)
    endif()
  endif()
  if(operations)
    list(APPEND commands COMMAND restrip::generate rules --out ${folder}-languages ${own} ${arg_LANGUAGE})
  endif()
  # Other languages have a separate folder, because the MANIFEST lists everything in the folder of the tables.
  if(arg_LANGUAGE)
    add_custom_command(
      OUTPUT ${folder}-languages.stamp
      BYPRODUCTS ${check}
      ${commands}
      COMMAND ${CMAKE_COMMAND} -E touch ${folder}-languages.stamp
      DEPENDS ${folder}.options ${operations} $<TARGET_FILE:restrip::generate>
      COMMENT "Generating the tables of ${arg_TARGET} in other languages"
      VERBATIM)
    list(APPEND made ${folder}-languages.stamp)
  endif()
  if(operations)
    add_custom_command(
      OUTPUT ${folder}-operations.stamp
      COMMAND restrip::generate rules --out ${folder}-operations ${own}
      COMMAND ${CMAKE_COMMAND} -E touch ${folder}-operations.stamp
      DEPENDS ${folder}.options ${operations} $<TARGET_FILE:restrip::generate>
      COMMENT "Generating the operations of ${arg_TARGET}"
      VERBATIM)
    list(APPEND made ${folder}-operations.stamp)
  endif()
  add_custom_target(${arg_TARGET}_files DEPENDS ${made})
  add_library(${arg_TARGET} INTERFACE)
  add_dependencies(${arg_TARGET} ${arg_TARGET}_files)
  # The compiled library has the shipped tables.
  target_link_libraries(${arg_TARGET} INTERFACE $<IF:$<BOOL:${with_tables}>,restrip::rules,restrip::restrip>)
  set_target_properties(${arg_TARGET} PROPERTIES RESTRIP_FOLDER ${folder} RESTRIP_OF_FANS ${with_tables} RESTRIP_MAX_K ${arg_MAX_K}
                                                 RESTRIP_C_CHECK "${check}" RESTRIP_OPERATIONS "${operations}"
                                                 RESTRIP_OTHER_LANGUAGES "${other_languages}")
  if(with_tables)
    # Targets that link this search its folder before the shipped tables: see runtime/CMakeLists.txt.
    set_target_properties(${arg_TARGET} PROPERTIES INTERFACE_RESTRIP_TABLES ${folder}/include INTERFACE_RESTRIP_BODIES headers)
  endif()
  if(arg_LANGUAGE)
    target_include_directories(${arg_TARGET} INTERFACE ${folder}-languages)
  endif()
  if(operations)
    target_include_directories(${arg_TARGET} INTERFACE ${folder}-operations/include)
  endif()
endfunction()

# _restrip_is_family(FILE OUT): whether an operation file describes a family. CMake runs again if the file changes.
function(_restrip_is_family file out)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} text)
  string(JSON list ERROR_VARIABLE error GET "${text}" operations)
  if(NOT error)
    message(FATAL_ERROR "restrip_generate_tables: OPERATION ${file}: describes a list; give each operation a separate file")
  endif()
  string(JSON numbers ERROR_VARIABLE error GET "${text}" numbers)
  set(${out} TRUE PARENT_SCOPE)
  if(error)
    set(${out} FALSE PARENT_SCOPE)
  endif()
endfunction()

# _restrip_verify_operation(t FILE FOLDER): adds a test of one operation's certificate and compiled table.
function(_restrip_verify_operation target file folder)
  file(READ ${file} text)
  string(JSON name ERROR_VARIABLE error GET "${text}" name)
  if(error)
    message(FATAL_ERROR "restrip_verify_tables: ${target}: ${file}: ${error}")
  endif()
  # The name goes into a program before the generator or the verifier has read the file.
  if(NOT name MATCHES "^[a-z][a-z0-9]*(-[a-z0-9]+)*$")
    message(FATAL_ERROR "restrip_verify_tables: ${target}: ${file}: the name is not one of lower-case letters, digits and "
                        "single hyphens between them, a letter first")
  endif()
  string(REPLACE - _ identifier ${name})
  set(dump "")
  if(NOT CMAKE_CROSSCOMPILING OR CMAKE_CROSSCOMPILING_EMULATOR)
    set(program ${target}_dump_${identifier})
    file(CONFIGURE OUTPUT ${folder}-operations.dump/${identifier}.cpp CONTENT
"#include \"restrip/tables/operation_dump.hpp\"
#include \"restrip/tables/operations/@identifier@.hpp\"
int main() { return restrip::tables::print_dump(\"@name@\", restrip::tables::@identifier@_rules); }
" @ONLY)
    add_executable(${program} ${folder}-operations.dump/${identifier}.cpp)
    target_link_libraries(${program} PRIVATE ${target})
    _restrip_command_of(${program} command)
    set(dump --dump-command ${command})
  endif()
  set(max_k "")
  _restrip_is_family(${file} is_family)
  if(is_family)
    get_target_property(max_k ${target} RESTRIP_MAX_K)
    set(max_k --max-k ${max_k})
  endif()
  # The names that the generator gives to certificates.
  string(JSON certificate ERROR_VARIABLE error GET "${text}" certificate)
  if(error)
    set(certificate ${name})
  endif()
  set(header --header ${folder}-operations/include/restrip/tables/operations/${identifier}.hpp)
  set(verify $<TARGET_FILE:restrip::verify> --operation ${file} ${max_k}
             --certificate ${folder}-operations/certificates/operations/${certificate}.cert ${header})
  add_test(NAME ${target}.operation.${name} COMMAND ${verify} ${dump})
  # A program in each language that this machine compiles or runs prints the answers of the look-up.
  get_target_property(languages ${target} RESTRIP_OTHER_LANGUAGES)
  foreach(language IN LISTS languages)
    _restrip_print_command(${language} ${folder}-languages/restrip_check_of_${identifier} command)
    if(command)
      add_test(NAME ${target}.operation.${name}.${language} COMMAND ${verify} --dump-command ${command})
    else()
      message(STATUS "restrip_verify_tables: ${target}: no program here runs ${language}, so its look-up of ${name} is not judged; install a compiler or interpreter of ${language} and configure again")
    endif()
  endforeach()
endfunction()

# _restrip_print_command(LANGUAGE PROGRAM OUT): how a shell makes and runs a program of the generator, PROGRAM.c or .rs or
# .mjs; empty if it cannot here. Shaders need the user's device.
function(_restrip_print_command language program out)
  find_program(RESTRIP_NODE NAMES node nodejs NO_CMAKE_FIND_ROOT_PATH)
  find_program(RESTRIP_RUSTC rustc NO_CMAKE_FIND_ROOT_PATH)
  set(command "")
  if(language STREQUAL json AND RESTRIP_NODE)
    set(command "'${RESTRIP_NODE}' '${program}.mjs'")
  elseif(language STREQUAL rust AND RESTRIP_RUSTC)
    set(command "'${RESTRIP_RUSTC}' -O '${program}.rs' -o '${program}-rust' && '${program}-rust'")
  elseif(language STREQUAL c AND CMAKE_C_COMPILER AND NOT CMAKE_CROSSCOMPILING)
    set(command "'${CMAKE_C_COMPILER}' -O1 '${program}.c' -o '${program}-c' && '${program}-c'")
  endif()
  set(${out} "${command}" PARENT_SCOPE)
endfunction()

# _restrip_command_of(PROGRAM OUT): how a shell runs a program of this build.
function(_restrip_command_of program out)
  set(command ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:${program}>)
  list(TRANSFORM command REPLACE "(.+)" "'\\1'")
  list(JOIN command " " command)
  set(${out} ${command} PARENT_SCOPE)
endfunction()

# restrip_verify_tables(t)
function(restrip_verify_tables target)
  if(ARGC GREATER 1)
    message(FATAL_ERROR "restrip_verify_tables: ${ARGN}: unknown; the name of one target is all that it takes")
  endif()
  set(folder folder-NOTFOUND)
  if(TARGET ${target})
    get_target_property(folder ${target} RESTRIP_FOLDER)
  endif()
  if(NOT folder)
    message(FATAL_ERROR "restrip_verify_tables: ${target}: is not a target that restrip_generate_tables() made")
  endif()
  _restrip_check_programs(restrip_verify_tables)
  get_target_property(operations ${target} RESTRIP_OPERATIONS)
  foreach(file IN LISTS operations)
    _restrip_verify_operation(${target} ${file} ${folder})
  endforeach()
  get_target_property(with_tables ${target} RESTRIP_OF_FANS)
  if(NOT with_tables)
    return()
  endif()
  get_target_property(max_k ${target} RESTRIP_MAX_K)
  get_property(largest GLOBAL PROPERTY RESTRIP_LARGEST_VERIFIED_FAN)
  if(max_k GREATER largest)
    message(FATAL_ERROR "restrip_verify_tables: ${target}: has MAX_K ${max_k}, and the verifier judges fans of up to ${largest} triangles")
  endif()

  # A program of this build prints the answers of the compiled headers, if it can be run.
  set(dump "")
  set(automaton_dump "")
  if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    message(STATUS "restrip_verify_tables: ${target}: the compiled tables are not judged; for that set CMAKE_CROSSCOMPILING_EMULATOR")
  else()
    set(sources ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/dump)
    if(NOT EXISTS ${sources}/dump_tables.cpp)  # not installed: restrip is a subdirectory
      set(sources ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../tables/dump)
    endif()
    add_executable(${target}_dump ${sources}/dump_automaton.cpp ${sources}/dump_digests.cpp ${sources}/dump_tables.cpp)
    target_link_libraries(${target}_dump PRIVATE ${target})
    _restrip_command_of(${target}_dump command)
    set(dump --dump-command ${command})
    set(automaton_dump --dump-command "${command} --automaton")
    # Also compares the answers of the C tables, by digests, if the project has a C compiler. The verifier compares up to k = 8.
    get_target_property(check ${target} RESTRIP_C_CHECK)
    get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
    if(check AND C IN_LIST languages AND max_k LESS_EQUAL 8)
      add_executable(${target}_check_c ${check})
      set_source_files_properties(${check} PROPERTIES GENERATED TRUE)
      add_dependencies(${target}_check_c ${target}_files)
      _restrip_command_of(${target}_check_c command)
      list(APPEND dump --digest-command ${command})
    endif()
  endif()
  add_test(NAME ${target}.rules COMMAND $<TARGET_FILE:restrip::verify> --tables-dir ${folder} --max-k ${max_k} ${dump})
  add_test(NAME ${target}.automaton
           COMMAND $<TARGET_FILE:restrip::verify> automaton --tables-dir ${folder} --tables-max-k ${max_k} --max-k 8
                   ${automaton_dump})
endfunction()
