#!/usr/bin/env bash
# Claim: bash completes the program's subcommands, options and values of options, and completes file names otherwise.
#
#   completion_test.sh restrip restrip.bash
set -euo pipefail
restrip=$1
source "$2"
complete -p restrip | grep -q -- '-F _restrip restrip'

# expect WORDS… -- COMPLETIONS, for the last word
expect() {
  COMP_WORDS=("$restrip")
  while [ "$1" != -- ]; do
    COMP_WORDS+=("$1")
    shift
  done
  shift
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _restrip
  local found
  found=$(printf '%s\n' "${COMPREPLY[@]}" | sort | tr '\n' ' ')
  [ "$found" = "$1 " ] || { echo "after ${COMP_WORDS[*]:1}: '$found', not '$1 '" >&2; exit 1; }
}
expect '' -- 'bake convert draw make-mesh paper replay simplify stats stripify'
expect st -- 'stats stripify'
expect --v -- '--version'
expect convert --we -- '--weld'
expect stripify mesh.obj - -- '--batch-indices --batch-vertices --bound --cache --cache-weight --cost --effort --form --from --gltf --help --index --json --keep-strips --limit --no-attributes --orient --output --seed --to --version --weld -h -o'
expect stripify --effort '' -- 'best fast file full'
expect stripify mesh.obj --gltf l -- 'list'
expect replay --policy b -- 'baked'
expect stripify mesh -- ''
expect stripify -o out -- ''
expect no-such-subcommand -- ''
echo "completion: all hold"
