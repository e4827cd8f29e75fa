#!/bin/sh
# The verifier proves the generator's output: operations of the corpus, with all kinds of costs, constraints and ports given
# up, and families described as operations. A split of eight triangles has the largest number of ports.
#   generated.sh GENERATOR VERIFIER CORPUS SCRATCH [small]      small: without the split of eight triangles
set -eu
generate=$1 verify=$2 corpus=$3 scratch=$4 small=${5-}

rm -rf "$scratch"
mkdir -p "$scratch"
cp "$corpus"/*.json "$scratch"
describe() {
  "$generate" describe "$@" > "$scratch/described.json"
  name=$(sed -n 's/^ *"name": "\(.*\)",$/\1/p' "$scratch/described.json")
  mv "$scratch/described.json" "$scratch/${name:?describe names no operation}.json"
}
describe --family split --k 4 --at 2
describe --family collapse --k 4 --at 1
describe --family open-split --k 3 --at 1 --to 2
describe --family open-collapse --k 3 --at 0 --to 2
describe --family boundary-split --k 4 --at 2
describe --family boundary-collapse --k 3 --at 1
describe --family flip
describe --family split --k 6 --at 3 --constraint matching
describe --family collapse --k 5 --at 2 --constraint matching
describe --family boundary-collapse --k 4 --at 1 --constraint matching
describe --family open-split --k 3 --at 0 --to 2 --constraint forest
[ "$small" = small ] || describe --family split --k 8 --at 3

count=0
for file in "$scratch"/*.json; do
  "$generate" rules --operation "$file" --out "$scratch/rules" > "$scratch/said"
  name=$(basename "$file" .json)
  header=$scratch/rules/include/restrip/tables/operations/$(echo "$name" | tr - _).hpp
  "$verify" --operation "$file" --certificate "$scratch/rules/certificates/operations/$name.cert" --header "$header" > "$scratch/said" ||
    { cat "$scratch/said"; exit 1; }
  tail -1 "$scratch/said"
  count=$((count + 1))
done
[ "$count" -ge 18 ] || { echo "only $count operations"; exit 1; }
