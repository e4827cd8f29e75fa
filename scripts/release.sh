#!/usr/bin/env bash
# Builds what is published into dist/ and tries each artefact in an empty folder, without the checkout. Ends with a table. The same
# commit gives the same bytes on the same release of Debian (dist/SHA256SUMS). Needs a checkout without changes, and root for
# the fresh machines of the oldest supported and the newest stable Debian (scripts/fresh_machine.sh). About 15 minutes on
# two processors.
#
#   scripts/release.sh
#   scripts/release.sh --build   without the trials
set -Eeuo pipefail
trials=yes
case "${1:-}" in
  '') ;;
  --build) trials= ;;
  *) sed -n '2,8s/^# \{0,1\}//p' "$0"; [ "$1" = --help ] && exit 0; echo "release.sh: unknown: $1" >&2; exit 2 ;;
esac
cd "$(dirname "$0")/.."
source scripts/setup.sh
[ -z "$(git status --porcelain)" ] || { echo "release.sh: the checkout has changes" >&2; exit 2; }
need "${build_packages[@]}" "${test_packages[@]}" binutils debootstrap dpkg-dev file lintian twine ${trials:+g++-mingw-w64-x86-64}
command -v npm >/dev/null || need npm
command -v chromium >/dev/null || need chromium
need_clang

version=$(sed -nE 's/^set\(RESTRIP_VERSION (.*)\)/\1/p' cmake/project.cmake)
contact=$(sed -nE 's/^set\(RESTRIP_CONTACT "(.*)"\).*/\1/p' cmake/project.cmake)
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH PYTHONHASHSEED=0 LC_ALL=C.UTF-8
umask 022
# A python3 from elsewhere does not have the packages of the system.
python=python3
"$python" -c 'import numpy, setuptools, wheel' 2>/dev/null || python=/usr/bin/python3
scratch=$(mktemp -d)
machines=()
trap 'for pid in "${machines[@]}"; do kill -KILL -- "-$pid" 2>/dev/null || true; done; rm -rf "$scratch"' EXIT
dist=$PWD/dist
rm -rf "$dist"
mkdir "$dist"

# pack FILE FOLDER: FOLDER as FILE.zip or FILE.tar.gz, sorted and with the time of the commit.
pack() {
  (
    cd "$(dirname "$2")"
    find "$(basename "$2")" -exec touch -h -d "@$SOURCE_DATE_EPOCH" {} +
    case $1 in
      *.zip) python3 - "$1" "$(basename "$2")" <<'END' ;;
import os, sys, time, zipfile
time_of_commit = time.gmtime(int(os.environ["SOURCE_DATE_EPOCH"]))[:6]
with zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
    for folder, folders, files in os.walk(sys.argv[2]):
        folders.sort()
        for name in sorted(files):
            path = os.path.join(folder, name)
            entry = zipfile.ZipInfo(os.path.relpath(path, sys.argv[2]), time_of_commit)
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o100644 << 16
            archive.writestr(entry, open(path, "rb").read())
END
      *) tar --sort=name --owner=0 --group=0 --numeric-owner -cf - "$(basename "$2")" | gzip -9n >"$1" ;;
    esac
  )
}

say "building"
build=build/dist
cmake --preset programs -B $build -DRESTRIP_STATIC=ON -DRESTRIP_ALLOW_MISSING=OFF -DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_SKIP_RPATH=ON \
  -DCMAKE_CXX_FLAGS="-ffile-prefix-map=$PWD=." >"$scratch/configure"
cmake --build $build --target all web

