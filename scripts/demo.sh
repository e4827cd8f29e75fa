#!/usr/bin/env bash
# Installs the packages it needs, as root or with sudo (Debian, Ubuntu), builds restrip in build/programs, generates the tables
# again, proves them, and maintains the strips of a mesh through a whole level-of-detail replay. Safe to repeat; the first
# run takes about three minutes on two processors.
#
#   scripts/demo.sh [MESH]            MESH: an OBJ, PLY, OFF, STL or glTF file; without one, a built-in closed mesh
#   scripts/demo.sh --pages [MESH]    also makes the pages for a browser: a viewer, an atlas of all rules, and this
#                                     documentation. Clang for WebAssembly is installed; two minutes more
set -Eeuo pipefail
pages=
case "${1:-}" in
  --help) sed -n '2,8s/^# \{0,1\}//p' "$0"; exit 0 ;;
  --pages) pages=yes; shift ;;
  -*) echo "demo.sh: unknown: $1; --help explains" >&2; exit 2 ;;
esac
[ $# -eq 0 ] || mesh=$(realpath -e -- "$1" 2>/dev/null) || { echo "demo.sh: $1: no such file" >&2; exit 2; }
cd "$(dirname "$0")/.."
source scripts/setup.sh

need "${build_packages[@]}"
[ -z "$pages" ] || { need "${page_packages[@]}"; need_clang; }

say "building"
configured=$(cmake --preset programs)
cmake --build --preset programs
bin=build/programs/bin

say "generating the tables by exhaustive search, and comparing them with those checked in"
tables=build/programs/demo/tables
rm -rf "$tables"
"$bin/restrip-generate" tables --out "$tables" --threads "$(nproc)"
mapfile -t files < <(cd "$tables" && find . -type f ! -name MANIFEST)  # the one of tables/ also lists handwritten files
for file in "${files[@]}"; do cmp "$tables/$file" "tables/$file"; done
echo "every byte of ${#files[@]} files is the same"

say "proving that every rule is sound and that none which keeps its ports is better, with a program that shares only common/ with the generator"
"$bin/restrip-verify" --tables-dir tables --dump-command "$bin/restrip-dump-tables"

say "replaying a mesh from 2 % to 100 % of its triangles, strips kept by the default policy"
if [ -n "${mesh:-}" ]; then
  "$bin/restrip" stats "$mesh"
  "$bin/restrip" replay "$mesh" --base 0.02 --repeats 1
else
  "$bin/restrip" replay --built-in --base 0.02 --repeats 1
fi
echo "docs/results.md compares with other libraries, docs/explanation/paper.md with the rules of the paper."

if [ -z "$pages" ]; then
  echo "scripts/demo.sh --pages also makes pages for a browser, in which the strips of a mesh are kept while its detail changes."
  exit 0
fi
if without=$(grep 'no target `web`' <<<"$configured"); then
  leave_out "the pages: ${without#-- }"
  exit 0
fi
say "making the pages: a viewer, and an atlas of all rules"
cmake --build --preset programs --target web
echo "open them in a browser: file://$PWD/build/programs/web/index.html"
