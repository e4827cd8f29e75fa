#!/usr/bin/env bash
# README's program with restrip.hpp and restrip.cpp alone: by GCC and Clang, without exceptions and RTTI, with hidden symbols; for
# Windows it is compiled.
#   two_files.sh ZIP MAIN EXPECTED CLANG   in an empty folder
set -euo pipefail
python3 -m zipfile -e "$1" .
sed 's/^#include <restrip\/.*>$/#include "restrip.hpp"/' "$2" >main.cpp
tried() {
  echo "$*"
  "$@" main.cpp restrip.cpp -o program
  ./program | diff "$expected" - || exit 1
}
expected=$3
common=(-std=c++20 -O0 -Wall -Wextra -Werror)
tried g++ "${common[@]}"
tried g++ "${common[@]}" -fno-exceptions -fno-rtti -fvisibility=hidden
tried "$4" "${common[@]}"
if command -v x86_64-w64-mingw32-g++ >/dev/null; then
  echo x86_64-w64-mingw32-g++
  x86_64-w64-mingw32-g++ -std=c++20 -O0 main.cpp restrip.cpp -o program.exe
else
  echo "left out: the two files for Windows: MinGW is not installed"
fi
