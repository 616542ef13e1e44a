#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Usage, as root: install_test.sh FOLDER
# Takes the packages and the wheel in FOLDER through their whole life in an empty Debian: installs the packages, uses them
# as their users do, removes them, and uses the wheel. Needs debootstrap and the machine's package source.
# The mounts live in a namespace of this process, so they end with it.
set -euo pipefail
[[ ${MERISTEM_IN_NAMESPACE:-} ]] || MERISTEM_IN_NAMESPACE=1 exec unshare --mount --propagation private "$0" "$@"

source=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
packages=$(readlink -f "$1")
work=$(mktemp -d /var/tmp/meristem-install-XXXXXX)
root=$work/root
log=$work/log.txt
clean_up() {
  umount -l "$root/proc" "$root/dev" 2>/dev/null || true
  rm -rf --one-file-system "$work"
}
trap clean_up EXIT

step() { printf 'install_test: %s\n' "$*"; }
fail() {
  printf 'install_test: FAILED: %s\n' "$*" >&2
  [[ ! -s $log ]] || tail -n 40 "$log" >&2
  exit 1
}

# Runs a script in the empty Debian, as root or as a user. The script stops at its first error.
as_root_inside() { chroot "$root" bash -euo pipefail -c "$1" >"$log" 2>&1 || fail "$2"; }
as_user_inside() {
  chroot --userspec=1000:1000 "$root" env -i PATH=/usr/bin:/bin HOME=/home/user LANG=C.UTF-8 \
    bash -euo pipefail -c "cd /home/user; $1" >"$log" 2>&1 || fail "$2"
}

release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
version=$(sed -nE 's/^VERSION_ID="?([0-9]+).*/\1/p' /etc/os-release)
step "an empty Debian $release"
mirror=$(apt-get indextargets --format '$(ORIGIN) $(CODENAME) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' |
  awk -v release="$release" '$1 == "Debian" && $2 == release && $3 == "main" { print $4; exit }')
[[ -n $mirror ]] || fail "the machine has no package source of Debian $release"
debootstrap --variant=minbase "$release" "$root" "$mirror" >"$log" 2>&1 || fail "debootstrap"
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
# A proxy, if this machine has one.
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"
cp /etc/resolv.conf "$root/etc/resolv.conf"
mkdir -p "$root/packages" "$root/home/user"
cp "$packages"/*.deb "$packages"/*.whl "$root/packages"
cp -r "$source/tests/consumer" "$root/home/user/consumer"
chown -R 1000:1000 "$root/home/user"
export DEBIAN_FRONTEND=noninteractive
install="apt-get install -y -qq --no-install-recommends"

step "the packages are installed with their dependencies"
as_root_inside "apt-get update -qq; $install /packages/*.deb" "the packages cannot be installed"
as_root_inside "dpkg -L meristem libmeristem-dev python3-meristem >/packages/files" "the list of files"
as_root_inside 'test -z "$(dpkg --verify meristem libmeristem-dev python3-meristem)"' \
  "installed files differ from those of the packages"

step "the program grows, prints its page, completes, and has the studio's page"
as_user_inside 'meristem --version | grep -E "^meristem [0-9.]+ \("
  meristem grow oak -o oak.glb; test "$(head -c 4 oak.glb)" = glTF
  meristem models | grep "^oak "
  test -z "$(meristem models --paths | grep -v "^/usr/share/meristem/models/")"
  zcat /usr/share/man/man1/meristem.1.gz | grep "SH COMMANDS"
  bash -n /usr/share/bash-completion/completions/meristem' "the program"
as_user_inside 'meristem studio --no-browser >address & studio=$!
  trap "kill $studio" EXIT
  for second in $(seq 30); do grep -q http address && break; sleep 1; done
  python3 -c "import gzip, re, urllib.request
address = re.search(r\"http://\S+\", open(\"address\").read())[0]
assert len(gzip.decompress(urllib.request.urlopen(address + \"page.js\").read())) > 100_000"' "the studio has no page"

step "the Python module grows"
as_user_inside 'python3 -c "import importlib.metadata, meristem
assert importlib.metadata.version(\"meristem\") == meristem.__version__
plant = meristem.read(\"oak\", set={\"age\": 6}).grow()
assert plant.measure()[\"height\"] > 0.5
plant.save_html(\"oak.html\")"; grep -q "<script" oak.html' "the Python module"

step "the consumer builds with CMake and with pkg-config"
as_root_inside "$install g++ cmake make" "the compiler"
as_user_inside 'cmake -S consumer -B by-cmake; cmake --build by-cmake
  mkdir by-pkg-config
  for program in grow_document grow_points own_component; do
    g++ -std=c++20 $(pkg-config --cflags meristem) consumer/$program.cpp $(pkg-config --libs meristem) \
      -o by-pkg-config/$program
  done
  for folder in by-cmake by-pkg-config; do
    cd /home/user/$folder
    ./grow_document /usr/share/meristem/models/oak.json age=10; ./grow_points; ./own_component
  done
  cmp /home/user/by-cmake/plant.glb /home/user/by-pkg-config/plant.glb' "the consumer"

step "the packages leave nothing behind"
as_root_inside "rm -r /home/user/*; apt-get purge -y -qq meristem libmeristem-dev python3-meristem" "removing the packages"
as_root_inside 'while read -r path; do [[ -d $path || ! -e $path ]] || echo "$path"; done </packages/files >/packages/left
  find / -xdev -iname "*meristem*" -not -path "/packages/*" -not -path "/proc/*" >>/packages/left
  cat /packages/left; test ! -s /packages/left' "files are left"

step "the wheel grows, with the libraries that README.md names"
libraries=$(sed -nE "s/^sudo apt-get install (libembree.*python3-venv) +# Debian $version$/\1/p" "$source/README.md")
[[ -n $libraries ]] || fail "README.md does not name the wheel's libraries on Debian $version"
as_root_inside "apt-get autoremove -y -qq; $install $libraries" "the wheel's libraries"
as_user_inside 'python3 -m venv --system-site-packages env; env/bin/pip install --no-index /packages/*.whl
  env/bin/python -c "import meristem; assert meristem.read(\"oak\", set={\"age\": 6}).grow().measure()[\"height\"] > 0.5"' \
  "the wheel"
step "passed"
