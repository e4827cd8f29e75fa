#!/usr/bin/env bash
# Runs clang-tidy over every room but the tests, as many files at a time as there are processors. Argument: a build directory
# with compile_commands.json, configured with -DRESTRIP_BUILD_BENCH=ON.
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t sources < <(git ls-files {generator,runtime,verify,replay,bench}/'*.cpp' ':!verify/formal')
# For a file that it does not find there, clang-tidy would take the options of one with a similar name.
for source in "${sources[@]}"; do
  grep -qF "/$source\"" "$1/compile_commands.json" || { echo "tidy.sh: $1 does not build $source" >&2; exit 1; }
done
printf '%s\0' "${sources[@]}" | xargs -0 -P "$(nproc)" -n 1 clang-tidy-14 --quiet -p "$1"
