#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds and tests Meristem on another Debian release, in a root of its own below build/systems.
#
#   tests/systems/debian.sh RELEASE            runs `./dev demo`, `python`, `studio`, `test` and `package --test` there, and
#                                              compares the shipped plants with those of this system's program
#   tests/systems/debian.sh RELEASE --quick    compiles the sources that include a library, and builds and runs the tests
#                                              of the rooms `base` and `scene`
#
# RELEASE is a name that debootstrap knows, such as bookworm or trixie. The script must run as root. The root and its
# build folder stay for the next run; remove build/systems/RELEASE to begin anew. MERISTEM names this system's program
# (build/release/bin/meristem). The exit code is 77 if this machine does not allow mounts, device files or chroot, and with
# --quick also if it cannot reach a mirror.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."

fail() {
  printf 'debian.sh: %s\n' "$*" >&2
  exit 1
}

skip() {
  printf 'debian.sh: SKIPPED: nothing was tested on Debian %s, because this machine %s\n' "$release" "$1" >&2
  exit 77
}

title() { printf '\n== %s (%s s)\n' "$*" "$SECONDS"; }

release=${1:-}
mode=${2:-}
[[ $release =~ ^[a-z]+$ && ($mode == "" || $mode == --quick) && $# -le 2 ]] || fail "usage: debian.sh RELEASE [--quick]"
[[ $EUID -eq 0 ]] || fail "a root of another system needs root: sudo tests/systems/debian.sh $*"
command -v debootstrap >/dev/null || fail "debootstrap is missing: apt-get install debootstrap"
program=${MERISTEM:-build/release/bin/meristem}
[[ $mode == --quick || -x $program ]] || fail "there is no $program to compare with: run ./dev build, or set MERISTEM"

work=$PWD/build/systems/$release
root=$work/root
mkdir -p "$root"

# Prints what this machine refuses of all that a root of another system needs. Prints nothing if it allows everything.
refused() {
  unshare --mount --pid --fork --mount-proc mount --bind "$root" "$root" 2>&1 || return 0
  chroot / true 2>&1 || return 0
  rm -f "$work/device"
  { mknod "$work/device" c 1 3 && : >"$work/device"; } 2>&1 || return 0
  rm -f "$work/device"
}

# All mounts and processes live in namespaces, which the kernel removes when this script ends for any reason.
if [[ ${MERISTEM_INSIDE:-} != yes ]]; then
  reason=$(refused)
  if [[ -n $reason ]]; then
    skip "refuses: $reason"
  fi
  trap 'kill -KILL "$child" 2>/dev/null || true' EXIT
  trap 'exit 130' INT TERM HUP
  MERISTEM_INSIDE=yes setpriv --pdeathsig KILL unshare --mount --pid --fork --kill-child --mount-proc \
    tests/systems/debian.sh "$@" &
  child=$!
  wait "$child"
  exit
fi

# Runs a command in the root, in this folder, without the variables of this system.
within() {
  local name variables=()
  for name in http_proxy https_proxy no_proxy RC_PARAMS; do
    [[ -z ${!name:-} ]] || variables+=("$name=${!name}")
  done
  chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 CCACHE_DIR=/ccache \
    NODE_EXTRA_CA_CERTS=/ca-certificates.crt DEBIAN_FRONTEND=noninteractive MERISTEM_WERROR=ON "${variables[@]}" \
    sh -c 'cd "$0" && exec "$@"' "$PWD" "$@"
}

# The root needs no protection from power cuts, and no pages to read.
make_root() {
  local mirror
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Label: Debian' 2>/dev/null | head -n 1)
  mirror=${mirror:-http://deb.debian.org/debian}
  title "make a root of $release from $mirror"
  if ! wget --quiet --tries=2 --timeout=30 --output-document=/dev/null "${mirror%/}/dists/$release/InRelease"; then
    [[ $mode != --quick ]] || skip "cannot reach ${mirror%/}/dists/$release/InRelease"
    fail "cannot read ${mirror%/}/dists/$release/InRelease: the mirror is out of reach or lacks the release"
  fi
  rm -rf "$root"
  mkdir -p "$root/etc/dpkg/dpkg.cfg.d"
  printf 'force-unsafe-io\npath-exclude=/usr/share/man/*\npath-exclude=/usr/share/locale/*\n' \
    >"$root/etc/dpkg/dpkg.cfg.d/meristem"
  debootstrap --variant=minbase "$release" "$root" "$mirror" >"$work/debootstrap.log" 2>&1 ||
    { tail -n 20 "$work/debootstrap.log"; fail "debootstrap failed; $work/debootstrap.log is its log"; }
  touch "$work/made"
}

# Binds $2 of this system to the path $1 of the root.
bind() {
  mkdir -p "$root/$1" "$2"
  mount --bind "$2" "$root/$1"
}

# Shows the source tree in the root. Everything that is built or fetched there lands in folders of its own.
enter_root() {
  mount --bind "$root" "$root"
  bind "$PWD" "$PWD"
  bind "$PWD/build" "$work/build"
  bind "$PWD/out" "$work/out"
  bind /ccache "$PWD/build/systems/ccache"
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  cp /etc/resolv.conf /etc/hosts "$root/etc"
  # Some machines reach the network through a server with a certificate of its own.
  cp /etc/ssl/certs/ca-certificates.crt "$root/ca-certificates.crt" 2>/dev/null || : >"$root/ca-certificates.crt"
}

install() {
  within dpkg-query -W "$@" >/dev/null 2>&1 && return
  title "install packages"
  { within apt-get update -qq && within apt-get install -y -qq --no-install-recommends "$@"; } \
    >"$work/packages.log" 2>&1 ||
    { tail -n 20 "$work/packages.log"; fail "could not install the packages; $work/packages.log is the log"; }
}

[[ -f $work/made ]] || make_root
enter_root
if [[ $mode == --quick ]]; then
  eval "$(sed -n '/^build_packages=(/,/)$/p' dev)"
  # Validators of JSON and what they need take longer to install than everything else.
  install "${build_packages[@]}" libgtest-dev libgmock-dev librapidcheck-dev pybind11-dev python3-dev
  within tests/systems/part.sh
else
  # What users have who fetch the sources by git and npm; `./dev` installs all else.
  install git ca-certificates
  for folder in apps/studio/page tests/validators; do bind "$PWD/$folder/node_modules" "$work/$folder"; done
  within tests/systems/whole.sh
  title "compare the shipped plants"
  tests/systems/hashes.py "$program" >"$work/here.txt"
  within tests/systems/hashes.py build/release/bin/meristem >"$work/there.txt"
  tests/systems/hashes.py --compare "$work/here.txt" "$work/there.txt"
fi
title "done"
