#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`meristem graph` from the user's view. Usage: graph_test.py PROGRAM SOURCE_FOLDER [unittest options]"""

import json
import sys
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import cli_case
from cli_case import DONE, WRONG_INPUT

SOURCE = Path(sys.argv.pop(1)).resolve()
SVG = "{http://www.w3.org/2000/svg}"

FIRST = {"meristem": 1,
         "components": {"A": {"type": "camera"}, "B": {"type": "simple"}, "C": {"type": "hydra", "number": 3},
                        "D": {"type": "simple", "recursion": 3}, "E": {"type": "simple"}},
         "links": [["A", "B"], ["B", "C"], ["C", "D"], ["D", "D"], {"from": "D", "to": "E", "kind": "leaf"}]}


class Graph(cli_case.Case):
    def setUp(self):
        super().setUp()
        self.write("first.json", json.dumps(FIRST))

    def graph(self, *arguments):
        done = self.run_program("graph", *arguments)
        self.assertEqual(done.returncode, DONE, done.stderr.decode())
        return done.stdout.decode()

    def names(self, *arguments):
        drawing = ElementTree.fromstring(self.graph(*arguments))
        return ["".join(text.itertext()) for text in drawing.iter(f"{SVG}text")]

    def test_draws_each_component_once_and_a_recursions_first_twice(self):
        self.assertEqual(sorted(self.names("first.json")), ["A", "B", "C", "D", "D", "E"])

    def test_draws_the_tree_of_instances_with_their_numbers(self):
        names = self.names("first.json", "--tree")
        self.assertEqual([name for name in sorted(names) if name.startswith("D")],
                         ["D11", "D12", "D13", "D21", "D22", "D23", "D31", "D32", "D33"])
        self.assertEqual(len(names), 3 + 9 + 3)

    def test_highlights_and_lists_what_a_parameter_affects(self):
        done = self.run_program("graph", "first.json", "--affects", "D.size", "-o", "d.svg")
        self.assertEqual((done.returncode, done.stderr.decode().strip()),
                         (DONE, "D.size affects 2 of 5 components: D; through it E"))
        self.assertEqual(self.read("d.svg").decode().count("#f2b84b"), 2, "the recursion's first component stands twice")
        errors = self.assert_ends(WRONG_INPUT, "graph", "first.json", "--affects", "D.sice")
        self.assertIn("'sice' is not a parameter of a simple; did you mean 'size'?", errors)

    def test_larger_trees_than_asked_for_are_an_error_that_names_a_component(self):
        errors = self.assert_ends(WRONG_INPUT, "graph", "first.json", "--tree", "--most", "10")
        self.assertIn("components.D: there are more than 10 instances", errors)

    def test_writes_the_same_bytes_to_a_file(self):
        self.assertEqual(self.graph("first.json", "-o", "first.svg"), "")
        self.assertEqual(self.read("first.svg").decode(), self.graph("first.json"))

    def test_all_shipped_plants_can_be_drawn(self):
        for model in sorted((SOURCE / "models").glob("*.json")):
            with self.subTest(model.stem):
                self.assertGreater(len(self.names(model.stem, "--types", "--quiet")), 1)

    def test_the_manuals_drawings_are_those_that_the_program_draws(self):
        figures = SOURCE / "docs" / "manual" / "figures"
        for line in (figures / "graphs.txt").read_text(encoding="utf-8").splitlines():
            if line.strip() and not line.startswith("#"):
                name, document, *options = line.split()
                with self.subTest(name):
                    drawing = self.graph(str(figures / f"{document}.json"), "--quiet", *options)
                    self.assertEqual((figures / f"{name}.svg").read_text(encoding="utf-8"), drawing)


if __name__ == "__main__":
    unittest.main()
