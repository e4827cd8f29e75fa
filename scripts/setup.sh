# Sourced by demo.sh, test.sh and prove.sh: installs missing packages by name, reports each step, and names the step
# that fails.
step="starting"
trap 'echo "$(basename "$0"): failed while: $step" >&2' ERR

say() {
  step="$1"
  echo "== $1"
}

# Parts that this machine lacks are left out: one line here, and again at the end of test.sh.
left_out=()
leave_out() {
  left_out+=("left out: $1")
  echo "left out: $1"
}

# These print which of the packages are installed, and which of them this release offers.
installed() { dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^installed //p' | sort -u || true; }
offered() {
  LC_ALL=C apt-cache policy "$@" 2>/dev/null |
    awk '/^[^ ]/ { sub(/:$/, ""); name = $1 } $1 == "Candidate:" && $2 != "(none)" { print name }'
}

# Waits if a machine that has just started is still installing something itself.
apt() {
  local run=(env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600 "$@")
  [ "$(id -u)" -eq 0 ] || run=(sudo "${run[@]}")
  "${run[@]}"
}
apt_updated=
update_once() {
  [ -n "$apt_updated" ] || apt update || echo "apt-get update failed; the lists of packages that are there may still do"
  apt_updated=yes
}

# need PACKAGE…: installs missing packages, as root or with sudo. Of a PACKAGE with alternatives, one|other, it takes
# the first that this release offers. It leaves out a package that the release does not have.
need() {
  if ! command -v apt-get >/dev/null; then
    leave_out "installing packages, because this is neither Debian nor Ubuntu. The project wants $*"
    return 0
  fi
  local known package name chosen missing=() install=() started=$SECONDS
  known=$(installed ${*//|/ })
  for package in "$@"; do
    grep -qxF "${package//|/$'\n'}" <<<"$known" || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    echo "these packages are missing, and there is neither root nor sudo: ${missing[*]}" >&2
    return 1
  fi
  say "looking for packages: ${missing[*]}"
  update_once
  known=$(offered ${missing[*]//|/ })
  for package in "${missing[@]}"; do
    chosen=
    for name in ${package//|/ }; do
      if [ -z "$chosen" ] && grep -qxF "$name" <<<"$known"; then chosen=$name; fi
    done
    if [ -n "$chosen" ]; then install+=("$chosen"); else leave_out "package ${package//|/ or }: this release does not have it"; fi
  done
  [ ${#install[@]} -gt 0 ] || return 0
  say "installing ${install[*]}"
  apt install -y --no-install-recommends "${install[@]}" >/dev/null
  echo "installed in $((SECONDS - started)) s"
}

# need_clang: Clang with its linker, sanitizers and WebAssembly libraries, all of one version: the newest complete set
# that is installed, or else the newest that this release offers. CMake uses the compiler of that version
# (cmake/NewestClang.cmake).
clang_set() { printf '%s\n' "clang-$1" "lld-$1" "libclang-rt-$1-dev" "libclang-rt-$1-dev-wasm32" "libc++-$1-dev-wasm32"; }
clang_versions() { apt-cache pkgnames clang- | sed -nE 's/^clang-([0-9]+)$/\1/p' | sort -rn; }
# newest_complete installed|offered
newest_complete() {
  local version
  for version in $(clang_versions); do
    if [ "$("$1" $(clang_set "$version") | wc -l)" -eq "$(clang_set 0 | wc -l)" ]; then
      echo "$version"
      return 0
    fi
  done
}
need_clang() {
  command -v apt-get >/dev/null || return 0
  local version
  version=$(newest_complete installed)
  if [ -z "$version" ]; then
    say "looking for the newest Clang"
    update_once
    version=$(newest_complete offered)
    # If no version is complete, takes what exists of the newest.
    [ -n "$version" ] || version=$(clang_versions | sed -n 1p)
    if [ -z "$version" ]; then
      leave_out "Clang: this release does not have it"
      return 0
    fi
  fi
  need $(clang_set "$version") wasi-libc
  export RESTRIP_CLANG=clang++-$version
}

# The sources are formatted and checked by clang-format and clang-tidy of one version, since other versions disagree:
# the version named in .clang-format. This prints the program of that version, if it is installed.
style_version=$(sed -nE 's/^# .* version ([0-9]+).*/\1/p' .clang-format)
style_tool() {
  local program
  for program in "$1-$style_version" "$1"; do
    if "$program" --version 2>/dev/null | grep -qE "version $style_version\."; then
      echo "$program"
      return 0
    fi
  done
}

build_packages=(g++ cmake ninja-build libboost-dev "libnauty-dev|libnauty2-dev" libfmt-dev libcli11-dev nlohmann-json3-dev
  libpng-dev libssl-dev)
# For the pages, together with need_clang.
page_packages=(python3 python3-markdown-it python3-pygments)
# For tests only, and for test.sh --all.
test_packages=("${page_packages[@]}" git libgtest-dev python3-numpy python3-pip python3-setuptools python3-venv python3-wheel nodejs ocaml "pkgconf|pkg-config")
all_packages=(xz-utils mypy g++-multilib rustc glslang-tools libvulkan-dev debootstrap dpkg-dev file make
  "clang-tidy-$style_version" "clang-format-$style_version")
command -v chromium >/dev/null || all_packages+=(chromium)  # missing in Ubuntu: install another Chromium there
command -v npm >/dev/null || all_packages+=(npm)  # a Node.js from elsewhere includes npm
# For the benchmarks: performance.sh measures with them, test.sh --all checks that they run.
bench_packages=(libbenchmark-dev libmeshoptimizer-dev libopenmesh-dev python3)
