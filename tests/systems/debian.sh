#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds and tests Meristem on another Debian release, in a root of its own below build/systems.
#
#   tests/systems/debian.sh RELEASE            builds the program, the Python module and the tests of all rooms, runs
#                                              them, and compares the shipped plants with those of this system's program
#   tests/systems/debian.sh RELEASE --quick    builds the rooms `base` and `scene` and runs their tests; compiles all
#                                              sources that include a library
#
# RELEASE is a name that debootstrap knows, such as bookworm or trixie. The script must run as root. The root stays for
# the next run; remove build/systems/RELEASE to begin anew. MERISTEM names this system's program
# (build/release/bin/meristem).
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."

fail() {
  printf 'debian.sh: %s\n' "$*" >&2
  exit 1
}

release=${1:-}
mode=${2:-}
[[ $release =~ ^[a-z]+$ && ($mode == "" || $mode == --quick) && $# -le 2 ]] || fail "usage: debian.sh RELEASE [--quick]"
[[ $EUID -eq 0 ]] || fail "a root of another system needs root: sudo tests/systems/debian.sh $*"
command -v debootstrap >/dev/null || fail "debootstrap is missing: apt-get install debootstrap"
program=${MERISTEM:-build/release/bin/meristem}
[[ $mode == --quick || -x $program ]] || fail "there is no $program to compare with: run ./dev build, or set MERISTEM"

# All mounts and processes live in namespaces, which the kernel removes when this script ends for any reason.
if [[ ${MERISTEM_INSIDE:-} != yes ]]; then
  trap 'kill -KILL "$child" 2>/dev/null || true' EXIT
  trap 'exit 130' INT TERM HUP
  MERISTEM_INSIDE=yes setpriv --pdeathsig KILL unshare --mount --pid --fork --kill-child --mount-proc \
    tests/systems/debian.sh "$@" &
  child=$!
  wait "$child"
  exit
fi

work=$PWD/build/systems/$release
root=$work/root
jobs=$(nproc)
ccache=${CCACHE_DIR:-$PWD/build/systems/ccache}
# The names of packages, from the only place that has them.
eval "$(sed -nE '/^(build|python|test)_packages=\(/,/\)$/p' dev)"
packages=("${build_packages[@]}" "${python_packages[@]}" "${test_packages[@]}")
# Validators of JSON and what they need take longer to install than everything else.
[[ $mode != --quick ]] || packages=("${build_packages[@]}" libgtest-dev libgmock-dev librapidcheck-dev python3)

title() { printf '\n== %s (%s s)\n' "$*" "$SECONDS"; }

# Runs a command in the root, in this folder.
within() {
  chroot "$root" /usr/bin/env PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 CCACHE_DIR="$ccache" \
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime RC_PARAMS="${RC_PARAMS:-seed=1}" \
    DEBIAN_FRONTEND=noninteractive sh -c 'cd "$0" && exec "$@"' "$PWD" "$@"
}

make_root() {
  local mirror
  if [[ ! -f $work/made ]]; then
    title "make a root of $release"
    rm -rf "$root"
    # The root needs no protection from power cuts, and no pages to read.
    mkdir -p "$root/etc/dpkg/dpkg.cfg.d"
    printf 'force-unsafe-io\npath-exclude=/usr/share/man/*\npath-exclude=/usr/share/locale/*\n' \
      >"$root/etc/dpkg/dpkg.cfg.d/meristem"
    mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Label: Debian' 2>/dev/null | head -n 1)
    debootstrap --variant=minbase "$release" "$root" ${mirror:+"$mirror"} >"$work/debootstrap.log" 2>&1 ||
      { tail -n 20 "$work/debootstrap.log"; fail "could not make the root"; }
    touch "$work/made"
  fi
  mkdir -p "$root/$PWD" "$root/$ccache" "$ccache"
  mount --bind "$PWD" "$root/$PWD"
  mount --bind "$ccache" "$root/$ccache"
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
}

need_packages() {
  within dpkg-query -W "${packages[@]}" >/dev/null 2>&1 && return
  title "install packages"
  { within apt-get update -qq && within apt-get install -y -qq --no-install-recommends "${packages[@]}"; } \
    >"$work/packages.log" 2>&1 || { tail -n 20 "$work/packages.log"; fail "could not install the packages"; }
}

# Configures a build folder of this name as users do, with the tests and with warnings as errors.
configure() {
  local name=$1
  shift
  within cmake --preset release -B "$work/$name" -DMERISTEM_TESTS=ON -DMERISTEM_TEST_OPTIONS=-O0 -DMERISTEM_WERROR=ON "$@" >"$work/$name.log" 2>&1 ||
    { cat "$work/$name.log"; fail "could not configure"; }
}

build() {
  local name=$1
  shift
  title "build $*"
  NINJA_STATUS='[%f/%t, %es] ' within ninja -C "$work/$name" -j "$jobs" "$@" |
    awk '!/^\[/ || ++steps % 20 == 0 { print; fflush() }'
}

# Compiles each source alone that includes a library, as CMake would, without what its target waits for.
compile_users_of_libraries() {
  title "compile what includes a library"
  grep -rlE --include='*.cpp' --exclude-dir=node_modules --exclude='*_test.cpp' \
    '#include (<(png|turbojpeg|libqhull|CLI|nlohmann|boost|tbb|zlib)|"meristem/(base/embree|shape/ray_trees)|"apps/cli/commands)' meristem apps |
    python3 -c '
import json, os, re, sys
users = {os.path.abspath(line.strip()) for line in sys.stdin}
for entry in json.load(open(sys.argv[1])):
    if entry["file"] in users:
        output = os.path.join(entry["directory"], re.search(r" -o (\S+)", entry["command"])[1])
        os.makedirs(os.path.dirname(output), exist_ok=True)
        print("cd", entry["directory"], "&&", entry["command"])' "$work/sources/compile_commands.json" >"$work/commands"
  within xargs -d '\n' -P "$jobs" -n 1 sh -c <"$work/commands"
  printf '%s sources compile\n' "$(wc -l <"$work/commands")"
}

# Runs the test programs of rooms, all of them even if one fails.
run_tests() {
  local tests bad=0
  for tests in "$@"; do
    title "run ${tests##*/}"
    within "$tests" --gtest_brief=1 --gtest_color=no || bad=1
  done
  return $bad
}

quick() {
  local options=(-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DMERISTEM_VALIJSON=/usr/include)
  configure quick "${options[@]}"
  build quick meristem_base_tests meristem_scene_tests
  run_tests "$work"/quick/bin/meristem_{base,scene}_tests
  configure sources "${options[@]}" -DCMAKE_UNITY_BUILD=OFF -DMERISTEM_PRECOMPILE=OFF
  compile_users_of_libraries
}

full() {
  local targets
  configure full -DMERISTEM_PYTHON_MODULE=ON
  mapfile -t targets < <(sed -nE 's/^meristem_room\((.*)$/\1/p' meristem/*/CMakeLists.txt | awk '{ print "meristem_" $1 "_tests" }')
  build full meristem_cli meristem_python "${targets[@]}"
  run_tests "${targets[@]/#/$work/full/bin/}"
  title "grow with the Python module"
  PYTHONPATH=$work/full/python within /usr/bin/python3 -c \
    'import meristem; print(meristem.read("oak").grow().measure()["height"])'
  title "compare the shipped plants"
  tests/systems/hashes.py "$program" >"$work/here.txt"
  within tests/systems/hashes.py "$work/full/bin/meristem" >"$work/there.txt"
  tests/systems/hashes.py --compare "$work/here.txt" "$work/there.txt"
}

make_root
need_packages
if [[ $mode == --quick ]]; then quick; else full; fi
title "done"
