#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Documents that place the plants of others, and tables of places. Usage: gardens_test.py PROGRAM [unittest options]"""

import collections
import csv
import io
import json
import struct
import unittest

import cli_case
from cli_case import DONE, WRONG_INPUT

GARDEN = """{
  "meristem": 1,
  "components": {
    "trees": {"type": "places", "table": "trees.csv", "choose": "kind"},
    "oak": {"type": "document", "file": "twig.json", "set": {"age": "years"}, "seed": 1}
  }
}"""
TWIG = """{
  "meristem": 1,
  "variables": {"age": {"value": 2, "min": 1, "max": 9}},
  "components": {"stem": {"type": "tree", "length": "age"}, "leaf": {"type": "leaf"}},
  "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": 5}]
}"""


class Gardens(cli_case.Case):
    def setUp(self):
        super().setUp()
        self.write("garden.json", GARDEN)
        self.write("twig.json", TWIG)
        self.write("trees.csv", "x,y,kind,years\n0,0,oak,2\n5,1,oak,4\n9,2,oak,2\n")

    def gltf(self, name):
        data = self.read(name)
        return len(data), json.loads(data[20:20 + struct.unpack("<I", data[12:16])[0]])

    def test_a_street_of_two_hundred_trees_is_one_small_file(self):
        self.assert_ends(DONE, "grow", "street", "-o", "street.glb")
        size, gltf = self.gltf("street.glb")
        self.assertLess(size, 80e6)
        plants = [gltf["nodes"][child]["name"].rsplit(" ", 1)[0] for child in gltf["nodes"][0]["children"]]
        trees = collections.Counter(name for name in plants if name in ("oak", "lime", "birch"))
        self.assertEqual(sum(trees.values()), 200)
        self.assertEqual(len(trees), 3)
        # Three species of three ages each are nine meshes of stems, at most.
        trunks = [mesh for mesh in gltf["meshes"] if mesh["name"] in ("oak.tree", "lime.tree", "birch.trunk")]
        self.assertLessEqual(len(trunks), 9)

    def test_tables_have_the_nodes_of_each_place(self):
        self.assert_ends(DONE, "grow", "garden.json", "-o", "garden.csv")
        rows = self.read("garden.csv").decode().splitlines()
        head = rows[0].split(",")
        instances = {tuple(row.split(",")[head.index(name)] for name in ("component", "instance")) for row in rows[1:]}
        self.assertEqual(instances, {("oak.stem", "0"), ("oak.stem", "1"), ("oak.stem", "2")})

    def test_measures_count_each_place(self):
        self.assert_ends(DONE, "measure", "garden.json", "--each", "--json", "--organs", "leaves.csv", "-o", "garden.txt")
        trees = json.loads(self.read("garden.txt"))["each"]
        self.assertEqual([(tree["component"], tree["row"]) for tree in trees],
                         [("oak.stem", 0), ("oak.stem", 2), ("oak.stem", 1)])
        self.assertEqual([tree["position"] for tree in trees], [[0, 0, 0], [9, 0, -2], [5, 0, -1]])
        self.assertEqual([tree["leaf_count"] for tree in trees], [5, 5, 5])
        leaves = list(csv.DictReader(io.StringIO(self.read("leaves.csv").decode())))
        for number, tree in enumerate(trees):
            areas = [float(leaf["area"]) for leaf in leaves if leaf["tree"] == str(number)]
            self.assertAlmostEqual(sum(areas), tree["leaf_area"], places=6)

    def faults(self, table):
        self.write("trees.csv", table)
        return self.assert_ends(WRONG_INPUT, "check", "garden.json")

    def test_faults_of_tables_name_line_and_column(self):
        self.assertIn("'trees.csv:3:3': 'far' in the column 'y' is not a number", self.faults("x,y,kind,years\n0,0,oak,2\n1,far,oak,2\n"))
        self.assertIn("did you mean 'kinds'", self.faults("x,y,kinds,years\n0,0,oak,2\n"))
        self.assertIn("'years' is a column of texts: 'old' stands in line 2", self.faults("x,y,kind,years\n0,0,oak,old\n"))
        self.assertIn("the row has 3 cells", self.faults("x,y,kind,years\n0,0,oak\n"))
        self.assertIn("has no rows", self.faults("x,y,kind,years\n"))

    def test_ten_million_rows_are_refused_before_they_are_read(self):
        self.assertIn("the table has 10000000 rows", self.faults("x,y,kind,years\n" + 10_000_000 * "0,0,oak,2\n"))

    def test_documents_that_use_each_other_are_named_in_order(self):
        self.write("a.json", '{"meristem": 1, "components": {"b": {"type": "document", "file": "b.json"}}}')
        self.write("b.json", '{"meristem": 1, "components": {"a": {"type": "document", "file": "a.json"}}}')
        self.assertIn("a.json -> b.json -> a.json contain each other in a circle", self.assert_ends(WRONG_INPUT, "check", "a.json"))


if __name__ == "__main__":
    unittest.main()
