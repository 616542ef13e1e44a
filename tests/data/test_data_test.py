#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The programs of this folder write the data that the repository has, README.md lists all files, and they stay small."""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
FOLDERS = ("grass", "reference", "trees")
MOST_BYTES = 300_000
ROW = re.compile(r"^\| `([\w/.]+)` \|.*\| (.*) \|$", re.MULTILINE)


def listed() -> dict[str, str]:
    """Returns the files of the table and what made them."""
    return dict(ROW.findall((HERE / "README.md").read_text(encoding="utf-8")))


def stored() -> list[str]:
    return sorted(str(path.relative_to(HERE)) for folder in FOLDERS for path in (HERE / folder).iterdir())


class TestData(unittest.TestCase):
    def test_each_file_is_listed(self) -> None:
        self.assertEqual(stored(), sorted(listed()))

    def test_files_are_as_their_programs_write_them(self) -> None:
        with tempfile.TemporaryDirectory() as scratch:
            for folder in FOLDERS:
                (Path(scratch) / folder).mkdir()
            for program in sorted(HERE.glob("make_*.py")):
                subprocess.run([sys.executable, "-B", str(program), scratch], check=True, timeout=120)
            for name, maker in listed().items():
                with self.subTest(name):
                    self.assertEqual((Path(scratch) / name).is_file(), maker.startswith("`make_"))
                    if maker.startswith("`make_"):
                        self.assertEqual((Path(scratch) / name).read_bytes(), (HERE / name).read_bytes())

    def test_all_is_small(self) -> None:
        self.assertLess(sum((HERE / name).stat().st_size for name in stored()), MOST_BYTES)


if __name__ == "__main__":
    unittest.main()
