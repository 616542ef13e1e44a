#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the variables of shipped plants made of components (without growth models) have an effect. Each plant is
grown with the smallest and the largest value of each variable, and both plants must differ.

Usage: variables_test.py PROGRAM REPOSITORY
"""

import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile

GROWING = {"colonize", "lsystem", "organize", "document"}

program, repository = sys.argv[1], pathlib.Path(sys.argv[2])
failures = 0


def read(path):
    return json.loads(re.sub(r"^\s*//.*$", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE))


def grown(path, setting, folder):
    """Returns the hash of the grown plant, or None after a failure."""
    global failures
    target = pathlib.Path(folder) / "plant.glb"
    command = [program, "grow", str(path), "--set", setting, "--instanced", "-q", "-o", str(target)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    if done.returncode == 0 and "warning" not in done.stderr:
        return hashlib.sha256(target.read_bytes()).hexdigest()
    failures += 1
    print(f"{path.name} {setting}:\n{done.stderr}")
    return None


plants = 0
with tempfile.TemporaryDirectory() as folder:
    for path in sorted((repository / "models").glob("*.json")):
        document = read(path)
        if GROWING & {component["type"] for component in document["components"].values()}:
            continue
        plants += 1
        for name, variable in document["variables"].items():
            if variable.get("private"):
                continue
            ends = {grown(path, f"{name}={variable[end]}", folder) for end in ("min", "max")}
            if len(ends) != 2:
                failures += 1
                print(f"{path.name}: '{name}' changes nothing, or does not grow")

print(f"{plants} plants, {failures} faults")
sys.exit(failures > 0 or plants == 0)
