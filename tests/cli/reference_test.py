#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The manual's reference page is what the program prints. Usage: reference_test.py PROGRAM PAGE"""

import difflib
import subprocess
import sys

program, page = sys.argv[1:]
printed = subprocess.run([program, "components", "--markdown"], check=True, stdout=subprocess.PIPE).stdout.decode()
with open(page, encoding="utf-8") as file:
    written = file.read()
if written != printed:
    sys.stdout.writelines(difflib.unified_diff(written.splitlines(True), printed.splitlines(True), page, "the tables"))
    sys.exit(f"The page is out of date; write it anew with:\n  {program} components --markdown > {page}")
