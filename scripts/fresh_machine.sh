#!/usr/bin/env bash
# Runs a command on a fresh machine of a Debian release: a folder that debootstrap makes. Needs root.
#
#   scripts/fresh_machine.sh RELEASE FOLDER COMMAND…
#   scripts/fresh_machine.sh --files SOURCE RELEASE FOLDER COMMAND…
#
# RELEASE is a name such as trixie, or stable for the newest. FOLDER is made if it does not exist. COMMAND runs in
# FOLDER/root/project, a clone of HEAD without changes that are not committed, or in FOLDER/root/files, a copy of the folder
# SOURCE. The exit code is COMMAND's, or 77 if no machine can be made here.
# Remove FOLDER/root/project/build for a first build again, FOLDER for a machine without packages.
set -euo pipefail
usage() { sed -n '2,10s/^# \{0,1\}//p' "$0"; }
[ "${1:-}" != --help ] || { usage; exit 0; }
files=
if [ "${1:-}" = --files ]; then
  [ -d "${2:-}" ] || { echo "fresh_machine.sh: --files needs a folder" >&2; exit 2; }
  files=$(realpath -- "$2")
  shift 2
fi
[ $# -ge 3 ] || { usage >&2; exit 2; }
release=$1
mkdir -p "$2"
folder=$(realpath -- "$2")
shift 2
repository=$(realpath -- "$(dirname "$0")/..")

cannot() { echo "fresh_machine.sh: no machine of Debian $release here: $1" >&2; exit 77; }
[ "$(id -u)" -eq 0 ] || cannot "this needs root"
command -v debootstrap >/dev/null || cannot "debootstrap is not installed"
# Mounts are visible to the command alone and end with it, so that removing FOLDER never removes what is mounted there.
alone=(unshare --mount --pid --fork --kill-child)
"${alone[@]}" true 2>/dev/null || cannot "root may not mount file systems"

if [ ! -e "$folder/.complete" ]; then
  mirror=$(grep -hE '^URIs:|^deb ' /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null | grep -oE 'https?://[^ ]*/debian/?( |$)' | head -n 1 || true)
  "${alone[@]}" debootstrap --variant=minbase "$release" "$folder" ${mirror:-http://deb.debian.org/debian} >"$folder.log" 2>&1 ||
    cannot "debootstrap failed ($folder.log): $(tail -n 1 "$folder.log")"
  touch "$folder/.complete"
fi
cp /etc/resolv.conf "$folder/etc/" 2>/dev/null || true

if [ -n "$files" ]; then
  place=/root/files
  rm -rf "${folder:?}$place"
  cp -R "$files" "$folder$place"
else
  place=/root/project
  if [ -d "$folder$place/.git" ]; then
    git -C "$folder$place" fetch -q "$repository" HEAD
    git -C "$folder$place" reset -q --hard FETCH_HEAD
  else
    git clone -q --no-hardlinks "$repository" "$folder$place"
  fi
fi
exec "${alone[@]}" bash -euc 'mount -t proc proc "$1/proc"
mount --rbind /dev "$1/dev"
exec chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 bash -c '\''cd "$1" && shift && exec "$@"'\'' bash "${@:2}"' \
  bash "$folder" "$place" "$@"
