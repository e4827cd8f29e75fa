#!/usr/bin/env bash
# Runs clang-tidy over what others build on: generator, runtime, verifier, as many at a time as there are processors. Argument: a build directory with compile_commands.json.
set -euo pipefail
cd "$(dirname "$0")/.."
git ls-files 'generator/*.cpp' 'runtime/*.cpp' 'verify/*.cpp' ':!verify/formal' |
  xargs -P "$(nproc)" -n 1 clang-tidy-14 --quiet -p "$1"