say "packing"
git archive --format=tar --prefix="restrip-$version/" HEAD | gzip -9n >"$dist/restrip-$version.tar.gz"
mkdir "$scratch/two"
cp $build/two-files/restrip.hpp $build/two-files/restrip.cpp LICENSE "$scratch/two"
pack "$dist/restrip-$version-two-files.zip" "$scratch/two"
cpack --config $build/CPackConfig.cmake -G DEB -B "$scratch/deb" >"$scratch/cpack"
cp "$scratch"/deb/*.deb "$dist"
(cd "$dist" && npm pack --silent "$OLDPWD/$build/web/package" >/dev/null)
RESTRIP_C_LIBRARY=$(realpath $build/bindings/c/librestrip_c.so) "$python" -B -m pip -q wheel --no-index --no-deps --no-build-isolation \
  --disable-pip-version-check -w "$dist/python" bindings/python
(cd bindings/python && "$python" -B setup.py -q sdist -d "$scratch/sdist")
mkdir "$scratch/python"
tar -xzf "$scratch"/sdist/restrip-*.tar.gz -C "$scratch/python"
pack "$dist/python/restrip-$version.tar.gz" "$scratch/python/restrip-$version"
mkdir "$scratch/pages"
(cd $build/web && find . \( -path ./maker -o -name CMakeFiles \) -prune -o -type f \( -name '*.html' -o -name '*.svg' -o -name '*.png' -o -name '*.csv' \
  -o -name '*.json' -o -name '*.js' -o -name '*.css' -o -path './package/*' -o -path './restrip.[hc]pp' \) -print0 | xargs -0 cp --parents -t "$scratch/pages")
cp LICENSE THIRD-PARTY.txt "$scratch/pages"
pack "$dist/restrip-$version-pages.zip" "$scratch/pages"
(cd "$dist" && sha256sum ./*.* python/* | sed 's/ \.\// /' >SHA256SUMS)

declare -A tried=()
if [ -n "$trials" ]; then
  # What the trials need of the sources, from their archive.
  sources=$scratch/sources
  mkdir "$sources" "$scratch/files"
  tar -xzf "$dist/restrip-$version.tar.gz" --strip-components=1 -C "$sources"
  awk '/^```cpp$/ { text = ""; inside = 1; next } /^```$/ { inside = 0 } inside { text = text $0 "\n" } /^It prints:$/ { printf "%s", text; exit }' \
    "$sources/README.md" >"$scratch/files/main.cpp"
  sed -n '/^It prints:$/,$p' "$sources/README.md" | sed -n '/^```text$/,/^```$/p' | sed '/^```/d' >"$scratch/files/expected.txt"
  cp -R "$dist"/* "$sources/examples/keep_strips.c" "$sources/bindings/python/example.py" tests/artefacts/machine.sh "$scratch/files"

  say "fresh machines, in the background"
  logs=build/logs/release
  mkdir -p $logs
  on_machine() {
    scripts/fresh_machine.sh --files "$scratch/files" "$1" "build/debian-$1" bash machine.sh
    [ "$1" != stable ] || scripts/fresh_machine.sh --files "$scratch/files" stable build/debian-stable \
      bash -c "tar -xzf restrip-$version.tar.gz && cd restrip-$version && scripts/demo.sh --pages"
  }
  set -m  # each in a process group, so that all of it can be stopped
  for release in oldstable stable; do
    (trap - ERR EXIT; on_machine $release) >"$logs/$release" 2>&1 &
    machines+=($!)
  done
  set +m

  say "checking names, licences and metadata"
  # CPack calls ldconfig in a script besides the trigger.
  suppressed=initial-upload-closes-no-bugs,maintscript-calls-ldconfig
  if [ -z "$contact" ]; then
    leave_out "the address of the maintainer in the Debian packages: RESTRIP_CONTACT is empty"
    suppressed+=,malformed-contact,syntax-error-in-debian-changelog
  fi
  lintian --allow-root --fail-on error,warning --suppress-tags $suppressed "$dist"/*.deb
  twine check "$dist"/python/*
  npm pack --dry-run --json "$build/web/package" | grep '"THIRD-PARTY.txt"' >/dev/null
  python3 -m zipfile -e "$dist"/python/*.whl "$scratch/wheel"
  glibc=$(objdump -T "$scratch"/wheel/restrip/librestrip_c.so | grep -oE 'GLIBC_[0-9.]+' | sort -uV | tail -n 1)

  say "the two files"
  mkdir "$scratch/empty-two"
  (cd "$scratch/empty-two" && bash "$OLDPWD/tests/artefacts/two_files.sh" "$dist/restrip-$version-two-files.zip" "$scratch/files/main.cpp" \
    "$scratch/files/expected.txt" "${RESTRIP_CLANG:-clang++}")
  tried[two-files]="README's program: GCC, Clang, without exceptions and RTTI, hidden symbols; MinGW compiles"
  say "the npm package"
  mkdir "$scratch/empty-npm"
  if npm view typescript version >/dev/null 2>&1; then
    (cd "$scratch/empty-npm" && bash "$OLDPWD/tests/artefacts/npm.sh" "$dist"/restrip-wasm-*.tgz "$OLDPWD/$build/web/hare.obj")
    tried[npm]="Node 18, 20, 22; TypeScript strict; bundled in a worker"
  else
    leave_out "the npm package on other versions of Node: the registry of npm does not answer"
  fi
  say "the pages"
  mkdir "$scratch/empty-pages"
  (cd "$scratch/empty-pages" && python3 -m zipfile -e "$dist/restrip-$version-pages.zip" .)
  node tests/artefacts/pages.mjs "$scratch/empty-pages" "$(command -v chromium)"
  tried[pages]="Chromium, from files and from a server below a path"

  say "waiting for the fresh machines (logs: $logs)"
  on=
  for release in oldstable stable; do
    code=0
    wait "${machines[0]}" || code=$?
    machines=("${machines[@]:1}")
    case $code in
      0) on+="${on:+, }Debian $(cat "build/debian-$release/etc/debian_version")" ;;
      77) leave_out "artefacts on a fresh machine: $(tail -n 1 "$logs/$release")" ;;
      *) tail -n 40 "$logs/$release" >&2; false ;;
    esac
  done
  if [ -n "$on" ]; then
    tried[deb]="installed, used, removed: $on"
    tried[python]="installed: $on; needs $glibc"
    [[ ! -e build/debian-stable/root/files/restrip-$version/build/programs/bin/restrip ]] || tried[source]="scripts/demo.sh on the newest stable Debian"
  fi
fi

say "what is in dist/"
for file in "$dist"/*.* "$dist"/python/*; do
  name=${file#"$dist/"}
  case $name in
    *.deb) what=deb ;;
    *two-files*) what=two-files ;;
    *.tgz) what=npm ;;
    python/*) what=python ;;
    *pages*) what=pages ;;
    *) what=source ;;
  esac
  printf '%-42s %9d  %s\n' "$name" "$(stat -c %s "$file")" "${tried[$what]:-not tried}"
done
printf '%s\n' "${left_out[@]}"
