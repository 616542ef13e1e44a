#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that every complete document in the manual is accepted and grows. Usage: manual_test.py PROGRAM FOLDER

A block of ```json that begins with a brace and contains "meristem" is a complete document; other blocks are parts. If
the paragraph before a block is `wrong.json`, the block shows errors and must be rejected.
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
    for block in re.finditer(r"^(`wrong\.json`:\n\n)?```json\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        is_wrong, content = block[1] is not None, block[2]
        if '"meristem"' not in content:
            continue
        documents += 1
        with tempfile.TemporaryDirectory() as scratch:
            done = subprocess.run([program, "grow", "-", "-q", "-o", scratch + "/plant.glb"], input=content.encode(),
                                  stderr=subprocess.PIPE, timeout=120)
        if (done.returncode != 0) != is_wrong:
            failures += 1
            line = 1 + text.count("\n", 0, block.start())
            print(f"{page}:{line}: this document is {'accepted' if is_wrong else 'refused'}:\n{done.stderr.decode()}")
print(f"{documents} documents, {failures} faults")
sys.exit(documents == 0 or failures > 0)
