#!/usr/bin/env bash
# Runs the four checks of docs/explanation/what-is-proven.md: the definition (search, automaton, operations), reasons, a
# recorded run, and Coq. Prints one page. Safe to repeat, from any directory.
#
#   scripts/prove.sh [--no-coq | --full] [--programs DIR] [--compare]
#
#   --no-coq         all but Coq, whose rows stay as they were recorded
#   --full           also coqchk for all theorems
#   --programs DIR   with the programs of this folder; otherwise they are built into build/programs
#   --compare        writes nothing: docs/coverage.csv and the table must be what the reports say
#
# Installs (Debian, Ubuntu, where they are missing): a C++ compiler, CMake, the packages of the programs, Python, OCaml;
# for Coq also coq, make and time.
# Writes: build/programs, logs in build/proof; docs/coverage.csv and the table in docs/explanation/what-is-proven.md.
# Takes: --no-coq two minutes, Coq some fifteen minutes of processor time, --full an hour or more; building comes first.
set -Eeuo pipefail
cd "$(dirname "$0")/.."
source scripts/setup.sh

coq=yes
coq_options=()
bin=
compare=
while [ $# -gt 0 ]; do
  case "$1" in
    -h | --help) sed -n '2,/^set /{/^set /d; s/^# \{0,1\}//; p}' "$0"; exit 0 ;;
    --no-coq) coq=no ;;
    --full) coq_options=(--full) ;;
    --compare) compare=yes ;;
    --programs) bin=${2:?--programs needs a folder}; shift ;;
    *)
      echo "usage: prove.sh [--no-coq | --full] [--programs DIR] [--compare]" >&2
      exit 2
      ;;
  esac
  shift
done

packages=("${build_packages[@]}" python3 ocaml)
[ "$coq" = no ] || packages+=(coq make time)
need "${packages[@]}"

scripts/coverage.py check
if [ -z "$bin" ]; then
  say "building"
  cmake --preset programs >/dev/null
  cmake --build --preset programs >/dev/null
  bin=build/programs/bin
fi
logs=build/proof
mkdir -p "$logs"
summary=()
checks=()

# check NAME CLAIM METHOD TRUSTS CASES COMMAND…: runs the command; CASES is a sed expression that finds the number of cases
# in its output.
check() {
  local name=$1 claim=$2 method=$3 trusts=$4 cases=$5
  shift 5
  say "$name: $method (log: $logs/$name.log)"
  local started=$SECONDS
  if ! "$@" >"$logs/$name.log" 2>&1; then
    tail -n 20 "$logs/$name.log" >&2
    false
  fi
  local found
  found=$(sed -nE "$cases" "$logs/$name.log" | tail -n 1)
  [ -n "$found" ] || { echo "$logs/$name.log: the number of cases is missing" >&2; false; }
  scripts/coverage.py read "$logs" "$name"
  checks+=("$name")
  summary+=("$(printf '%-9s %5d s  %s\n%19s%s: %s\n%19strusts: %s' \
    "$name" "$((SECONDS - started))" "$claim" "" "$method" "$found" "" "$trusts")")
}

