#!/usr/bin/env bash
# Proves every shipped rule in Coq, from the bytes that ship. Safe to repeat, from any directory.
#
#   verify/formal/prove.sh           the theorems; coqchk for the theory, the flips, and the boundary of fans of every size
#                                    (all but the tables of the fans and the larger sets of classes)
#   verify/formal/prove.sh --full    coqchk for everything: an hour or more, without the virtual machine
#
# Prints the shipped tables and the certificates as Coq files into build/formal, compiles them with the theory of
# verify/formal, and requires Coq to report for each theorem that it assumes nothing.
set -Eeuo pipefail
cd "$(dirname "$0")/../.."
source scripts/setup.sh

full=no
if [ "${1:-}" = "--full" ]; then
  full=yes
  shift
fi
if [ $# -ne 0 ]; then
  echo "usage: prove.sh [--full]" >&2
  exit 2
fi
root=$PWD
out=$root/build/formal
certificates=(split collapse)
started=$SECONDS

need "${build_packages[@]}" coq make python3 time

say "building restrip-dump-tables"
cmake --preset programs >/dev/null
cmake --build --preset programs --target restrip-dump-tables >/dev/null

say "printing the tables and the certificates"
mkdir -p "$out/coq" "$out/fresh"
rm -f "$out"/fresh/*.v
build/programs/bin/restrip-dump-tables >"$out/tables.dump"
python3 verify/formal/print_coq.py tables "$out/fresh" <"$out/tables.dump" >"$out/printed"
build/programs/bin/restrip-dump-tables --automaton --max-k 7 >"$out/automaton.dump"
python3 verify/formal/print_coq.py automaton "$out/fresh" <"$out/automaton.dump"
for family in "${certificates[@]}"; do
  python3 verify/formal/print_coq.py rows "$out/fresh" <"tables/certificates/$family.cert"
done
cp verify/formal/*.v "$out/fresh/"

# Only changed files are copied, so that a second run compiles nothing twice; removed files are deleted.
cd "$out/coq"
for old in *.v; do
  [ -e "../fresh/$old" ] || rm -f "${old%.v}".*
done
for new in ../fresh/*.v; do
  cmp -s "$new" "$(basename "$new")" || cp "$new" .
done

say "compiling the proofs (log: $out/compile.log)"
coq_makefile -R . Restrip -o Makefile ./*.v >/dev/null
objects=()
for file in *.v; do
  [ "$file" = Main.v ] || objects+=("${file%.v}.vo")
done
if ! make -j "$(nproc)" TIMED=1 "${objects[@]}" >"$out/compile.log" 2>&1; then
  grep -B 2 -A 12 -m 1 '^Error' "$out/compile.log" >&2 || tail -n 20 "$out/compile.log" >&2
  false
fi
# Files and seconds of processor time, kept from run to run: unchanged files are not compiled again.
touch "$out/seconds"
sed -n 's/^\([A-Za-z_]*\)\.vo (.*user: \([0-9.]*\),.*/\1 \2/p' "$out/compile.log" >"$out/seconds.new"
awk '!seen[$1]++' "$out/seconds.new" "$out/seconds" >"$out/seconds.all"
mv "$out/seconds.all" "$out/seconds"

say "checking what the theorems assume (log: $out/assumptions.log)"
coqc -R . Restrip Main.v >"$out/assumptions.log"
mapfile -t theorems < <(sed -n 's/^Theorem \([a-z_]*\).*/\1/p' Main.v)
mapfile -t printed < <(sed -n 's/^Print Assumptions \([a-z_]*\)\.$/\1/p' Main.v)
mapfile -t said <"$out/assumptions.log"
if [ ${#theorems[@]} -eq 0 ] || [ "${theorems[*]}" != "${printed[*]}" ] || [ ${#said[@]} -ne ${#theorems[@]} ]; then
  echo "Main.v: Print Assumptions does not follow each theorem, or Coq printed something else" >&2
  false
fi
for line in "${said[@]}"; do
  if [ "$line" != "Closed under the global context" ]; then
    echo "a theorem assumes something: $line" >&2
    false
  fi
done

say "extracting the decisions of restrip-check"
mkdir -p "$out/extracted"
rm -f "$out/extracted"/*
cp "$root/verify/check/Extract.v" "$out/extracted/"
(cd "$out/extracted" && coqc -R ../coq Restrip Extract.v)
for file in judge.{ml,mli}; do
  if ! cmp "$out/extracted/$file" "$root/verify/check/$file"; then
    echo "verify/check/$file is not what Coq extracts from Check.v; copy $out/extracted/$file there" >&2
    false
  fi
done

# Compares what the printer has read, family by family, with the subjects of the theorems.
printf '%s\n' 'From Coq Require Import NArith List.' 'From Restrip Require Import Answers.' 'Set Printing Width 1000.' 'Eval vm_compute in counts.' \
  'From Restrip Require Positions AutomatonNumbers.' 'Eval vm_compute in (list_max (map fst Positions.arcs),' \
  '  list_max (map (fun d => hd 0 (snd (fst d))) AutomatonNumbers.digests))%nat.' >"$out/counts.v"
(cd "$out" && coqc -R coq Restrip counts.v) >"$out/counts"
mapfile -t proved < <(grep -o '[0-9]*%N' "$out/counts" | paste - - | tr -d 'N%')
mapfile -t printed < <(cat "$out/printed")
read -r told looked_up < <(sed -nE 's/^ *= \(([0-9]+), ([0-9]+)\)$/\1 \2/p' "$out/counts")
if [ ${#proved[@]} -eq 0 ] || [ ${#proved[@]} -ne ${#printed[@]} ]; then
  echo "the theorems cover ${#proved[@]} families, the dump has ${#printed[@]}" >&2
  false
fi
for i in "${!proved[@]}"; do
  read -r family positions answers <<<"${printed[i]}"
  if [ "$positions"$'\t'"$answers" != "${proved[i]}" ]; then
    echo "$family: the dump has $positions positions and $answers answers, the theorems cover ${proved[i]}" >&2
    false
  fi
done

# took FILE…: the total seconds of the files.
took() {
  awk -v files=" $* " 'index(files, " " $1 " ") { sum += $2 } END { printf "%.0f", sum }' "$out/seconds"
}
say "coqchk (log: $out/coqchk.log)"
checking=$SECONDS
modules=(Restrip.Locality Restrip.Strips Restrip.Rows Restrip.Symmetry Restrip.Sequences Restrip.WholeMesh Restrip.LowerBound Restrip.Flip
  Restrip.EveryFan Restrip.Check Restrip.Step Restrip.Facts Restrip.EveryBoundary Restrip.Served Restrip.Telling)
[ "$full" = no ] || modules=(Restrip.Main)
coqchk -silent -o -R . Restrip "${modules[@]}" >"$out/coqchk.log" 2>&1
grep -q '^\* Axioms: <none>' "$out/coqchk.log"
checked=$((SECONDS - checking))

printf '\n%-34s %8s  %s\n' theorem seconds "what it assumes"
for i in "${!theorems[@]}"; do
  theorem=${theorems[i]}
  case $theorem in
    locality) files=(Graph Locality) ;;
    valid_is_stripped) files=(Graph Strips) ;;
    rules_right | even_gaps | rows_say_the_same)
      files=(Tables_{split,collapse,open_split,open_collapse,boundary_split,boundary_collapse} Rows_{split,collapse}
        Split Collapse OpenSplit OpenCollapse BoundarySplit BoundaryCollapse Shipped)
      ;;
    flip_right) files=(Tables_flip Flip) ;;
    every_rule_right)
      files=(Frontier Fold Route EveryFan Serves Entries Classes Closure Facts Parity EverySplit EveryCollapse EveryOpen EveryBoundary EverySize)
      ;;
    automaton_serves | automaton_inside)
      files=(Arcs Rings Closings Header Kinds Bounds Ends Meetings Played Neighbours Keys Walks WalkFamilies WalkOpen Served Automaton)
      ;;
    sequences_right | every_sequence_right | strips_counted) files=(Sequences EverySize) ;;
    operation_met) files=(Met) ;;
    correct_tables_*) files=(EverySize) ;;
    whole_mesh*) files=(WholeMesh) ;;
    every_rule_pays | one_strip_* | no_rule_competes) files=(LowerBound) ;;
    judge_step_right) files=(Graph Strips Step) ;;
    judge_* | chosen_is_safe) files=(Labels Check) ;;
    automaton_*) files=(Automaton) ;;
    answers) files=(Answers) ;;
    answers_tell) files=(Changes_{split,collapse,open_split,open_collapse,boundary_split,boundary_collapse,flip} Marks Telling Changes) ;;
    wrong_told_refused) files=(ChangesRejects) ;;
    every_counts) files=(EveryFigures) ;;
    valid_* | costing_*) files=(Figures) ;;
    wrong_automata_refused) files=(AutomatonRejects) ;;
    wrong_* | careless_*) files=(Rejects) ;;
    *) files=() ;;
  esac
  printf '%-34s %8s  %s\n' "$theorem" "$(took "${files[@]}")" "${said[i]}"
done
printf '%-34s %8s  %s\n' coqchk "$checked" "no axioms: ${modules[*]}"
printf '\n%-26s %8s %12s  %s\n' "answers of the headers" positions proved "which positions"
sum=0
for line in "${printed[@]}"; do
  read -r family positions answers <<<"$line"
  case $family in
    split | collapse) which="k = 3 ... 8, 1 <= a < k" ;;
    open_*) which="k = 1 ... 8, gaps 0 <= i < j <= k" ;;
    boundary_*) which="k = 1 ... 8, gap 0 <= i <= k" ;;
    *) which="" ;;
  esac
  printf '%-26s %8s %12s  %s\n' "$family" "$positions" "$answers" "$which"
  sum=$((sum + answers))
done
printf '%-26s %8s %12s  %s\n\n' all "" "$sum" "every position"
echo "the stated changes of answers were compared for k <= $told"
echo "the automaton's answers and their stated changes were compared for k <= $looked_up"
echo "Theorems about the same files share one run; its seconds are shown for each."
echo "All proved in $((SECONDS - started)) s; read: certificates, compiled tables, numbers of the compiled automaton"
