#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests that the documentation site finds each kind of fault, in small artificial sources. Needs doxygen and Sphinx."""

from __future__ import annotations

import ast
import sys
import tempfile
import unittest
from pathlib import Path, PurePosixPath

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs" / "site"))
import build_site  # noqa: E402
import cpp_model  # noqa: E402
import prose  # noqa: E402
import python_model  # noqa: E402
import reference  # noqa: E402
import sidebar  # noqa: E402
import stage  # noqa: E402
import theme  # noqa: E402


class InAFolder(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name)

    def write(self, name: str, text: str) -> None:
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text, encoding="utf-8")


class CppModel(InAFolder):
    def read(self, body: str, head: str = "// Trees.\n") -> cpp_model.Header:
        self.write("meristem/plant/tree.h", f"{head}#pragma once\nnamespace meristem {{\n{body}\n}}\n")
        warnings = cpp_model.run_doxygen(self.root, self.root / "work", ["meristem/plant/tree.h"])
        self.assertEqual(warnings, [])
        return cpp_model.read_headers(self.root / "work" / "xml", self.root, ["meristem/plant/tree.h"])[0]

    def faults(self, body: str) -> list[str]:
        return [fault.partition(": ")[2] for fault in cpp_model.faults_of([self.read(body)])]

    def test_names_without_a_comment(self) -> None:
        self.assertEqual(self.faults("struct Tree {};"), ["struct Tree has no comment"])
        self.assertEqual(self.faults("int height();"), ["function height has no comment"])
        self.assertEqual(self.faults("enum class Habit { upright };"), ["enum Habit has no comment"])
        self.assertEqual(self.faults("/// A tree.\nstruct Tree {\n  double height = 1;\n  int age() const;\n};"),
                         ["variable Tree::height has no comment", "function Tree::age has no comment"])
        self.assertEqual(self.faults("/// A tree.\nstruct Tree {\n  struct Twig {};\n};"),
                         ["struct Tree::Twig has no comment"])
        self.assertEqual(self.faults("namespace wood {\nstruct Tree {};\n}"), ["struct wood::Tree has no comment"])

    def test_names_that_need_no_comment(self) -> None:
        self.assertEqual(self.faults("/// A tree.\nclass Tree {\n public:\n  Tree() = default;\n  ~Tree();\n"
                                     "  Tree(const Tree&) = delete;\n  bool operator==(const Tree&) const = default;\n"
                                     " private:\n  int age_;\n};"), [])
        self.assertEqual(self.faults("/// Grows.\nvoid grow(int);\nvoid grow(double);"), [])
        self.assertEqual(self.faults("int age;  ///< years"), [])

    def test_a_header_without_purpose(self) -> None:
        header = self.read("", head="")
        self.assertEqual(cpp_model.faults_of([header]),
                         ["meristem/plant/tree.h:1: the header does not state its purpose"])

    def test_the_head_of_a_header_may_have_code(self) -> None:
        header = self.read("", head="// Trees:\n//\n//   a {\n//     b;\n//   }\n//\n// - item\n//   more\n")
        self.assertEqual(list(prose.blocks_of(header.purpose)),
                         [("paragraph", "Trees:"), ("code", "a {\n  b;\n}"), ("item", "item more")])

    def test_rows_of_a_table_stay_lines(self) -> None:
        header = self.read("/// Ages:\n///\n/// | a | b |\n/// | --- | --- |\n/// | 1 | 2 |\nint age();")
        self.assertEqual(header.declarations[0].text, "Ages:\n\n| a | b |\n| --- | --- |\n| 1 | 2 |")
        self.assertEqual([kind for kind, _ in prose.blocks_of(header.declarations[0].text)], ["paragraph", "table"])

    def test_comments_stay_as_they_are(self) -> None:
        text = "Escapes `\\u001b`, \"#rrggbb\", optional<int>, a@b, 50 %, `child[first[k])`'s end -- and `x`."
        header = self.read(f"/// {text}\n///\n/// - one\n/// - two\nint age();")
        self.assertEqual(header.declarations[0].text, f"{text}\n\n- one\n\n- two")

    def test_signatures_are_written_as_in_the_source(self) -> None:
        header = self.read("/// A tree.\nstruct Tree {};\n"
                           "/// Grows.\ntemplate <class T>\nvoid grow(const Tree& tree, T* more = nullptr);")
        self.assertEqual(cpp_model.plain(header.declarations[1].signature),
                         "void grow(const Tree& tree, T* more = nullptr)")
        self.assertEqual(header.declarations[1].template, "template <class T>")
        linked = [piece.text for piece in header.declarations[1].signature if piece.target]
        self.assertEqual(linked, ["Tree"])


