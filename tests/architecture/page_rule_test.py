#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests that page_rule.py finds each kind of error, in small artificial pages."""

import tempfile
import unittest
from pathlib import Path

import page_rule


class PageRule(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name).resolve()
        for folder in page_rule.ORDER:
            self.write(f"{folder}/a.ts", "export const a = 1;\n")
        self.write("studio.ts", "import { a } from './panels/a.ts';\n")
        self.write("main.tsx", "import { Studio } from './studio.ts';\n")

    def write(self, name: str, text: str) -> None:
        path = self.root / page_rule.PAGE / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def faults(self) -> list[str]:
        return [fault.text(self.root).removeprefix(page_rule.PAGE + "/") for fault in page_rule.check(self.root)]

    def assert_only_fault(self, *parts: str) -> None:
        faults = self.faults()
        self.assertEqual(len(faults), 1, faults)
        for part in parts:
            self.assertIn(part, faults[0])

    def test_a_page_that_keeps_the_rule_has_no_fault(self) -> None:
        self.write("rows/a.ts", "import {\n  a,\n} from '../page/a.ts';\nimport type { B } from './b.ts';\n")
        self.write("rows/b.ts", "// import { a } from '../panels/a.ts';\n/* from './a.ts' */\nexport type B = 1;\n")
        self.assertEqual(self.faults(), [])

    def test_a_folder_may_not_import_a_later_one(self) -> None:
        self.write("rows/a.ts", "// A row.\nimport {\n  a,\n} from '../editors/a.ts';\n")
        self.assert_only_fault("rows/a.ts:4:", "rows stands before editors", "'../editors/a.ts'")

    def test_imports_of_types_and_at_run_time_count(self) -> None:
        for text in ("import type { A } from '../panels/a.ts';", "export { a } from '../panels/a.ts';",
                     "const a = await import('../panels/a.ts');", "import '../panels/a.ts';"):
            self.write("base/a.ts", text + "\n")
            self.assert_only_fault("base/a.ts:1:", "base stands before panels")

    def test_only_the_entry_imports_the_model(self) -> None:
        self.write("workbench.ts", "import type { Studio } from './studio.ts';\n")
        self.assert_only_fault("workbench.ts:1:", "only main.tsx may import studio.ts")

    def test_no_folder_imports_the_entry(self) -> None:
        self.write("workbench.ts", "export const bench = 1;\n")
        self.write("panels/a.ts", "import { bench } from '../workbench.ts';\n")
        self.assert_only_fault("panels/a.ts:1:", "belongs to the entry")

    def test_files_do_not_import_each_other_in_a_circle(self) -> None:
        self.write("rows/a.ts", "import { b } from './b.ts';\n")
        self.write("rows/b.ts", "import { c } from './c.ts';\n")
        self.write("rows/c.ts", "import type { A } from './a.ts';\nimport { d } from './d.ts';\n")
        self.write("rows/d.ts", "export const d = 1;\n")
        self.assert_only_fault("rows/a.ts:1:", "3 files import each other", "rows/a.ts, rows/b.ts, rows/c.ts")

    def test_circles_are_told_apart_and_the_largest_comes_first(self) -> None:
        for one, other in (("a", "b"), ("b", "a"), ("c", "d"), ("d", "e"), ("e", "c")):
            self.write(f"rows/{one}.ts", f"import type {{ X }} from './{other}.ts';\n")
        self.write("rows/b.ts", "import type { X } from './a.ts';\nimport type { Y } from './c.ts';\n")
        faults = self.faults()
        self.assertEqual(len(faults), 2, faults)
        self.assertIn("3 files import each other", faults[0])
        self.assertIn("2 files import each other", faults[1])

    def test_every_folder_has_a_place_in_the_order(self) -> None:
        self.write("later/a.ts", "export const a = 1;\n")
        self.assert_only_fault("later:1:", "has no place in the order")

    def test_the_order_names_no_folder_that_is_gone(self) -> None:
        (self.root / page_rule.PAGE / "grass/a.ts").unlink()
        self.assert_only_fault("has no sources in grass")

    def test_imports_lead_to_files_of_the_page(self) -> None:
        self.write("rows/a.ts", "import { a } from '../base/gone.ts';\n")
        self.assert_only_fault("rows/a.ts:1:", "is no file")
        self.write("rows/a.ts", "import { a } from '../../test/a.ts';\n")
        self.assert_only_fault("rows/a.ts:1:", "outside of the page")

    def test_sources_stay_short(self) -> None:
        self.write("rows/a.ts", "\n" * page_rule.MAX_LINES)
        self.assertEqual(self.faults(), [])
        self.write("rows/a.ts", "\n" * (page_rule.MAX_LINES + 1))
        self.assert_only_fault("rows/a.ts:252:", "252 lines")


if __name__ == "__main__":
    unittest.main()
