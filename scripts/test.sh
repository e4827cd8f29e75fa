#!/usr/bin/env bash
# Sets this machine up, builds everything and runs every test. Safe to repeat. The logs of what runs in the background are in
# build/logs.
set -Eeuo pipefail
cd "$(dirname "$0")/.."
source scripts/setup.sh

need "${build_packages[@]}" "${test_packages[@]}" "${bench_packages[@]}"
need_clang

logs=build/logs
mkdir -p "$logs"
rm -f "$logs"/*

# part NAME COMMAND…: runs the command and notes how long it took.
part() {
  say "$1"
  local started=$SECONDS
  "${@:2}"
  printf '%6d s  %s\n' $((SECONDS - started)) "$1" >>"$logs/parts"
}

# beside NAME COMMAND…: the same in the background, with what is left of the processors.
beside() {
  say "in the background: $1"
  set -m  # a process group of its own, so that all of it can be stopped
  (
    trap - ERR EXIT
    part "$1 (in the background)" nice "${@:2}"
  ) >"$logs/background" 2>&1 &
  background=$!
  set +m
}

# joined: waits for what runs in the background; it must have succeeded.
joined() {
  [ -n "$background" ] || return 0
  say "waiting for what runs in the background (log: $logs/background)"
  local pid=$background
  background=
  wait "$pid" || { tail -n 40 "$logs/background" >&2; false; }
}
background=
trap '[ -z "$background" ] || kill -- "-$background" 2>/dev/null' EXIT

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

check_format() { git ls-files '*.cpp' '*.hpp' '*.c' '*.h' ':!tables/include' ':!generator/languages/templates' ':!tests/generator/languages' | xargs "$1" --dry-run --Werror; }
format=$(style_tool clang-format) tidy=$(style_tool clang-tidy)
if [ -n "$format" ]; then
  part "checking the format of the sources" check_format "$format"
else
  leave_out "the format of the sources: clang-format $style_version is not there, and other versions disagree"
fi

# The preset test has the benchmarks as well: bench.quick_run shows that each of them runs and that their page can be rendered.
say "configuring"
cmake --preset test >/dev/null
cmake --preset sanitize >/dev/null
part "building with GCC" cmake --build --preset test

# No test file is forgotten: each is compiled, but for those that a test compiles itself.
mapfile -t units < <(find build/test -name 'unity_*.cxx')
for source in $(git ls-files 'tests/*.cpp' ':!tests/cross/consumer' ':!tests/cross/toolkit/main.cpp' ':!tests/generator/wide_tables.cpp' ':!tests/runtime/mesh/lacks_a_member.cpp'); do
  grep -qF "/$source\"" build/test/compile_commands.json "${units[@]}" || { echo "test.sh: no test has $source" >&2; false; }
done

# Where generator and verifier exhaust something, sanitizers would take minutes for each; smaller tests run the same code. So
# would the real meshes. This build is also the one that shows Clang compiles us.
too_long='ShippedRows|Targeted|EveryCrime|EveryFlipped|SatEncoding.(Every|Models)|SatProofs.(The|Controls|EveryLine)|shards|tables.fresh'
beside "building with Clang and its sanitizers" cmake --build --preset sanitize
part "testing" ctest --preset test -j "$(nproc)"
joined
if [ -n "$tidy" ]; then
  beside "running clang-tidy" scripts/tidy.py "$tidy"
else
  leave_out "clang-tidy: version $style_version is not there, and other versions disagree"
fi
# Two callers of each allocation are kept, and not thirty, which takes a sixth of the time.
part "testing with sanitizers" env -u RESTRIP_MESHES ASAN_OPTIONS=malloc_context_size=2 ctest --preset sanitize -j "$(nproc)" -E "$too_long"
joined

# A test that wants something which is not there is skipped and counted; with RESTRIP_MESHES set nothing may be skipped but what
# needs a network.
say "counting what was skipped"
grep -h '^left out: ' build/test/Testing/Temporary/LastTest.log >"$logs/left_out" || true
sed -nE "s/^\[  SKIPPED \] (.*) \([0-9]+ ms\)\$/skipped: \1/p" build/test/Testing/Temporary/LastTest.log >"$logs/skipped"
cat "$logs/skipped"
[ -z "${RESTRIP_MESHES:-}" ] || [ ! -s "$logs/skipped" ]

say "all tests passed"
cat "$logs/parts"
printf '%6d s  in all\n' $SECONDS
echo "not part of this run: Coq (scripts/prove.sh)"
cat "$logs/left_out"
[ ! -s "$logs/skipped" ] ||
  echo "$(wc -l <"$logs/skipped") tests were skipped: set RESTRIP_MESHES to a folder with the real meshes (CONTRIBUTING.md)"
