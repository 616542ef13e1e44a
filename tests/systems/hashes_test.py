#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""hashes.py names the documents that grow to different files on two systems."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

HASHES = pathlib.Path(__file__).parent / "hashes.py"


class Comparison(unittest.TestCase):
    def compare(self, first, second):
        """Returns the exit code and the lines that the comparison of two lists prints."""
        with tempfile.TemporaryDirectory() as folder:
            paths = [pathlib.Path(folder) / name for name in ("first", "second")]
            for path, text in zip(paths, (first, second)):
                path.write_text(text, encoding="utf-8")
            done = subprocess.run([sys.executable, "-B", HASHES, "--compare", *paths], capture_output=True, encoding="utf-8")
        return done.returncode, done.stdout.splitlines()

    def test_equal_lists_pass_in_any_order(self):
        self.assertEqual(self.compare("12  oak\n34  elm\n", "34  elm\n12  oak\n"),
                         (0, ["2 documents have equal hashes, 0 do not"]))

    def test_names_differing_and_missing_documents(self):
        code, lines = self.compare("12  oak\n34  elm\n", "13  oak\n34  elm\n56  fir\n")
        self.assertEqual(code, 1)
        self.assertEqual(lines, ["fir: missing and 56", "oak: 12 and 13", "1 documents have equal hashes, 2 do not"])

    def test_an_empty_list_shows_nothing(self):
        self.assertEqual(self.compare("", "")[0], 1)


if __name__ == "__main__":
    unittest.main()
