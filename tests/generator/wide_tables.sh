#!/bin/sh
# Writes the tables up to k = 9, compiles their headers and asks them everything about k = 9.
#   wide_tables.sh restrip-generate COMPILER RUNTIME_INCLUDE wide_tables.cpp SCRATCH
set -eu
generate=$1 compiler=$2 include=$3 source=$4 scratch=$5
rm -rf "$scratch"
"$generate" tables --max-k 9 --threads 2 --out "$scratch"
"$compiler" -std=c++20 -O1 -Wall -Wextra -Werror -I "$scratch/include" -I "$include" "$source" -o "$scratch/wide_tables"
"$scratch/wide_tables"
