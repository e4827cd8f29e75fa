#!/usr/bin/env bash
# Sets this machine up, builds everything and runs every test. Safe to repeat.
set -Eeuo pipefail
cd "$(dirname "$0")/.."
source scripts/setup.sh

need "${build_packages[@]}" "${test_packages[@]}" "${bench_packages[@]}"

# RESTRIP_MESHES may name a folder of packed meshes (*.xz); they are unpacked into the build folder.
if compgen -G "${RESTRIP_MESHES:-}/*.xz" >/dev/null; then
  say "unpacking the meshes of RESTRIP_MESHES"
  packed_folder=$RESTRIP_MESHES
  RESTRIP_MESHES=$PWD/build/meshes
  mkdir -p "$RESTRIP_MESHES/bad"
  for packed in "$packed_folder"/*.xz "$packed_folder"/bad/*.xz; do
    unpacked=$RESTRIP_MESHES/${packed#"$packed_folder"/}
    unpacked=${unpacked%.xz}
    [ -e "$unpacked" ] || { xz -dc "$packed" >"$unpacked.partial" && mv "$unpacked.partial" "$unpacked"; }
  done
fi
[ -z "${RESTRIP_MESHES:-}" ] || export RESTRIP_MESHES
[ -n "${RESTRIP_MESHES:-}" ] || echo "RESTRIP_MESHES is not set: tests on downloaded meshes will be skipped"

say "checking the format of the sources"
git ls-files '*.cpp' '*.hpp' ':!tables/include' | xargs clang-format-14 --dry-run --Werror

# The benchmarks as well: bench.quick_run shows that each of them runs and that their page can be rendered.
say "building with GCC (release)"
cmake --preset release -DRESTRIP_BUILD_BENCH=ON >/dev/null
cmake --build --preset release

say "testing (release)"
ctest --preset release -j "$(nproc)"

# The verifier's two exhaustive mutation tests take minutes when instrumented, and run the same code as the others. GCC's
# sanitizers raise a false warning inside Boost.Graph, so this build is also the one that shows Clang compiles us.
say "building and testing with Clang and its address and undefined-behaviour sanitizers"
cmake --preset sanitize >/dev/null
cmake --build --preset sanitize
ctest --preset sanitize -j "$(nproc)" -E 'BitFlips|Targeted'

# With the commands of the release build, which has the benchmarks.
say "running clang-tidy"
scripts/tidy.sh build/release

echo "== all tests passed"
