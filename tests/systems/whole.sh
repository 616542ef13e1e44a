#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Uses the source tree on this system as its users do: the program, the Python module, the studio, the tests and the
# packages. tests/systems/debian.sh runs this script in the root of another release.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."

title() { printf '\n==== %s (%s s)\n' "$*" "$SECONDS"; }
fail() {
  printf 'whole.sh: %s\n' "$*" >&2
  exit 1
}

title "the demo"
rm -f out/oak.*
./dev demo
[[ -s out/oak.glb && -s out/oak.png ]] || fail "the demo has left no oak"

title "the Python module"
./dev python
PYTHONPATH=build/release/python /usr/bin/python3 -B -c \
  'import meristem; print("height of the oak:", meristem.read("oak").grow().measure()["height"])'

title "the studio"
./dev studio oak --no-browser >out/studio.txt &
studio=$!
trap 'kill "$studio" 2>/dev/null || true' EXIT
until grep -qs 'http://' out/studio.txt; do
  kill -0 "$studio" 2>/dev/null || { cat out/studio.txt; fail "the studio has ended"; }
  sleep 1
done
/usr/bin/python3 -B - <<'END'
import gzip, re, urllib.request
address = re.search(r"http://\S+", open("out/studio.txt").read())[0]
page = gzip.decompress(urllib.request.urlopen(address + "page.js").read())
assert len(page) > 100_000, f"the page has {len(page)} bytes only"
print(f"the studio sends its page: {len(page)} bytes")
END
kill "$studio"
trap - EXIT

title "the tests"
./dev test
title "the packages"
./dev package --test
