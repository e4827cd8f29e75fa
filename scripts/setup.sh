# Sourced by demo.sh, test.sh and prove.sh: installs missing packages by name, says what it does, names the step that fails.
step="starting"
trap 'echo "$(basename "$0"): failed while: $step" >&2' ERR

say() {
  step="$1"
  echo "== $1"
}

# need PACKAGE…: installs those that are not there. As root, or with sudo.
need() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  say "installing ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "these packages are missing, and there is neither root nor sudo: ${missing[*]}" >&2; return 1; }
    as_root=(sudo)
  fi
  # A machine that has just started may be installing something itself: wait for that.
  local started=$SECONDS apt=(env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600)
  "${as_root[@]}" "${apt[@]}" update
  "${as_root[@]}" "${apt[@]}" install -y --no-install-recommends "${missing[@]}" >/dev/null
  echo "installed in $((SECONDS - started)) s"
}

build_packages=(g++ cmake ninja-build libboost-dev libnauty2-dev libfmt-dev libcli11-dev nlohmann-json3-dev libopenmesh-dev
  libpng-dev libssl-dev libgtest-dev)
# Wanted by the pages for the browser.
web_packages=(python3 clang-14 lld-14 wasi-libc libc++-14-dev-wasm32 libclang-rt-14-dev-wasm32)
# Wanted by tests alone.
test_packages=(git libcgal-dev libtbb-dev python3 clang-14 libclang-rt-14-dev clang-tidy-14 clang-format-14 xz-utils
  parallel openmpi-bin g++-multilib lld-14 wasi-libc libc++-14-dev-wasm32 libclang-rt-14-dev-wasm32 nodejs rustc glslang-tools
  libvulkan-dev dpkg-dev file make pkgconf ocaml)
command -v chromium >/dev/null || test_packages+=(chromium)  # Ubuntu has no such package: install another Chromium there
command -v npm >/dev/null || test_packages+=(npm)  # a Node.js that is not the system's brings its own
# Wanted by the benchmarks: performance.sh measures with them, test.sh sees that they run.
bench_packages=(libbenchmark-dev libmeshoptimizer-dev python3 clang-14)
