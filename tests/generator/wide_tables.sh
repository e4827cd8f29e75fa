#!/bin/sh
# Writes the tables up to k = 9, compiles their headers and queries them exhaustively for k = 9. Then queries the C
# tables of splits and flips like the C++ look-ups, up to k = 9; collapses with a chord are most of all questions.
#   wide_tables.sh restrip-generate COMPILER RUNTIME_INCLUDE TABLES_INCLUDE wide_tables.cpp C_COMPILER DUMP SCRATCH
set -eu
generate=$1 compiler=$2 include=$3 format=$4 source=$5 c_compiler=$6 dump=$7 scratch=$8
rm -rf "$scratch" "$scratch.c"
"$generate" tables --max-k 9 --threads 2 --language c++ --language c --out "$scratch"
mkdir "$scratch.c"
mv "$scratch"/restrip_tables* "$scratch.c"  # the folder is to hold what its MANIFEST lists
cpp="-std=c++20 -O1 -Wall -Wextra -Werror -I $scratch/include -I $include -I $format"
"$compiler" $cpp "$source" -o "$scratch.program"
"$scratch.program"
echo '#include "dump_output.hpp"
int main() { return restrip::dump::digests(9, "06") ? 0 : 1; }' >"$scratch.c/answers.cpp"
"$compiler" $cpp -I "$dump" "$scratch.c/answers.cpp" "$dump/dump_digests.cpp" -o "$scratch.c/answers"
"$c_compiler" -std=c99 -O1 -Wall -Wextra -Werror "$scratch.c/restrip_tables_check.c" -o "$scratch.c/in_c"
"$scratch.c/answers" >"$scratch.c/answers.txt"
"$scratch.c/in_c" 9 06 >"$scratch.c/in_c.txt"
cmp "$scratch.c/answers.txt" "$scratch.c/in_c.txt"
grep -q '^0 9 4 0 ' "$scratch.c/in_c.txt"
