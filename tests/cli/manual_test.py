#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every whole document in the manual is accepted, also by the grower. Usage: manual_test.py PROGRAM FOLDER

A block of ```json that begins with a brace and says "meristem" is a whole document; other blocks are parts.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

program, folder = sys.argv[1:]
documents = 0
failures = 0
for page in sorted(pathlib.Path(folder).glob("**/*.md")):
    text = page.read_text(encoding="utf-8")
    for block in re.finditer(r"^```json\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        if '"meristem"' not in block[1]:
            continue
        documents += 1
        with tempfile.TemporaryDirectory() as scratch:
            done = subprocess.run([program, "grow", "-", "-q", "-o", scratch + "/plant.glb"], input=block[1].encode(),
                                  stderr=subprocess.PIPE, timeout=120)
        if done.returncode != 0:
            failures += 1
            line = 1 + text.count("\n", 0, block.start())
            print(f"{page}:{line}: this document is refused:\n{done.stderr.decode()}")
print(f"{documents} documents, {failures} refused")
sys.exit(documents == 0 or failures > 0)
