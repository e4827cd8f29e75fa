#!/usr/bin/env bash
# Run it before each commit: format, walls, references, and the tests of the files that differ from main (on main: from
# HEAD). The tests of a source are the file of its name under tests/, NAME_test, and every test that includes it.
# scripts/test.sh does the rest.
#
#   scripts/check.sh [BASE]   BASE: another commit to compare with
set -Eeuo pipefail
case "${1:-}" in
  --help) sed -n '2,7s/^# \{0,1\}//p' "$0"; exit 0 ;;
  -*) echo "check.sh: unknown: $1; --help explains" >&2; exit 2 ;;
esac
cd "$(dirname "$0")/.."
source scripts/setup.sh

base=${1:-$(git merge-base HEAD main 2>/dev/null || git rev-parse HEAD)}
mapfile -t changed < <({ git diff --name-only --diff-filter=d "$base"; git ls-files --others --exclude-standard; } | sort -u)
echo "${#changed[@]} files differ from $(git describe --always "$base")"
matching() { printf '%s\n' "${changed[@]}" | grep -E "$1" || true; }

format=$(style_tool clang-format)
if [ -n "$format" ]; then
  say "format"
  matching '\.(cpp|hpp|c|h)$' | { grep -vE '^tables/include/|^generator/emit/templates/|^tests/generator/languages/' || true; } | xargs -r "$format" --dry-run --Werror
else
  leave_out "the format of the sources: clang-format $style_version is not there, and other versions disagree"
fi

say "walls and tests of public headers"
cmake -DROOT="$PWD" -P tests/cross/walls.cmake
cmake -DROOT="$PWD" -P tests/cross/header_tests.cmake

say "words that readers stop at, in changed lines"
scripts/words.py "$base"

say "references, copies of the policies, and that deliberate faults fit the code"
python3 -B tests/cross/references_test.py
python3 -B scripts/policies.py --check
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
python3 -B tests/verify/plant_faults.py tests/verify/faults.txt verify "$scratch/verify"

# Test files: changed ones, ones named after changed sources, ones that include a changed header.
declare -A sources=()
scripts=()
while read -r file; do
  name=$(basename "${file%.*}")
  case $file in
    tests/*_test.cpp) sources[$file]=1 ;;
    tests/*_test.py) scripts+=("${name%_test}") ;;
    tools/app/*_command.cpp)  # the tests that call the subcommand
      word=${name%_command}
      while read -r test; do scripts+=("$(basename "${test%_test.py}")"); done < <(grep -lE "[\"' ]${word//_/-}[\"' ]" tests/tools/*_test.py || true)
      ;;
    *.cpp | *.hpp)
      while read -r test; do sources[$test]=1; done < <(git ls-files -co --exclude-standard "tests/*/${name}_test.cpp" "tests/${name}_test.cpp")
      [[ $file != *.hpp ]] ||
        while read -r test; do sources[$test]=1; done < <(grep -rlE "^#include \"(.*/)?$name\.hpp\"" tests --include='*_test.cpp' || true)
      ;;
  esac
done < <(printf '%s\n' "${changed[@]}")

say "configuring"
cmake --preset check >/dev/null

# The programs that have a test file, and its suites.
say "building"
declare -A suites=()
mapfile -t objects < <(ninja -C build/check -t targets all | sed -nE 's/^(tests\/.*\.dir\/.*\.cpp\.o): .*/\1/p')
for source in "${!sources[@]}"; do
  folder=$(dirname "$source")
  found=$(printf '%s\n' "${objects[@]}" | grep -E "/$(basename "$source")\.o$" || true)
  programs=()
  for object in $found; do
    # tests/runtime/CMakeFiles/TARGET.dir/rules/key_test.cpp.o is tests/runtime/rules/key_test.cpp
    [ "$(sed -E 's/CMakeFiles\/[^/]*\.dir\///; s/\.o$//' <<<"$object")" = "$folder/$(basename "$source")" ] || continue
    mapfile -t -O ${#programs[@]} programs < <(ninja -C build/check -t query "$object" | sed -nE '/outputs:/,$ s/^ *(bin\/.*)$/\1/p' | grep -v mutants)
  done
  [ ${#programs[@]} -gt 0 ] || { echo "check.sh: no program has $source" >&2; false; }
  filter=$(sed -nE 's/^(TYPED_)?TEST(_F|_P)?\(([A-Za-z0-9_]+).*/\3.*:*\/\3.*:\3\/*/p' "$source" | sort -u | paste -sd:)
  for program in "${programs[@]}"; do suites[$program]+=":$filter"; done
done
targets=("${!suites[@]}")
[ ${#scripts[@]} -eq 0 ] || targets+=(restrip_program)
[ ${#targets[@]} -eq 0 ] || cmake --build --preset check --target "${targets[@]}"

say "testing"
for program in "${!suites[@]}"; do
  echo "$program"
  build/check/"$program" --gtest_brief=1 --gtest_filter="${suites[$program]#:}"
done
if [ ${#scripts[@]} -gt 0 ]; then
  ctest --preset check --no-tests=error -R "^tools\.($(printf '%s\n' "${scripts[@]}" | sort -u | paste -sd'|'))$"
fi
echo "all is well after $SECONDS s; $((${#suites[@]})) programs and ${#scripts[@]} scripts were run"
