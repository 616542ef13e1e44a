#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests that link_rule.py finds each kind of error, in small artificial source trees."""

import tempfile
import unittest
from pathlib import Path

import link_rule


class LinkRule(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name)
        self.write("docs/manual.md", "# Manual\n\n## Twigs and `leaves`\n\n## Twigs and leaves\n")
        self.write("docs/pictures.md", "# Pictures\n\n![An oak](oak.jpg)\n")
        self.write("README.md", "# Trees\n\nRead [the manual](docs/manual.md), see [pictures](docs/pictures.md).\n")
        self.write("docs/oak.jpg", "")

    def write(self, name: str, text: str) -> None:
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text, encoding="utf-8")

    def faults(self) -> list[str]:
        return link_rule.check(self.root, least=0)

    def assert_good(self, sentence: str) -> None:
        self.write("docs/manual.md", f"# Manual\n\n## Twigs and `leaves`\n\n## Twigs and leaves\n\n{sentence}\n")
        self.assertEqual(self.faults(), [])

    def assert_fault(self, sentence: str, fault: str) -> None:
        self.write("docs/manual.md", f"# Manual\n\n{sentence}\n")
        self.assertEqual(self.faults(), [f"docs/manual.md:3: {fault}"])

    def test_good_links(self) -> None:
        for sentence in ("[start](../README.md#trees)", "[twigs](#twigs-and-leaves), [again](manual.md#twigs-and-leaves-1)",
                         "[the folder](../docs)", "![An oak](oak.jpg)", "[![An oak](oak.jpg)](../README.md)",
                         "[elsewhere](https://example.org/none)", "`[code](none.md)`", "```\n[code](none.md)\n```"):
            self.assert_good(sentence)

    def test_a_missing_file(self) -> None:
        self.assert_fault("[none](none.md)", "none.md: there is no such file")
        self.assert_fault("![none](none.jpg)", "none.jpg: there is no such file")
        self.assert_fault("[![An oak](oak.jpg)](none.md)", "none.md: there is no such file")
        self.assert_fault("[![An oak](none.jpg)](../README.md)", "none.jpg: there is no such file")

    def test_a_missing_heading(self) -> None:
        self.assert_fault("[none](#none)", "#none: the page has no such heading")
        self.assert_fault("[none](../README.md#manual)", "../README.md#manual: the page has no such heading")
        self.assert_fault("[none](oak.jpg#oak)", "oak.jpg#oak: the page has no such heading")

    def test_what_is_no_picture(self) -> None:
        self.assert_fault("![no picture](../README.md)", "../README.md: is no picture")

    def test_a_link_out_of_the_repository(self) -> None:
        self.assert_fault("[up](../../etc)", "../../etc: leads out of the repository")

    def test_other_forms(self) -> None:
        self.assert_fault('<img src="oak.jpg">', "<img: links have the form [text](target)")
        self.assert_fault("[the oak][oak]", "][oak]: links have the form [text](target)")
        self.assert_fault("[oak]: oak.jpg", "[oak]:: links have the form [text](target)")

    def test_a_page_that_no_link_leads_to(self) -> None:
        self.write("docs/lost.md", "# Lost\n")
        self.assertEqual(self.faults(), ["docs/lost.md:1: no link leads here from README.md"])

    def test_a_picture_that_no_page_shows(self) -> None:
        self.write("docs/manual/elm.png", "")
        self.assertEqual(self.faults(), ["docs/manual/elm.png:1: no page shows this picture"])

    def test_a_rule_that_reads_nothing_is_broken(self) -> None:
        self.assertEqual(len(link_rule.check(self.root)), 1)

    def test_targets_are_replaced_where_they_stand(self) -> None:
        text = "[a](x.md) `[b](x.md)` [![c](x.jpg)](x.md#d)\n"
        replaced = link_rule.with_targets(text, lambda link: "P" if link.is_picture else "Q")
        self.assertEqual(replaced, "[a](Q) `[b](x.md)` [![c](P)](Q)\n")


if __name__ == "__main__":
    unittest.main()
