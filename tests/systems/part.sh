#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compiles the sources that include a library, and builds and runs the tests of the rooms `base` and `scene`.
# tests/systems/debian.sh --quick runs this script in the root of another release.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."

jobs=$(nproc)
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime CCACHE_COMMENTS=yes RC_PARAMS=${RC_PARAMS:-seed=1}

title() { printf '\n==== %s (%s s)\n' "$*" "$SECONDS"; }
fail() {
  printf 'part.sh: %s\n' "$*" >&2
  exit 1
}

# Configures a build folder with tests and with warnings as errors. Without optimization it compiles in half the time.
configure() {
  local folder=$1
  shift
  cmake --preset release -B "$folder" -DMERISTEM_TESTS=ON -DMERISTEM_WERROR=ON -DCMAKE_CXX_FLAGS_RELEASE=-O0 \
    -DMERISTEM_COLD_OPTIONS=-O0 -DMERISTEM_VALIJSON=/usr/include "$@" >"$folder.log" 2>&1 ||
    { cat "$folder.log"; fail "could not configure"; }
}

# Compiles each source alone that includes a library, as CMake would, without what its target waits for. One source of the
# bindings stands for all.
compile_users_of_libraries() {
  local folder=$1 library='(png|jpeglib|turbojpeg|libqhull_r|CLI|nlohmann|boost|zlib)[./]' commands
  commands=$({
    grep -rlE --include='*.cpp' --exclude-dir=node_modules --exclude='*_test.cpp' \
      "#include (<$library|\"meristem/base/embree\.h\"|\"meristem/shape/ray_trees\.h\")" meristem apps
    echo python/bindings/mesh.cpp
  } | grep -vE '^meristem/(base|scene)/' | python3 -c '
import json, os, re, sys
users = {os.path.abspath(line.strip()) for line in sys.stdin}
for entry in json.load(open(sys.argv[1])):
    if entry["file"] in users:
        output = os.path.join(entry["directory"], re.search(r" -o (\S+)", entry["command"])[1])
        os.makedirs(os.path.dirname(output), exist_ok=True)
        print("cd", entry["directory"], "&&", entry["command"])' "$folder/compile_commands.json")
  xargs -d '\n' -P "$jobs" -n 1 sh -c <<<"$commands"
  printf '%s sources compile\n' "$(wc -l <<<"$commands")"
}

title "build the tests of base and scene"
configure build/part
NINJA_STATUS='[%f/%t, %es] ' ninja -C build/part -j "$jobs" meristem_base_tests meristem_scene_tests |
  awk '!/^\[/ || ++steps % 20 == 0 { print; fflush() }'
for room in base scene; do
  title "run the tests of $room"
  # Tests of points in crowns use no library, and take most of the time without optimization.
  "build/part/bin/meristem_${room}_tests" --gtest_brief=1 --gtest_color=no --gtest_filter='-CrownPoints.*'
done
title "compile what includes a library"
configure build/sources -DMERISTEM_PYTHON_MODULE=ON -DCMAKE_UNITY_BUILD=OFF -DMERISTEM_PRECOMPILE=OFF
compile_users_of_libraries build/sources
