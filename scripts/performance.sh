#!/usr/bin/env bash
# Measures the figures of docs/results.md and writes that page again. A full run takes about a quarter of an hour and
# three gigabytes; without RESTRIP_MESHES (a folder with bunny.obj and dragon_vrip.ply) only made meshes are measured.
#
#   scripts/performance.sh                    measure all, into build/performance; then docs/results.md
#   scripts/performance.sh --only level       measure this program again and render; may be repeated
#   scripts/performance.sh --short            a third of the time: no mesh of more than a million triangles, less repetition
#   scripts/performance.sh --quick            small meshes, seconds; the page goes to build/performance-quick
#   --bin DIR                                 programs that have been built already
#   --out DIR                                 where the JSON goes
#   --tristripper DIR                         the sources of rm_tristripper (include/, src/), which is measured as well if given
set -Eeuo pipefail
cd "$(dirname "$0")/.."
source scripts/setup.sh

quick=() short='' bin='' out='' tristripper='' only=()
while [ $# -gt 0 ]; do
  case "$1" in
    --quick) quick=(--quick) ;;
    --short) short=yes ;;
    --bin) bin=${2:?--bin wants a folder}; shift ;;
    --out) out=${2:?--out wants a folder}; shift ;;
    --tristripper) tristripper=$(realpath "${2:?--tristripper wants a folder}"); shift ;;
    --only) only+=("${2:?--only wants a program: level, replay, scale}"); shift ;;
    *) sed -n '2,12s/^# \{0,1\}//p' "$0"; [ "$1" = --help ] && exit 0; echo "performance.sh: unknown: $1" >&2; exit 2 ;;
  esac
  shift
done
out=${out:-build/performance${quick:+-quick}}
programs=(level replay scale)
[ ${#only[@]} -gt 0 ] || only=("${programs[@]}")
for name in "${only[@]}"; do
  [[ " ${programs[*]} " == *" $name "* ]] || { echo "performance.sh: unknown program: $name; there are ${programs[*]}" >&2; exit 2; }
done

if [ -z "$bin" ]; then
  need "${build_packages[@]}" "${bench_packages[@]}"
  need_clang
  say "building"
  cmake --preset release -DRESTRIP_BUILD_BENCH=ON -DRESTRIP_ALLOW_MISSING=ON -DRM_TRISTRIPPER="$tristripper" >/dev/null
  [ -n "$tristripper" ] || echo "rm_tristripper is left out: --tristripper names its sources"
  cmake --build --preset release
  bin=build/release/bin
fi
mkdir -p "$out"

# Medians of several repetitions, interleaved over all benchmarks of a program, so that a slow minute affects all alike.
mixed=(--benchmark_repetitions=5 --benchmark_enable_random_interleaving=true) which=()
if [ -n "$short" ]; then mixed[0]=--benchmark_repetitions=3 which=(--benchmark_filter='-dragon|scale/[0-9]{8}/|scale/[3-9][0-9]{6}/'); fi
[ ${#quick[@]} -eq 0 ] || { mixed=(--benchmark_repetitions=1 --benchmark_min_time=0.01); export RESTRIP_BENCH_QUICK=1; }
for name in "${only[@]}"; do
  say "measuring: $name"
  case $name in
    scale) how=() ;;  # one mesh at a time, repeated inside
    *) how=("${mixed[@]}") ;;
  esac
  "$bin/bench_$name" "${how[@]}" "${which[@]}" --benchmark_out="$out/$name.json.partial" --benchmark_out_format=json >"$out/$name.log" 2>&1 ||
    { cat "$out/$name.log" >&2; false; }
  mv "$out/$name.json.partial" "$out/$name.json"
done

say "writing the page"
if [ ${#quick[@]} -gt 0 ]; then page=$out; else page=docs; fi
bench/render.py --json "$out" --out "$page"
echo "$page/results.md"
