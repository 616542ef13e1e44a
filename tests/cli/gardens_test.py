#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Documents that place plants of other documents, and tables of places. Usage: gardens_test.py PROGRAM [unittest
options]"""

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
        # Three species with three ages each give at most nine meshes of stems.
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

    def test_species_without_a_component_are_named_with_the_way_out(self):
        told = self.faults("x,y,kind,years\n0,0,oka,2\n")
        self.assertIn("'oka'", told)
        self.assertIn("did you mean 'oak'", told)

    def test_a_row_in_an_obstacle_is_told_by_its_line(self):
        document = json.loads(GARDEN)
        document["scene"] = {"obstacles": [{"box": [[4, 0, -2], [6, 3, 0]]}]}
        self.write("garden.json", json.dumps(document))
        self.assertIn("line 3 of 'trees.csv' stands within an obstacle", self.assert_ends(WRONG_INPUT, "check", "garden.json"))

    def test_degrees_become_metres_about_the_middle(self):
        self.write("trees.csv", "lon,lat,kind,years\n10,60,oak,2\n10.001,60,oak,2\n10,60.001,oak,2\n")
        self.assert_ends(DONE, "grow", "garden.json", "-o", "garden.csv")
        rows = [line.split(",") for line in self.read("garden.csv").decode().splitlines()]
        head = rows[0]
        roots = [(float(row[head.index("x")]), float(row[head.index("z")])) for row in rows[1:] if row[head.index("parent")] == ""]
        east = max(x for x, _ in roots) - min(x for x, _ in roots)
        north = max(z for _, z in roots) - min(z for _, z in roots)
        self.assertAlmostEqual(north, 111.2, delta=0.1)
        self.assertAlmostEqual(east, 111.2 / 2, delta=0.1)

    def test_limits_of_the_garden_hold_for_its_plants(self):
        told = self.assert_ends(WRONG_INPUT, "grow", "garden.json", "--set", "limits.instances=4", "-o", "garden.glb")
        self.assertIn("limits.instances", told)

    def test_what_is_set_and_does_not_exist_is_told_with_the_nearest_name(self):
        self.write("garden.json", GARDEN.replace('{"age": "years"}', '{"agee": 2}'))
        self.assertIn("did you mean 'age'", self.assert_ends(WRONG_INPUT, "check", "garden.json"))
        self.write("garden.json", GARDEN.replace('{"age": "years"}', '{"age": 20}'))
        self.assertIn("1 to 9", self.assert_ends(WRONG_INPUT, "check", "garden.json"))

    def test_trees_of_a_table_of_cylinders_go_on_growing(self):
        self.write("qsm.txt", "radius\tlength\tstart_x\tstart_y\tstart_z\taxis_x\taxis_y\taxis_z\tparent\textension\tbranch\n"
                   "0.1\t1\t5\t5\t0\t0\t0\t1\t0\t2\t1\n0.08\t0.5\t5\t5\t1\t0\t0\t1\t1\t0\t1\n0.05\t1\t5\t5\t1\t0.6\t0\t0.8\t1\t0\t2\n")
        self.write("tree.json", '{"meristem": 1, "components": {"tree": {"type": "organize", "iterations": 5, '
                   '"skeleton": {"file": "qsm.txt"}}}}')
        self.assert_ends(DONE, "grow", "tree.json", "-o", "tree.mtg", "-o", "tree.glb")
        # A tree also continues from a written file.
        self.write("again.json", '{"meristem": 1, "components": {"tree": {"type": "organize", "iterations": 2, '
                   '"skeleton": {"file": "tree.mtg"}}}}')
        self.assert_ends(DONE, "grow", "again.json", "-o", "again.csv")
        self.assertGreater(len(self.read("again.csv").splitlines()), 30)

    def test_what_a_file_of_a_tree_lacks_is_told_with_its_line(self):
        self.write("nodes.csv", "x,y,z,parent\n0,0,0,-1\n0,0,one,0\n")
        self.write("tree.json", '{"meristem": 1, "components": {"tree": {"type": "organize", "skeleton": {"file": "nodes.csv"}}}}')
        told = self.assert_ends(WRONG_INPUT, "check", "tree.json")
        self.assertIn("components.tree.skeleton.file", told)
        self.assertIn("nodes.csv:3", told)

    def test_numbers_of_tables_have_the_ranges_of_documents(self):
        self.assertIn("'trees.csv:3:1': 1e+30 in the column 'x' is out of its range", self.faults("x,y,kind,years\n0,0,oak,2\n1e30,0,oak,2\n"))
        self.assertIn("a number from -90 to 90", self.faults("lon,lat,kind,years\n0,91,oak,2\n"))
        told = self.faults("x,y,kind,years,scale,rotation\n0,0,oak,2,0,0\n1,1,oak,2,-1,1e30\n")
        self.assertIn("'trees.csv:2:11': 0 in the column 'scale' is out of its range", told)
        self.assertIn("'trees.csv:3:14': 1e+30 in the column 'rotation' is out of its range", told)
        self.assertIn("'trees.csv:2:9': '1e308' in the column 'years' is out of range", self.faults("x,y,kind,years\n0,0,oak,1e308\n"))

    def test_documents_that_multiply_each_other_are_stopped(self):
        """A hundred times a hundred times a hundred ...: the plants are counted during growth, at all levels
        together."""
        for level in range(1, 6):
            self.write(f"{level}.json", '{"meristem": 1, "components": {"rows": {"type": "field", "rows": 10, "plants": 10}, '
                       f'"next": {{"type": "document", "file": "{level + 1}.json"}}}}, "links": [["rows", "next"]]}}')
        self.write("6.json", '{"meristem": 1, "components": {"leaf": {"type": "leaf", "rows": 1}}}')
        told = self.assert_ends(WRONG_INPUT, "grow", "1.json", "-o", "plants.glb")
        self.assertIn("the plants of other documents have more than 10000 plants in them", told)

    def test_ten_million_rows_are_refused_before_they_are_read(self):
        self.assertIn("the table has 10000000 rows", self.faults("x,y,kind,years\n" + 10_000_000 * "0,0,oak,2\n"))

    def test_documents_that_use_each_other_are_named_in_order(self):
        self.write("a.json", '{"meristem": 1, "components": {"b": {"type": "document", "file": "b.json"}}}')
        self.write("b.json", '{"meristem": 1, "components": {"a": {"type": "document", "file": "a.json"}}}')
        self.assertIn("a.json -> b.json -> a.json contain each other in a circle", self.assert_ends(WRONG_INPUT, "check", "a.json"))


if __name__ == "__main__":
    unittest.main()
