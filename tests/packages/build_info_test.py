#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A build knows the commit of its sources. Usage: build_info_test.py CMAKE ROOT [unittest options]"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CMAKE, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])


class BuildInfo(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = pathlib.Path(folder.name, "tree")
        self.tree.mkdir()
        self.source = pathlib.Path(folder.name, "build_info.cpp")

    def git(self, *arguments: str) -> str:
        command = ["git", "-C", str(self.tree), "-c", "user.name=x", "-c", "user.email=x@localhost", *arguments]
        return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.strip()

    def written(self, tree: pathlib.Path) -> str:
        subprocess.run([CMAKE, f"-DSOURCE={tree}", f"-DOUTPUT={self.source}", "-P",
                        str(ROOT / "cmake/write_build_info.cmake")], check=True)
        return self.source.read_text(encoding="utf-8")

    def test_names_the_commit_and_changes_with_it_only(self) -> None:
        self.git("init", "-q")
        self.git("commit", "-q", "--allow-empty", "-m", "one")
        self.assertIn(f'return "{self.git("rev-parse", "--short=8", "HEAD")}";', self.written(self.tree))
        time = self.source.stat().st_mtime_ns
        self.written(self.tree)
        self.assertEqual(self.source.stat().st_mtime_ns, time)
        self.git("commit", "-q", "--allow-empty", "-m", "two")
        self.assertIn(f'return "{self.git("rev-parse", "--short=8", "HEAD")}";', self.written(self.tree))

    def test_a_tree_without_git_has_no_commit(self) -> None:
        self.assertIn('return "";', self.written(self.tree))

    def test_a_tree_inside_another_project_has_no_commit(self) -> None:
        self.git("init", "-q")
        self.git("commit", "-q", "--allow-empty", "-m", "one")
        inner = self.tree / "meristem-0.1.0"
        inner.mkdir()
        self.assertIn('return "";', self.written(inner))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
