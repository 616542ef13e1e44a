#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Peak memory of growth, as reported by the system. It does not depend on the speed of the program."""

import json
import unittest

import cli_case

BUSH = """{
  "meristem": 1,
  "components": {
    "field": {"type": "field", "rows": 20, "plants": %d},
    "star": {"type": "hydra", "number": 50},
    "crown": {"type": "hydra", "number": 20},
    "leaf": {"type": "leaf"}
  },
  "links": [["field", "star"], ["star", "crown"], ["crown", "leaf"]]
}"""

ONE_PARENT = """{
  "meristem": 1,
  "components": {"star": {"type": "hydra", "number": %d}, "leaf": {"type": "leaf"}},
  "links": [["star", "leaf"]]
}"""

ONE_STEM = """{
  "meristem": 1,
  "components": {"stem": {"type": "tree", "length": 20, "segments": 10}, "leaf": {"type": "leaf"}},
  "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": %d}]
}"""

STEMS = """{
  "meristem": 1,
  "components": {
    "field": {"type": "field", "rows": 100, "plants": %d},
    "stem": {"type": "tree", "length": 0.1, "segments": 1}
  },
  "links": [["field", "stem"]]
}"""

TWIGS = """{
  "meristem": 1,
  "components": {
    "field": {"type": "field", "rows": 10, "plants": %d},
    "stem": {"type": "tree", "length": 2, "segments": 10},
    "twig": {"type": "tree", "length": 0.1, "segments": 1}
  },
  "links": [["field", "stem"], {"from": "stem", "to": "twig", "kind": "branch", "count": 100}]
}"""

STAND = """{
  "meristem": 1,
  "components": {
    "row": {"type": "field", "rows": 1, "plants": %d, "spacing": 9},
    "oak": {"type": "document", "file": "oak", "set": {"age": 20}}
  },
  "links": [["row", "oak"]]
}"""

# Three limits are passed: points of trees, triangles of leaves, and plants of other documents.
MANY = """{
  "meristem": 1,
  "components": {
    "wood": {"type": "field", "rows": 50, "plants": 50},
    "oak": {"type": "colonize", "crown": {"sphere": {"centre": [0, 3, 0], "radius": 2}}, "points": 10000,
            "step": 0.1, "influence": 0.5, "kill": 0.2},
    "herb": {"type": "hydra", "number": 5000},
    "leaf": {"type": "leaf"},
    "bush": {"type": "document", "file": "box.json"}
  },
  "links": [["wood", "oak"], ["wood", "herb"], ["herb", "leaf"], ["wood", "bush"]]
}"""

NESTED = """{
  "meristem": 1,
  "components": {
    "a": {"type": "simple", "recursion": 100}, "b": {"type": "simple", "recursion": 100},
    "c": {"type": "simple", "recursion": 100}, "d": {"type": "simple", "recursion": 100}
  },
  "links": [["a", "b"], ["b", "c"], ["c", "d"], ["d", "d"], ["d", "c"], ["d", "b"], ["d", "a"]]
}"""


class MemoryTest(cli_case.Case):
    def peak(self, *arguments):
        """Returns the exit code and the peak memory of one run in bytes."""
        code, usage = self.resources(*arguments)
        return code, 1024 * usage.ru_maxrss

    def bytes_each(self, document, numbers, instances):
        """Returns the memory of one instance, from two runs whose documents differ by `instances` instances."""
        peaks = []
        for number in numbers:
            self.write("plants.json", document % number)
            code, peak = self.peak("grow", "plants.json", "-o", "plants.csv")
            self.assertEqual(code, cli_case.DONE)
            peaks.append(peak)
        return (peaks[1] - peaks[0]) / instances

    def test_a_leaf_takes_less_than_120_bytes(self):
        self.assertLess(self.bytes_each(BUSH, (10, 60), 1_000_000), 120)

    def test_a_child_of_a_parent_with_a_million_children_takes_less_than_120_bytes(self):
        self.assertLess(self.bytes_each(ONE_PARENT, (200_000, 1_200_000), 1_000_000), 120)

    def test_a_leaf_on_a_stem_with_a_million_leaves_takes_less_than_160_bytes(self):
        self.assertLess(self.bytes_each(ONE_STEM, (200_000, 1_200_000), 1_000_000), 160)

    def test_a_stem_of_two_nodes_takes_less_than_1500_bytes(self):
        self.assertLess(self.bytes_each(STEMS, (500, 2500), 200_000), 1500)

    def test_a_twig_that_joins_its_stem_takes_less_than_1200_bytes(self):
        self.assertLess(self.bytes_each(TWIGS, (50, 250), 200_000), 1200)

    def bytes_per_triangle(self, *arguments):
        """Returns the memory of more oaks, all of them different, divided by their triangles."""
        sizes = []
        for oaks in (3, 9):
            self.write("stand.json", STAND % oaks)
            code, peak = self.peak(arguments[0], "stand.json", *arguments[1:])
            self.assertEqual(code, cli_case.DONE)
            done = self.run_program("measure", "stand.json", "--only", "triangles", "--json")
            sizes.append((peak, json.loads(done.stdout)["triangles"]))
        return (sizes[1][0] - sizes[0][0]) / (sizes[1][1] - sizes[0][1])

    def test_more_oaks_of_a_stand_take_few_bytes_for_a_triangle(self):
        scan = ("scan", "-o", "stand.las", "--set", "instrument.step=5")
        self.assertLess(self.bytes_per_triangle(*scan), 120)
        render = ("render", "-o", "stand.png", "--size", "40x30", "--samples", "1")
        self.assertLess(self.bytes_per_triangle(*render), 130)
        self.assertLess(self.bytes_per_triangle("measure", "-o", "stand.csv", "--each"), 30)

    def test_counts_are_checked_at_once_before_growth(self):
        self.write("many.json", MANY)
        code, peak = self.peak("grow", "many.json", "-o", "many.glb")
        self.assertEqual(code, cli_case.WRONG_INPUT)
        self.assertLess(peak, 100_000_000)
        errors = self.assert_ends(cli_case.WRONG_INPUT, "grow", "many.json", "-o", "many.glb")
        for fault in ("attraction points, of which oak 2.5e+07 (100 %)", "triangles, of which leaf",
                      "2500 different plants of other documents, of which bush 2500 (100 %)"):
            self.assertIn(fault, errors)

    def test_nested_recursions_are_refused_before_memory_is_spent(self):
        self.write("nested.json", NESTED)
        code, peak = self.peak("grow", "nested.json", "-o", "nested.csv")
        self.assertEqual(code, cli_case.WRONG_INPUT)
        self.assertLess(peak, 400_000_000)


if __name__ == "__main__":
    unittest.main()
