#!/bin/sh
# Writes the tables up to k = 9, compiles their headers and asks them everything about k = 9.
#   wide_tables.sh restrip-generate COMPILER RUNTIME_INCLUDE TABLES_INCLUDE wide_tables.cpp SCRATCH
set -eu
generate=$1 compiler=$2 include=$3 format=$4 source=$5 scratch=$6
rm -rf "$scratch"
"$generate" tables --max-k 9 --threads 2 --out "$scratch"
"$compiler" -std=c++20 -O1 -Wall -Wextra -Werror -I "$scratch/include" -I "$include" -I "$format" "$source" -o "$scratch.program"
"$scratch.program"
