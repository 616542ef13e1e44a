#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests that prose_rule.py finds each kind of error, in small artificial source trees."""

import shutil
import tempfile
import unittest
from pathlib import Path

import prose_rule

HEADER = "tests/support/check_sentence.h"


class ProseRule(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name)
        (self.root / HEADER).parent.mkdir(parents=True)
        shutil.copy(Path(__file__).parents[2] / HEADER, self.root / HEADER)

    def faults(self, name: str, text: str) -> list[str]:
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        faults = prose_rule.check(self.root, least=0)
        path.unlink()
        return faults

    def assert_fault(self, name: str, text: str, fault: str) -> None:
        self.assertEqual(self.faults(name, text), [f"{name}:{fault}"])

    def test_pages(self) -> None:
        self.assertEqual(self.faults("a.md", "A tree. It grows. Of course.\n\n```\nSo many lines.\n```\n"), [])
        self.assert_fault("a.md", "# Trees\n\nA tree grows.\nSo many trees.\n", "4: a sentence opens with 'So many'")
        self.assert_fault("a.md", "| key | text |\n| --- | --- |\n| the angle by\twhich | x |\n", "3: has 'by which'")
        self.assertEqual(self.faults("a.md", "The words `by which` stand in code.\n"), [])

    def test_comments_of_sources(self) -> None:
        self.assert_fault("a.h", "int a;\n/// A leaf.\n/// Of the largest.\nint b;\n", "3: a sentence opens with 'Of'")
        self.assert_fault("a.cpp", "int a;  // By which it turns.\n", "1: a sentence opens with 'By which'")
        self.assert_fault("a.ts", "// the angle by\n// which it turns\n", "1: has 'by which'")
        self.assertEqual(self.faults("a.cpp", 'const char* a = "So many leaves.";\n'), [])

    def test_comments_of_python(self) -> None:
        self.assert_fault("a.py", 'def leaf():\n    """Of the tree."""\n', "2: a sentence opens with 'Of'")
        self.assert_fault("a.py", "a = 1\n# In its stead.\n", "2: a sentence opens with 'In its'")
        self.assertEqual(self.faults("a.py", 'a = "Of the tree."\n'), [])

    def test_variables_of_shipped_documents(self) -> None:
        def document(sentence: str) -> str:
            return '{\n  "lean": {"value": 1, "doc": "' + sentence + '"}\n}\n'

        self.assertEqual(self.faults("models/a.json", document("Lean of the stem.")), [])
        for sentence, fault in (
            ("Its lean.", "opens with 'Its '"),
            ("Lean of the stem", "does not end with a full stop"),
            ("The angle by which it leans.", "has 'by which'"),
            (f"Lean{' far' * 60}.", "is too long for a tooltip"),
        ):
            self.assert_fault("models/a.json", document(sentence), f"2: the sentence of 'lean' {fault}")

    def test_a_rule_that_reads_nothing_is_broken(self) -> None:
        self.assertEqual(len(prose_rule.check(self.root)), 1)


if __name__ == "__main__":
    unittest.main()
