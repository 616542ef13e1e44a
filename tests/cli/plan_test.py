#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`meristem plan`. Usage: plan_test.py PROGRAM [unittest options]"""

import csv
import io
import json
import unittest

import cli_case
from cli_case import DONE, WRONG_INPUT

TREE = {"type": "organize", "iterations": 10, "length": 0.1,
        "operations": [{"do": "cut", "from": 6, "every": 4, "shoots": "rank == 1 && length > 0.2", "above": 2}]}


class Plan(cli_case.Case):
    def setUp(self):
        super().setUp()
        self.write("pruned.json", json.dumps({"meristem": 1, "components": {"tree": TREE}}))

    def rows(self, name):
        return list(csv.DictReader(io.StringIO(self.read(name).decode())))

    def test_tells_each_cut_and_does_none(self):
        done = self.run_program("plan", "pruned.json")
        self.assertEqual(done.returncode, DONE, done.stderr)
        lines = done.stdout.decode().splitlines()
        self.assertTrue(lines)
        for line in lines:
            self.assertRegex(line, r"^components\.tree\.operations\[0\]: cut main(\.\d+)+( above metamer \d)? at \(.*\) m, \d+ metamers?, ")
        self.assertIn(f"{len(lines)} to do", done.stderr.decode())

    def test_writes_a_table_and_the_tree_before_and_after(self):
        self.assert_ends(DONE, "plan", "pruned.json", "-o", "cuts.csv", "--before", "before.csv", "--after", "after.csv")
        cuts, before, after = self.rows("cuts.csv"), self.rows("before.csv"), self.rows("after.csv")
        self.assertEqual({row["iteration"] for row in cuts}, {"10"})
        self.assertEqual(len(before), len(after) + sum(int(row["metamers"]) for row in cuts))
        places = {(row["label"], row["metamer"]): row for row in before}
        nodes = {row["node"]: row for row in before}
        for cut in cuts:
            # If a whole shoot is removed, the cut is at the end of the metamer that bears it.
            is_whole = cut["metamer"] == "0"
            first = places[cut["shoot"], "1" if is_whole else cut["metamer"]]
            node = nodes[first["parent"]] if is_whole else first
            self.assertAlmostEqual(float(node["x"]), float(cut["x"]), places=5)
            # The bud is on the bark there, and the wood beyond the cut has the recorded diameter.
            bud = [float(cut[f"bud_{axis}"]) for axis in "xyz"]
            beyond = first if is_whole else places[cut["shoot"], str(int(cut["metamer"]) + 1)]
            self.assertAlmostEqual(float(cut["diameter"]), 2 * float(beyond["radius"]), places=6)
            for axis, way in zip("xyz", bud):
                self.assertAlmostEqual(float(cut[f"bud_position_{axis}"]),
                                       float(cut[axis]) + float(node["radius"]) * way, places=5)
        # The table of the tree contains the removed metamers and the number of the operation.
        self.assertEqual(sum(row["plan_cut"] == "1" for row in before), sum(int(row["metamers"]) for row in cuts))
        self.assertEqual(sum(row["plan_cut"] == "0" for row in before), len(after))
        # The remaining metamers keep their positions.
        left = {(row["label"], row["metamer"]): row["y"] for row in after}
        for place, height in left.items():
            self.assertEqual(places[place]["y"], height)

    def test_records_the_growth_for_tables_that_tell_of_it(self):
        shrub = {"type": "colonize", "points": 30, "iterations": 3, "crown": {"profile": [[0.2, 0.5], [0.5, 1], [0, 1.5]]}}
        self.write("both.json", json.dumps({"meristem": 1, "components": {"tree": TREE, "shrub": shrub}}))
        self.assert_ends(DONE, "plan", "both.json", "-q", "--before", "b.points.csv", "--after", "a.points.csv")
        self.assertEqual(len(self.rows("b.points.csv")), 30)
        self.assertEqual(self.rows("a.points.csv"), self.rows("b.points.csv"))

    def test_the_tree_after_is_the_tree_that_is_grown_with_the_cuts(self):
        for model in ("shadow", "markers"):
            sets = ["--set", f"tree.light={{\"model\": \"{model}\"}}"]
            for ending in ("csv", "mtg", "ply", "operations.csv"):
                self.assert_ends(DONE, "plan", "pruned.json", *sets, "-q", "-o", "cuts.csv", "--after", f"after.{ending}")
                self.assert_ends(DONE, "grow", "pruned.json", *sets, "-q", "-o", f"done.{ending}")
                self.assertEqual(self.read(f"after.{ending}"), self.read(f"done.{ending}"), f"{model} {ending}")

    def test_reads_standard_input(self):
        rule = '{"do": "girdle", "shoots": "rank == 1", "share": 0.5}'
        done = self.run_program("plan", "-", "--rule", rule, "-o", "cuts.csv", input=self.read("pruned.json"))
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertIn("ring", {row["act"] for row in self.rows("cuts.csv")})

    def test_takes_a_rule(self):
        rule = '{"do": "girdle", "shoots": "rank == 1", "share": 0.5}'
        self.assert_ends(DONE, "plan", "pruned.json", "--rule", rule, "-o", "cuts.csv", "-q")
        self.assertIn("ring", {row["act"] for row in self.rows("cuts.csv")})
        self.assertIn("components.tree.operations[1]", {row["operation"] for row in self.rows("cuts.csv")})

    def test_a_wrong_rule_is_a_fault(self):
        wrong = '{"do": "prune", "shoots": "rank == 1"}'
        self.assertIn("operations[1].do", self.assert_ends(WRONG_INPUT, "plan", "pruned.json", "--rule", wrong))
        self.assertIn("--rule:1:7:", self.assert_ends(WRONG_INPUT, "plan", "pruned.json", "--rule", '{"do":'))
        self.assertIn("--rule cannot be", self.assert_ends(WRONG_INPUT, "plan", "pruned.json", "--rule", "7"))

    def test_rules_act_after_all_growth(self):
        summer = '{"do": "cut", "season": "summer", "shoots": "rank == 1", "above": 1}'
        self.assertIn("not in summer", self.assert_ends(WRONG_INPUT, "plan", "pruned.json", "--rule", summer))

    def test_a_document_without_such_trees_is_a_fault(self):
        self.assertIn("organize", self.assert_ends(WRONG_INPUT, "plan", "box.json"))

    def test_records_are_a_format_of_grow(self):
        self.assert_ends(DONE, "grow", "pruned.json", "-o", "done.operations.csv")
        self.assertEqual({row["iteration"] for row in self.rows("done.operations.csv")}, {"6", "10"})


if __name__ == "__main__":
    unittest.main()
