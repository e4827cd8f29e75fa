#!/usr/bin/env bash
# Fetches the source of nauty from Debian's source package into build/nauty, for the page "Make a rule", which compiles
# it for WebAssembly (web/maker/CMakeLists.txt). It changes nothing outside build/. Afterwards run cmake again.
set -euo pipefail
cd "$(dirname "$0")/.."
release=$(. /etc/os-release && echo "${VERSION_CODENAME:-bookworm}")
[ "$(. /etc/os-release && echo "$ID")" = debian ] || { echo "nauty_source.sh: this is not Debian; unpack nauty's source into build/nauty" >&2; exit 1; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$scratch/lists/partial"
echo "deb-src http://deb.debian.org/debian $release main" >"$scratch/sources.list"
options=(-qq -o "Dir::Etc::sourcelist=$scratch/sources.list" -o Dir::Etc::sourceparts=/dev/null -o "Dir::State::lists=$scratch/lists" -o APT::Sandbox::User=root)
apt-get "${options[@]}" update
(cd "$scratch" && apt-get "${options[@]}" source --download-only nauty)
rm -rf build/nauty
mkdir -p build/nauty
tar -xf "$scratch"/nauty_*.orig.tar.* -C build/nauty --strip-components=1
echo "nauty's source is in build/nauty"
