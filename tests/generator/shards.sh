#!/bin/sh
# The commands of docs/how-to/cluster.md, run as written, compared with the checked-in tables.
#   shards.sh restrip-generate TABLES docs/how-to/cluster.md SCRATCH parallel|mpirun|slurm|loop
set -eu
generate=$1 tables=$2 page=$3 scratch=$4 how=$5

fail() { echo "shards.sh: $1" >&2; exit 1; }
# The text of the page after this word; one line.
line() { grep "^$1 " "$page" || fail "$page has no line that begins with '$1'"; }

rm -rf "$scratch"
mkdir -p "$scratch/bin"
ln -s "$generate" "$scratch/bin/restrip-generate"
PATH="$scratch/bin:$PATH"
K=8 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export PATH K OMPI_ALLOW_RUN_AS_ROOT OMPI_ALLOW_RUN_AS_ROOT_CONFIRM OMPI_MCA_rmaps_base_oversubscribe
cd "$scratch"

# same FOLDER EXPECTED [OPTION…]: every byte, except for the handwritten files of tables/.
same() { diff -r -x CMakeLists.txt -x list_files.cmake -x families.json -x '*format.hpp' -x '*operations*' -x '*_dump.hpp' "$@" || fail "$1 is not $2"; }
# refused NAME WORDS: merging shards-NAME fails with a message that has the words, and writes nothing.
refused() {
  if restrip-generate merge --in "bad/$1" --out "bad/$1-out" >/dev/null 2>"bad/$1.txt"; then fail "$1: was merged"; fi
  grep -q -e "$2" "bad/$1.txt" || fail "$1: not '$2' but '$(cat "bad/$1.txt")'"
  [ ! -e "bad/$1-out" ] || fail "$1: something was written"
}

case $how in
  parallel) eval "$(line seq)" ;;
  mpirun) eval "$(line mpirun)" ;;
  slurm)
    command=$(line sbatch | sed "s/.*--wrap '\(.*\)'/\1/")
    for task in 1 2 3; do SLURM_ARRAY_TASK_ID=$task SLURM_ARRAY_TASK_COUNT=3 sh -c "$command"; done ;;
  loop)
    restrip-generate tables --shard 1/1 --threads 2 --out shards
    restrip-generate tables --max-k 4 --force --out whole
    for i in $(seq 50); do restrip-generate tables --max-k 4 --shard "$i/50" --out more; done
    restrip-generate merge --in more --out merged
    same merged whole

    mkdir bad
    good=more/shard-0007-of-0050.txt
    for case in missing twice truncated altered valence count; do cp -r more "bad/$case"; done
    rm bad/missing/shard-0007-of-0050.txt
    refused missing 'shard-0007-of-0050.txt: is missing; run restrip-generate tables --shard 7/50 --max-k 4 --out bad/missing'
    cp $good bad/twice/shard-0051-of-0050.txt
    refused twice 'shard-0051-of-0050.txt: is shard 7 of 50, and so is .*remove one'
    full=more/shard-0001-of-0050.txt  # shard 7 has no sections
    head -c 200 $full >bad/truncated/shard-0001-of-0050.txt
    refused truncated 'shard-0001-of-0050.txt: is truncated or altered.*run its shard again'
    sed 's/^rule 0 0/rule 0 1/' $full >bad/altered/shard-0001-of-0050.txt
    refused altered 'shard-0001-of-0050.txt: is truncated or altered'
    restrip-generate tables --max-k 5 --shard 7/50 --out bad/valence
    refused valence 'shard-0007-of-0050.txt: .*--max-k 5, but .*--max-k 4; keep one set'
    restrip-generate tables --max-k 4 --shard 7/49 --out bad/count
    refused count 'shard-0007-of-0049.txt: .*7 of 49 .*keep one set'
    mkdir bad/empty
    refused empty 'bad/empty: holds no shard; first run'
    refused absent 'bad/absent: cannot be read'
    for wrong in 0/3 4/3 3 a/3 1/3/5 1/0 -1/3; do
      if restrip-generate tables --shard "$wrong" --out bad/wrong 2>bad/wrong.txt; then fail "--shard $wrong was taken"; fi
      grep -q 'I/N' bad/wrong.txt || fail "--shard $wrong: $(cat bad/wrong.txt)"
    done
    [ ! -e bad/wrong ] || fail "a wrong --shard wrote something" ;;
  *) fail "unknown way '$how'" ;;
esac
eval "$(line 'restrip-generate merge')"
same "tables-$K" "$tables" -x MANIFEST  # which lists those as well
