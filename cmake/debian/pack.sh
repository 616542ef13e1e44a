#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Usage: pack.sh BUILD FOLDER
# Packs a finished build folder that has the program and the Python module. FOLDER gets the Debian packages and a wheel.
# Equal builds with equal SOURCE_DATE_EPOCH (seconds; by default the time of the commit) give equal bytes.
set -euo pipefail
root=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
build=$(readlink -f "$1")
mkdir -p "$2"
folder=$(readlink -f "$2")
epoch=$(git -C "$root" log -1 --format=%ct 2>/dev/null || stat -c %Y "$root/CHANGELOG.md")
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$epoch}
work=$folder/work
rm -rf "$work" "$folder"/*.deb "$folder"/*.whl
trap 'rm -rf "$work"' EXIT

cpack --config "$build/CPackConfig.cmake" -B "$work" >"$folder/pack.log" || {
  cat "$folder/pack.log"
  exit 1
}
mv "$work"/*.deb "$folder"

half=$work/wheel/python/meristem
mkdir -p "$half"
cp "$build"/python/meristem/_core*.so "$build/python/meristem/viewer.html" "$half"
strip --strip-unneeded "$half"/_core*.so
(cd "$root/python" && /usr/bin/python3 -B -c 'import sys, build_backend
build_backend.build_wheel(sys.argv[1], {"build-dir": sys.argv[2]})' "$folder" "$work/wheel")
