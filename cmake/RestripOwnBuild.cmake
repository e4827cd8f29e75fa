# Compiler settings of this project's programs and tests. Users of the library do not get them.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

option(RESTRIP_SANITIZE "Address and undefined-behaviour sanitizers" OFF)
option(RESTRIP_WARNINGS_AS_ERRORS "A warning of the compiler is an error" OFF)
option(RESTRIP_ALLOW_MISSING "Leave tests out whose packages are missing, instead of stopping" ON)

# restrip_without(PACKAGE LEFT_OUT): call it if a package was not found. The presets for development require every package.
function(restrip_without package left_out)
  if(NOT RESTRIP_ALLOW_MISSING)
    message(FATAL_ERROR "${package} is missing. Install it, or configure with -DRESTRIP_ALLOW_MISSING=ON and do without: ${left_out}")
  endif()
  message(STATUS "left out: ${left_out}: ${package} is missing")
endfunction()

option(RESTRIP_STATIC "Programs contain fmt and nauty, whose versions differ from release to release of a system" OFF)
find_package(fmt REQUIRED)
if(RESTRIP_STATIC)  # Debian has no static library of fmt
  set_target_properties(fmt::fmt PROPERTIES INTERFACE_COMPILE_DEFINITIONS FMT_HEADER_ONLY)
  add_link_options(LINKER:--as-needed)
endif()
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(Threads REQUIRED)

add_library(restrip_own_flags INTERFACE)
# Makes floating-point results, and so simplified meshes, the same on every processor.
target_compile_options(restrip_own_flags INTERFACE -ffp-contract=off)
target_compile_options(restrip_own_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion)
if(NOT CMAKE_UNITY_BUILD)
  target_compile_options(restrip_own_flags INTERFACE -Wshadow)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # in shared units, a local name may also occur in another file
  target_compile_options(restrip_own_flags INTERFACE -Wshadow=local)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  target_compile_options(restrip_own_flags INTERFACE -Wreserved-identifier)
  # Clang 20 and later report deprecated functions that std::stable_sort of GCC 12's library calls.
  target_compile_options(restrip_own_flags INTERFACE -Wno-deprecated-declarations)
endif()
if(RESTRIP_WARNINGS_AS_ERRORS)
  target_compile_options(restrip_own_flags INTERFACE -Werror)
endif()
if(RESTRIP_SANITIZE)
  target_compile_options(restrip_own_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(restrip_own_flags INTERFACE -fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/sanitizer-ignore.txt)
  endif()
  target_link_options(restrip_own_flags INTERFACE -fsanitize=address,undefined)
endif()

# For programs that take longer to compile than to run. With sanitizers -O1 takes Clang three times as long as -O0.
add_library(restrip_brief_runs INTERFACE)
target_compile_options(restrip_brief_runs INTERFACE $<IF:$<CONFIG:Debug>,-O0,-O1>)

# Files that parse a command line are not critical for speed, but CLI11 takes the compiler half a minute at -O3.
add_library(restrip_command_line INTERFACE)
find_package(CLI11 REQUIRED)
target_link_libraries(restrip_command_line INTERFACE CLI11::CLI11 restrip_brief_runs)

find_path(NAUTY_INCLUDE_DIR nauty/nauty.h REQUIRED)
if(RESTRIP_STATIC)
  set(static libnauty.a)
endif()
find_library(NAUTY_LIBRARY NAMES ${static} nauty REQUIRED)
add_library(restrip_nauty INTERFACE)
target_include_directories(restrip_nauty SYSTEM INTERFACE ${NAUTY_INCLUDE_DIR})
target_link_libraries(restrip_nauty INTERFACE ${NAUTY_LIBRARY})
