#!/usr/bin/env bash
# Sets this machine up, builds restrip and tests it. Safe to repeat; the logs are in build/logs.
#
#   scripts/test.sh         shows that the project works on this machine: unit tests, tables generated again and proved,
#                           the packages for C, Python and JavaScript. With one compiler; six minutes on two processors
#   scripts/test.sh --all   also the other compiler with its sanitizers, clang-tidy, the format of the sources, deliberate
#                           faults, the fuzzer, every command of the documents, the tutorials, users' builds, the pages in
#                           a browser, all languages of the generator, benchmarks, Debian packages, and the demo on the
#                           newest stable Debian: 40 minutes
#
# Both leave out what this machine lacks and list it at the end.
set -Eeuo pipefail
all=
case "${1:-}" in
  '') ;;
  --all) all=yes ;;
  *) sed -n '2,11s/^# \{0,1\}//p' "$0"; [ "$1" = --help ] && exit 0; echo "test.sh: unknown: $1" >&2; exit 2 ;;
esac
cd "$(dirname "$0")/.."
source scripts/setup.sh

need "${build_packages[@]}" "${test_packages[@]}" ${all:+"${all_packages[@]}" "${bench_packages[@]}"}
need_clang

logs=build/logs
mkdir -p "$logs"
rm -f "$logs"/*

# part NAME COMMAND…: runs the command and records its time.
part() {
  say "$1"
  local started=$SECONDS
  "${@:2}"
  printf '%6d s  %s\n' $((SECONDS - started)) "$1" >>"$logs/parts"
}

# in_background JOB NAME COMMAND…: the same in the background, on the remaining processors; the log is $logs/JOB.
declare -A background=()
in_background() {
  say "in the background: $2"
  set -m  # a separate process group, so that all of it can be stopped
  (
    trap - ERR EXIT
    part "$2 (in the background)" nice "${@:3}"
  ) >"$logs/$1" 2>&1 &
  background[$1]=$!
  set +m
}

# joined JOB: waits for a background job, which must have succeeded or, with 77, found that it cannot be done here.
joined() {
  say "waiting for a background job (log: $logs/$1)"
  local pid=${background[$1]} code=0
  wait "$pid" || code=$?
  unset "background[$1]"
  case $code in
    0) ;;
    77) leave_out "$(tail -n 1 "$logs/$1")" ;;
    *) tail -n 40 "$logs/$1" >&2; false ;;
  esac
}
trap 'for pid in "${background[@]}"; do kill -KILL -- "-$pid" 2>/dev/null || true; done' EXIT

# RESTRIP_MESHES may name a folder of packed meshes (*.xz); they are unpacked into the build folder.
if compgen -G "${RESTRIP_MESHES:-}/*.xz" >/dev/null; then
  need xz-utils
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

# On a release with all packages, CMake must not miss anything either.
options=(-DRESTRIP_ALLOW_MISSING=OFF)
[ ${#left_out[@]} -eq 0 ] || options=(-DRESTRIP_ALLOW_MISSING=ON)

# The commands of README on another release, from nothing. The folder is kept: remove it for a machine without packages.
[ -z "$all" ] || in_background debian "the demo on the newest stable Debian" scripts/fresh_machine.sh stable build/debian-stable scripts/demo.sh --pages

say "configuring"
if [ -n "$all" ]; then
  cmake --preset test "${options[@]}" -DRESTRIP_WARNINGS_AS_ERRORS=ON -DRESTRIP_LONG_TESTS=ON -DRESTRIP_BUILD_BENCH=ON >"$logs/configure"
  cmake --preset sanitize "${options[@]}" >"$logs/configure-sanitize"
  # Other versions of these tools disagree.
  format=$(style_tool clang-format) tidy=$(style_tool clang-tidy)
  check_format() { git ls-files '*.cpp' '*.hpp' '*.c' '*.h' ':!tables/include' ':!generator/emit/templates' ':!tests/generator/languages' | xargs "$format" --dry-run --Werror; }
  if [ -n "$format" ]; then
    part "checking the format of the sources" check_format
  else
    leave_out "the format of the sources: clang-format $style_version is not there, and other versions disagree"
  fi
else
  # An unknown compiler may emit new warnings: that is not a fault of this machine.
  cmake --preset test "${options[@]}" -DRESTRIP_WARNINGS_AS_ERRORS=OFF -DRESTRIP_LONG_TESTS=OFF -DRESTRIP_BUILD_BENCH=OFF >"$logs/configure"
fi
part "building" cmake --build --preset test

# No test file is forgotten: each is compiled, except those that a test compiles itself.
if [ -n "$all" ]; then
  mapfile -t units < <(find build/test -name 'unity_*.cxx')
  for source in $(git ls-files 'tests/*.cpp' ':!tests/cross/consumer' ':!tests/cross/toolkit/main.cpp' ':!tests/generator/wide_tables.cpp'); do
    grep -qF "/$source\"" build/test/compile_commands.json "${units[@]}" || { echo "test.sh: no test has $source" >&2; false; }
  done
  in_background sanitize "building with Clang and its sanitizers" cmake --build --preset sanitize
fi
part "testing" ctest --preset test -j "$(nproc)"
[ -z "$all" ] || part "proving without Coq" scripts/prove.sh --no-coq --compare --programs build/test/bin
if [ -n "$all" ]; then
  joined sanitize
  if [ -n "$tidy" ]; then
    in_background tidy "running clang-tidy" scripts/tidy.py "$tidy"
  else
    leave_out "clang-tidy: version $style_version is not there, and other versions disagree"
  fi
  # Sanitizers would take minutes for each exhaustive part of generator and verifier; smaller tests run the same code.
  # The same is true of the real meshes. Two callers of each allocation are kept instead of thirty, which takes a sixth
  # of the time.
  too_long='EveryCrime|EveryFlipped|tables.fresh'
  part "testing with sanitizers" env -u RESTRIP_MESHES ASAN_OPTIONS=malloc_context_size=2 ctest --preset sanitize -j "$(nproc)" -E "$too_long"
  [ -z "$tidy" ] || joined tidy
  joined debian
fi

# Reports what was left out: packages, parts that CMake left out, skipped tests. With RESTRIP_MESHES set, only tests
# that need a network may be skipped.
say "counting what was left out"
log=build/test/Testing/Temporary/LastTest.log
{
  [ ${#left_out[@]} -eq 0 ] || printf '%s\n' "${left_out[@]}"
  sed -n 's/^-- \(left out: .*\)/\1/p' "$logs/configure"
  grep -h '^left out: ' "$log" || true
} >"$logs/left_out"
sed -nE "s/^\[  SKIPPED \] (.*) \([0-9]+ ms\)\$/skipped: \1/p" "$log" >"$logs/skipped"
cat "$logs/skipped"
[ -z "${RESTRIP_MESHES:-}" ] || [ ! -s "$logs/skipped" ]

say "all tests passed"
cat "$logs/parts"
printf '%6d s  in all\n' $SECONDS
[ -n "$all" ] || echo "not part of this run: the additions of scripts/test.sh --all (see its first lines)"
echo "not part of this run: Coq (scripts/prove.sh)"
cat "$logs/left_out"
[ ! -s "$logs/skipped" ] ||
  echo "$(wc -l <"$logs/skipped") tests were skipped: set RESTRIP_MESHES to a folder with the real meshes (CONTRIBUTING.md)"
