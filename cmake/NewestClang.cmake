# RESTRIP_CLANG: the newest Clang of this machine, or the one that the environment names (scripts/setup.sh). It compiles
# code for browsers. As a toolchain file, for the presets of Clang, this file makes it the compiler of everything else as well.
set(names $ENV{RESTRIP_CLANG})
foreach(version RANGE 40 14 -1)
  list(APPEND names clang++-${version})
endforeach()
find_program(RESTRIP_CLANG NAMES ${names} clang++)
# For WebAssembly. Version 20 renamed the target: older versions do not know the new name, and newer ones warn about the old one.
set(RESTRIP_WASM_TARGET --target=wasm32-wasi -Wno-deprecated)
if(CMAKE_TOOLCHAIN_FILE STREQUAL CMAKE_CURRENT_LIST_FILE AND RESTRIP_CLANG)
  set(CMAKE_CXX_COMPILER ${RESTRIP_CLANG})
  string(REPLACE clang++ clang CMAKE_C_COMPILER ${RESTRIP_CLANG})
endif()
