#!/usr/bin/env bash
# Sets this machine up, builds, generates the tables anew and proves them, then keeps a mesh's strips through a whole
# level-of-detail replay. Argument: a mesh (OBJ, PLY, OFF, STL); without one a built-in closed mesh. Safe to repeat.
set -Eeuo pipefail
[ $# -eq 0 ] || mesh=$(realpath -e -- "$1") || { echo "demo.sh: $1: no such file" >&2; exit 2; }
cd "$(dirname "$0")/.."
source scripts/setup.sh

need "${build_packages[@]}" "${web_packages[@]}"

say "building"
cmake --preset programs >/dev/null
cmake --build --preset programs --target restrip-generate restrip-dump-tables restrip-verify restrip

bin=build/programs/bin
say "generating the tables by exhaustive search, and comparing them with those checked in"
rm -rf build/demo
$bin/restrip-generate tables --out build/demo/tables --threads "$(nproc)"
for part in include certificates MANIFEST; do diff -r --exclude="*format.hpp" "build/demo/tables/$part" "tables/$part"; done
echo "every byte is the same"

say "proving every rule sound and optimal, with a program that shares no code with the generator"
$bin/restrip-verify --tables-dir tables --dump-command $bin/restrip-dump-tables

say "replaying a mesh from 2 % to 100 % of its triangles, strips kept by the rules"
if [ -n "${mesh:-}" ]; then
  $bin/restrip stats "$mesh"
  $bin/restrip replay "$mesh" --base 0.02
else
  $bin/restrip replay --built-in --base 0.02
fi
cat <<'END'
For comparison: the paper (Porcu, Sanna, Scateni), which has rules for 4-vertices and lets the new triangles of every other
split inherit colours, reports an isolated triangle in 52.7 % of the splits of its teapot and 51.5 % of those of its bunny.
END

say "making the pages: a viewer, and an atlas of all rules"
cmake --build --preset programs --target web
echo "open them in a browser: file://$PWD/build/programs/web/index.html"
