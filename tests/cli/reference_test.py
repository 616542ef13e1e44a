#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that a page of the manual ends with the output of the program. Usage: reference_test.py PROGRAM PAGE
COMMAND"""

import difflib
import subprocess
import sys

program, page, command = sys.argv[1:]
printed = subprocess.run([program, command, "--markdown"], check=True, stdout=subprocess.PIPE).stdout.decode()
with open(page, encoding="utf-8") as file:
    written = file.read()
begin = max(written.find(printed.splitlines(True)[0]), 0)
if written[begin:] != printed:
    sys.stdout.writelines(difflib.unified_diff(written[begin:].splitlines(True), printed.splitlines(True), page,
                                               "the tables"))
    sys.exit(f"The page is out of date; its end is what this prints:\n  {program} {command} --markdown")
