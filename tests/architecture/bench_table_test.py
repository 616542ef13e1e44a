#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the table of `./dev bench` begins with the requested figures that are not met. Usage: bench_table_test.py
DEV"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

FIGURES = """\
plain\t1 ms\treference\t2.0\t\t
good\t2 ms\t\t\t<= 10\theld
missed\t3 ms\t\t\t<= 1\tNOT HELD
late\t4 ms\t\t\t<= 2\tnot held
"""

show_figures = re.search(r"^show_figures\(\) \{.*?^\}", Path(sys.argv[1]).read_text(encoding="utf-8"), re.M | re.S)
assert show_figures, "dev has no function show_figures"
with tempfile.TemporaryDirectory() as folder:
    table = Path(folder, "table.tsv")
    table.write_text(FIGURES, encoding="utf-8")
    shown = subprocess.run(["bash", "-c", f"{show_figures[0]}\nshow_figures"], check=True, text=True,
                           env={**os.environ, "MERISTEM_BENCH_TABLE": str(table)}, stdout=subprocess.PIPE).stdout
rows = [line.split()[0] for line in shown.splitlines()]
assert rows == ["figure", "missed", "late", "plain", "good", "1"], shown
assert shown.endswith("1 of 3 asked figures are held\n"), shown
