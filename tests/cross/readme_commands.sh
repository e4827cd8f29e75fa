#!/usr/bin/env bash
# Runs every command of the ```sh blocks of a page, except the scripts that run this test, with our programs on the PATH.
set -euo pipefail
readme=$1
export PATH=$2:$PATH
root=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
ln -s "$root/tables" tables
ln -s "$root/scripts" scripts
export PYTHONDONTWRITEBYTECODE=1
count=0
while IFS= read -r command; do
  case "$command" in '' | '#'* | scripts/* | cmake* | git*) continue ;; esac
  echo "\$ $command"
  bash -euo pipefail -c "$command" </dev/null >output 2>&1 || { cat output; echo "failed: $command"; exit 1; }
  count=$((count + 1))
done < <(awk '/^```sh$/ {on = 1; next} /^```/ {on = 0} on' "$readme")
[ "$count" -ge 4 ] || { echo "only $count commands found in $readme"; exit 1; }
echo "$count commands of the page succeeded"