# For each shipped operation: certificate, text of the header, compiled table.
all_operations() {
  local file name identifier
  for file in tables/operations/*.json; do
    name=$(basename "$file" .json)
    identifier=${name//-/_}
    printf '#include "restrip/tables/%s"\n' operation_dump.hpp "operations/$identifier.hpp" >"$logs/$name.cpp"
    echo "int main() { return restrip::tables::print_dump(\"$name\", restrip::tables::${identifier}_rules); }" >>"$logs/$name.cpp"
    c++ -std=c++20 -O2 -I tables/include "$logs/$name.cpp" -o "$logs/$name.dump" || return
    $bin/restrip-verify --operation "$file" --certificate "tables/certificates/operations/$name.cert" \
      --header "tables/include/restrip/tables/operations/$identifier.hpp" --dump-command "$logs/$name.dump" || return
  done
  echo "in all: $(ls tables/operations/*.json | wc -l) operations"
}

# Random operations on a sheet, inside and on its boundary, by the rules alone.
a_run() {
  awk 'BEGIN { n = 60; for (i = 0; i < n * n; ++i) print "v", i % n, int(i / n), i * i % 7 / 7
               for (i = 0; i < n * n - n; ++i) if (i % n != n - 1) print "f", i + 1, i + 2, i + n + 2 "\nf", i + 1, i + n + 2, i + n + 1 }' \
    >"$logs/sheet.obj"
  $bin/restrip replay "$logs/sheet.obj" --repeats 0 --policy rules --walk 100000 --trace "$logs/sheet.trace" || return
  $bin/restrip-check "$logs/sheet.trace"
}

all_reasons() {
  python3 scripts/check_reasons.py tables/certificates/*.cert | tee /dev/stderr |
    awk '/ rules are / { rules += $2; copies += $(NF - 2) }
         END { printf "in all: %d rules, %d copies\n", rules, copies }'
}

# The long parts come last, so that a report that is not as expected is noticed early.
check operations "the rules of the operation files are sound and optimal; the shipped headers give them" \
  "every recolouring of every configuration on explicit graphs, in every world outside" \
  "C++ compiler, verify/, docs/reference/operation-file.md" \
  's/^in all: (.*)$/\1/p' \
  all_operations
check run "the rules as a program applied them: every colouring valid, every number true, every operation optimal" \
  "each operation of a run followed in a mesh of raw triangles; patches judged by functions extracted from Coq" \
  "Coq's extraction, the OCaml compiler, verify/check: the mesh and the walk along strips" \
  's/^accepted: (.*)$/\1/p' \
  a_run
check automaton "every answer of the automaton is sound and optimal, for every k; the shipped header holds its numbers" \
  "every colouring of short arcs, every pair of the finitely many kinds of arcs; whole fans to k = 10 as well" \
  "C++ compiler, verify/automaton, the interface lemma of docs/explanation/automaton.md" \
  's/^verified: (.*)$/\1/p' \
  $bin/restrip-verify automaton --tables-dir tables --dump-command "$bin/restrip-dump-tables --automaton"
check reasons "every rule in the certificates is sound and optimal" \
  "the certificates' reasons, without any search" \
  "Python, scripts/check_reasons.py" \
  's/^in all: (.*)$/\1/p' \
  all_reasons
check search "every rule is sound and optimal; the shipped headers give it, in every position" \
  "the definition, in Boost.Graph: every recolouring of every configuration, in every world outside" \
  "C++ compiler, verify/" \
  's/^verified: (.*)$/\1/p' \
  $bin/restrip-verify --dump-command $bin/restrip-dump-tables
if [ "$coq" = yes ]; then
  check theorem "sound, optimal, the facts, the locality lemma itself, and the bound on the strips of a whole mesh" \
    "Coq, for the shipped bytes; no axioms" \
    "Coq's kernel, the printer of the tables, verify/formal/Statements.v" \
    's/^All proved in (.*)$/&/p' \
    verify/formal/prove.sh "${coq_options[@]}"
  sed -n '/^theorem /,$p' "$logs/theorem.log"
fi

printf '\nThe checks that were run, and what each trusts.\n\n'
printf '%s\n\n' "${summary[@]}"
if [ -n "$compare" ]; then
  say "comparing the coverage"
  scripts/coverage.py compare "$logs" "${checks[@]}"
else
  say "writing the coverage"
  scripts/coverage.py record "$logs" "${checks[@]}"
fi
scripts/figures.py ${compare:+--check} --bin "$bin" --only scripts/coverage.py docs/explanation/what-is-proven.md
scripts/coverage.py check
echo
scripts/coverage.py table
echo
if [ "$coq" = no ]; then echo "Coq: not run, its rows are as recorded."; fi
echo "All checks that were run passed, $SECONDS s. What must still be trusted: docs/explanation/what-is-proven.md."
