#!/usr/bin/env bash
# On a fresh Debian machine: the Debian packages are installed, used and removed without a trace; the wheel and the source archive
# install into a virtual environment. In a folder with these artefacts and:
#   main.cpp, expected.txt       README's program and what it prints
#   keep_strips.c, example.py    examples of the sources
set -Eeuo pipefail
trap 'echo "machine.sh: failed in line $LINENO" >&2' ERR
export DEBIAN_FRONTEND=noninteractive
install() { apt-get -qq install -y --no-install-recommends "$@" >/dev/null; }
apt-get -qq update
install g++ cmake make pkg-config mypy python3-numpy python3-pip python3-setuptools python3-venv python3-wheel
mapfile -t packages < <(for file in *.deb; do dpkg-deb -f "$file" Package; done)
install $(for file in *.deb; do dpkg-deb -f "$file" Depends; done | tr ',' '\n' | sed 's/(.*//; s/|.*//' | sort -u | grep -vxF "$(printf '%s\n' "${packages[@]}")" | grep -v restrip)

files() { find / -xdev \( -path /root -o -path /tmp -o -path /proc -o -path /var/lib -o -path /var/cache -o -path /var/log \) -prune -o -print | sort; }
files >/tmp/before
apt-get -qq install -y ./*.deb >/dev/null

# The programs and their manuals.
mkdir -p /tmp/run
restrip replay --built-in --triangles 400 --policy local --repeats 0 --trace /tmp/run/run.trace >/dev/null
restrip-check /tmp/run/run.trace | grep '^accepted' >/dev/null
operations=/usr/share/doc/restrip/tables/operations
restrip-generate rules --operation $operations/bisect.json --out /tmp/run/rules >/dev/null
restrip-verify --operation $operations/bisect.json --certificate /tmp/run/rules/certificates/operations/bisect.cert | grep '^verified' >/dev/null
for program in /usr/bin/restrip*; do
  "$program" --help >/dev/null
  zcat "/usr/share/man/man1/$(basename "$program").1.gz" | grep '^\.SH NAME' >/dev/null
done

# The library, by CMake and by pkg-config, in C++ and in a project in C alone.
mkdir -p /tmp/run/cpp /tmp/run/c
cp main.cpp /tmp/run/cpp
cp keep_strips.c /tmp/run/c
cat >/tmp/run/cpp/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.22)
project(program LANGUAGES CXX)
find_package(restrip 1.0 REQUIRED)
add_executable(program main.cpp)
target_link_libraries(program PRIVATE restrip::restrip)
END
cat >/tmp/run/c/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.22)
project(program LANGUAGES C)
find_package(restrip 1.0 REQUIRED COMPONENTS c)
foreach(kind IN ITEMS c c_static)
  add_executable(program_${kind} keep_strips.c)
  target_link_libraries(program_${kind} PRIVATE restrip::${kind})
endforeach()
END
for language in cpp c; do
  cmake -S /tmp/run/$language -B /tmp/run/$language/build >/dev/null
  cmake --build /tmp/run/$language/build >/dev/null
done
/tmp/run/cpp/build/program | diff expected.txt -
g++ -std=c++20 main.cpp $(pkg-config --cflags --libs restrip) -o /tmp/run/program
/tmp/run/program | diff expected.txt -
cc keep_strips.c $(pkg-config --cflags --libs restrip-c) -o /tmp/run/program
/tmp/run/program >/tmp/run/printed
for kind in c c_static; do /tmp/run/c/build/program_$kind | diff /tmp/run/printed -; done

apt-get -qq purge -y "${packages[@]}" >/dev/null
files | diff /tmp/before - || { echo "machine.sh: these files stay after the packages are removed" >&2; false; }

# The Python package.
for archive in python/*; do
  rm -rf /tmp/venv
  python3 -m venv --system-site-packages /tmp/venv
  CXXFLAGS=-O0 /tmp/venv/bin/pip -q install --no-index --no-deps --no-build-isolation --disable-pip-version-check "./$archive"
  (cd /tmp && /tmp/venv/bin/python -B /root/files/example.py) | grep '^after improving: .*valid: True$' >/dev/null
done
mypy --strict --python-executable /tmp/venv/bin/python -c 'import restrip; restrip.LiveMesh' | grep '^Success' >/dev/null
echo "machine.sh: Debian $(cat /etc/debian_version): all is well"
