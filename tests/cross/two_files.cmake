# Compiles two_files.cpp with restrip.hpp and restrip.cpp of FOLDER, by COMPILER with FLAGS, every warning an error. With
# REFERENCE, the program is also linked and run, by LAUNCHER if the machine cannot run it itself. It must print the same as
# the program REFERENCE, and refuse an invalid colouring with the message of the library.
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
separate_arguments(launcher UNIX_COMMAND "${LAUNCHER}")
list(APPEND flags -std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror -I ${FOLDER})
if(COMPILER MATCHES "clang")  # Clang 20 and later report deprecated functions that std::stable_sort of GCC 12's library calls
  list(APPEND flags -Wno-deprecated-declarations)
endif()
set(sources ${SOURCE} ${FOLDER}/restrip.cpp)
if(NOT DEFINED REFERENCE)
  execute_process(COMMAND ${COMPILER} ${flags} -fsyntax-only ${sources} COMMAND_ERROR_IS_FATAL ANY)
  return()
endif()
execute_process(COMMAND ${COMPILER} ${flags} ${sources} -o ${PROGRAM} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${REFERENCE} OUTPUT_VARIABLE expected COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${launcher} ${PROGRAM} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
if(expected STREQUAL "" OR NOT printed STREQUAL expected)
  message(FATAL_ERROR "printed:\n${printed}\nexpected, from ${REFERENCE}:\n${expected}")
endif()
execute_process(COMMAND ${launcher} ${PROGRAM} invalid RESULT_VARIABLE result OUTPUT_VARIABLE printed ERROR_VARIABLE sentence)
if(result EQUAL 0 OR NOT sentence MATCHES "restrip: the colouring is not valid: a triangle has three solid dual edges")
  message(FATAL_ERROR "a colouring that is not valid: ended with ${result}\n${printed}${sentence}")
endif()