class PythonModel(unittest.TestCase):
    def test_signatures(self) -> None:
        [function] = ast.parse("def grow(self, time: float = 0.0, *, seed: int | None = None) -> Plant: ...").body
        assert isinstance(function, ast.FunctionDef)
        self.assertEqual(python_model.signature_text("grow", function, True),
                         "grow(time: float = 0.0, *, seed: int | None = None) -> Plant")

    def test_aliases_of_types(self) -> None:
        made = python_model.aliases_of('Wanted = Union[float, Tuple[float, float]]\nPath = Optional["os.PathLike[str]"]\n'
                                       'Reason = Literal["end"]\nCOUNT = 3\n')
        self.assertEqual(made, {"Wanted": "float | tuple[float, float]", "Path": "os.PathLike[str] | None",
                                "Reason": "Literal['end']"})

    def test_names_without_a_docstring(self) -> None:
        names = {"meristem": [python_model.Name("Plant", "class", "A plant.", [], [
            python_model.Name("age", "property", "", []), python_model.Name("__len__", "method", "", [])])]}
        self.assertEqual(python_model.faults_of(names), ["meristem.Plant.age has no docstring"])


class Prose(unittest.TestCase):
    def test_blocks(self) -> None:
        text = "Trees. Twigs\ngrow.\n\n    a = 1\n\n- one\n- two\n  more"
        self.assertEqual(list(prose.blocks_of(text)), [("paragraph", "Trees. Twigs grow."), ("code", "a = 1"),
                                                       ("item", "one"), ("item", "two more")])
        self.assertEqual(prose.first_sentence(text), "Trees.")
        self.assertEqual(prose.first_sentence("Node k has `child[a .. b]`. More."), "Node k has `child[a .. b]`.")

    def test_links(self) -> None:
        known = {"kNoNode": "no.html", "Plant": "plant.html", "grow": "grow.html", "MeshScene": "scene.html"}
        found = prose.inline("A `Plant` of grow() in a MeshScene. Plant it.", known.get)
        self.assertEqual([node["refuri"] for one in found for node in one.findall(prose.nodes.reference)],
                         ["plant.html", "grow.html", "scene.html"])


class Examples(InAFolder):
    def test_the_body_of_a_function_is_an_example(self) -> None:
        self.write("plant.cpp", "// Example of Skeleton: three nodes\n// of a twig.\nvoid twig() {\n  int a = 1;\n\n"
                                "  if (a) a = 2;\n}\n")
        self.assertEqual(reference.read_examples(self.root),
                         {"Skeleton": ("three nodes of a twig.", "int a = 1;\n\nif (a) a = 2;")})


class Pages(InAFolder):
    def test_links_to_sources_and_pictures_of_tables(self) -> None:
        self.write("models/oak.json", "{}")
        self.write("docs/oak.jpg", "")
        self.write("docs/b.md", "")
        site = stage.Site(self.root, self.root / "site", set(), set())
        text = "[oak](../models/oak.json) [b](b.md#c) [d](https://d.org)\n![an oak](oak.jpg)\n| ![an oak](oak.jpg) |"
        made = stage.staged_page(site, PurePosixPath("docs/a.md"), {PurePosixPath("docs/b.md")}, text)
        self.assertEqual(made, "[oak](source:models/oak.json) [b](b.md#c) [d](https://d.org)\n![an oak](oak.jpg)\n"
                               "| [![an oak](/thumbnails/docs/oak.jpg)](source:docs/oak.jpg) |")
        self.assertEqual(site.sources, {"models/oak.json", "docs/oak.jpg"})
        self.assertTrue((self.root / "site/docs/oak.jpg").exists())

    def test_links_to_nothing_stay_for_sphinx(self) -> None:
        site = stage.Site(self.root, self.root / "site", set(), set())
        text = "[a](../none.json) ![b](none.jpg) [c](none.md)"
        self.assertEqual(stage.staged_page(site, PurePosixPath("docs/a.md"), set(), text), text)
        self.assertEqual(site.sources, set())

    def test_broken_links(self) -> None:
        self.write("a.html", '<a href="b.html#here">b</a> <a href="b.html#there">b</a> <a href="c.html">c</a> '
                             '<a class="x" href="https://d.org">d</a> <img alt="" src="e.png">')
        self.write("b.html", '<p id="here"></p>')
        self.assertEqual(build_site.broken_links(self.root),
                         ["a.html: b.html#there: the page has no such place", "a.html: c.html: there is no such file",
                          "a.html: e.png: there is no such file"])


class Sidebar(unittest.TestCase):
    def test_links_are_those_of_the_page(self) -> None:
        html = ('<a href="#">plant</a> <a href="base.html">base</a> <a href="../../README.html">a</a> '
                '<a href="https://d.org">d</a>')
        page = "reference/cpp/plant/mtg/mtg"
        moved = sidebar.moved(html, page, sidebar.owner_of(page) or "")
        self.assertEqual(moved, '<a href="../../plant.html">plant</a> <a href="../../base.html">base</a> '
                                '<a href="../../../../README.html">a</a> <a href="https://d.org">d</a>')
        self.assertIsNone(sidebar.owner_of("reference/cpp/plant"))


class Theme(unittest.TestCase):
    def test_systems_that_prefer_dark_pages_get_them(self) -> None:
        css = '@import url(/javascript/a.css);\n@media not print {\n  body[data-theme="dark"] {\n    --a: b; } }\n'
        made = theme.mended_style(css)
        self.assertNotIn("@import", made)
        self.assertRegex(made, r'prefers-color-scheme: dark\) \{\s+body:not\(\[data-theme="light"\]\) \{\s+--a: b; \}')
        self.assertEqual(theme.mended_style(made), made)


if __name__ == "__main__":
    unittest.main()
