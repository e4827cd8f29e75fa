#!/bin/sh
# The verifier proves the generator's output: operations of the corpus, with all kinds of costs, constraints and ports given
# up.
#   generated.sh GENERATOR VERIFIER CORPUS SCRATCH
set -eu
generate=$1 verify=$2 corpus=$3 scratch=$4

rm -rf "$scratch"
mkdir -p "$scratch"
count=0
for file in "$corpus"/*.json; do
  "$generate" rules --operation "$file" --out "$scratch" > "$scratch/said"
  name=$(basename "$file" .json)
  header=$scratch/include/restrip/tables/operations/$(echo "$name" | tr - _).hpp
  "$verify" --operation "$file" --certificate "$scratch/certificates/operations/$name.cert" --header "$header" > "$scratch/said" ||
    { cat "$scratch/said"; exit 1; }
  tail -1 "$scratch/said"
  count=$((count + 1))
done
[ "$count" -ge 6 ] || { echo "only $count operations"; exit 1; }
