#!/usr/bin/env bash
# Runs clang-tidy over every room but the tests. All sources of a target are one unit, because most of the time goes into headers
# that each of them includes; units are configured in build/tidy (the preset tidy), where nothing is built.
set -euo pipefail
[ $# -eq 0 ] || { echo "usage: tidy.sh (no arguments)" >&2; exit 2; }
cd "$(dirname "$0")/.."

cmake --preset tidy >/dev/null
mapfile -t sources < <(git ls-files {c,files,generator,runtime,verify,tools,examples,bench,web}/'*.cpp' ':!verify/formal')
commands=build/tidy/compile_commands.json
mapfile -t units < <(sed -nE 's/^ *"file": "(.*)",?$/\1/p' "$commands" | sort -u)
[ ${#units[@]} -gt 0 ] || { echo "tidy.sh: $commands names no file" >&2; exit 1; }
for source in "${sources[@]}"; do
  grep -qF "/$source\"" "$commands" "${units[@]}" || { echo "tidy.sh: no unit has $source" >&2; exit 1; }
done
# What the one check would say that units must do without.
if grep -nE '^ *# *include.*\.cpp[">]' -- "${sources[@]}"; then
  echo "tidy.sh: a source is included" >&2
  exit 1
fi

# The largest first, so that no processor waits for one at the end.
wc -l "${units[@]}" | sort -rn | awk '$2 ~ /\.c/ { printf "%s%c", $2, 0 }' |
  xargs -0 -P "$(nproc)" -n 1 clang-tidy-14 --quiet --checks=-bugprone-suspicious-include -p build/tidy
echo "clang-tidy: ${#sources[@]} sources in ${#units[@]} units"
