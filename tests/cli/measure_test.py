#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`meristem measure` on grown and digitised plants. Usage: measure_test.py PROGRAM [unittest options]"""

import csv
import io
import json
import unittest

import cli_case
from cli_case import DONE, FAILED, LONG_GROWTH, MTG, TREE, WRONG_INPUT


class Measuring(cli_case.Case):
    def measured(self, *arguments):
        done = self.run_program("measure", *arguments, "--json")
        self.assertEqual(done.returncode, DONE, done.stderr.decode())
        return json.loads(done.stdout)

    def test_table_has_a_line_for_each_measure(self):
        done = self.run_program("measure", "tree.json", "-q")
        self.assertEqual((done.returncode, done.stderr), (DONE, b""))
        listed = [line.split()[0] for line in self.run_program("measure", "--list").stdout.decode().splitlines()]
        self.assertEqual([line.split()[0] for line in done.stdout.decode().splitlines()], listed)
        self.assertEqual(list(self.measured("tree.json")), listed)

    def test_json_agrees_with_what_grew(self):
        measures = self.measured("tree.json", "--set", "points=200")
        grown = self.run_program("grow", "tree.json", "-o", "a.glb", "--set", "points=200").stderr.decode()
        self.assertIn(f'{measures["nodes"]} nodes, {measures["leaf_count"]} organs, {measures["triangles"]} triangles',
                      grown)
        self.assertEqual(measures["trees"], 1)
        self.assertEqual(sum(measures["order_histogram"]), measures["axes"])
        self.assertAlmostEqual(sum(measures["length_by_order"]), measures["length"])
        self.assertAlmostEqual(measures["pipe_exponent"], 2.4, places=3)

    def test_same_bytes_on_any_number_of_threads_and_a_file_or_standard_output(self):
        first = self.run_program("measure", "tree.json", "--json", "--threads", "1").stdout
        for threads in ("2", "8"):
            self.assert_ends(DONE, "measure", "tree.json", "--json", "--threads", threads, "-o", "measures.json")
            self.assertEqual(self.read("measures.json"), first)

    def test_each_tree_of_a_stand(self):
        trees = {name: {"type": "colonize", "crown": {"profile": [[0.2, 0.5], [1, 1], [0.2, 2]]}, "points": 100,
                        "step": 0.05, "influence": 0.5, "kill": 0.15, "frame": {"translate": [x, 0, 0]}}
                 for name, x in (("left", -3), ("right", 3))}
        self.write("stand.json", json.dumps({"meristem": 1, "components": trees}))
        measures = self.measured("stand.json", "--each")
        self.assertEqual((measures["trees"], len(measures["each"])), (2, 2))
        self.assertEqual(sum(tree["nodes"] for tree in measures["each"]), measures["nodes"])
        self.assertEqual(max(tree["height"] for tree in measures["each"]), measures["height"])
        self.assertNotIn("triangles", measures["each"][0])
        self.assertEqual([tree["row"] for tree in measures["each"]], [None, None])
        self.assertEqual([(tree["component"], tree["instance"], tree["position"]) for tree in measures["each"]],
                         [("left", 0, [-3, 0, 0]), ("right", 0, [3, 0, 0])])
        self.assertIn(b"\ntree 2: right 0, at 3, 0, 0\n", self.run_program("measure", "stand.json", "--each").stdout)

    def test_measures_hold_no_meshes_and_heed_no_limit_on_them(self):
        limited = json.loads(TREE)
        limited["limits"] = {"triangles": 1}
        self.write("limited.json", json.dumps(limited))
        self.assertEqual(self.measured("limited.json"), self.measured("tree.json"))
        whole, each = self.measured("tree.json"), self.measured("limited.json", "--each")
        meshes = {"triangles", "instances", "bytes"}
        self.assertEqual({name for name in whole if whole[name] != each[name]}, meshes)
        self.assertEqual({each[name] for name in meshes}, {None})
        self.assertEqual(len(each["each"]), whole["trees"])
        self.assertEqual(self.measured("limited.json", "--only", "height,leaf_area"),
                         {name: whole[name] for name in ("height", "leaf_area")})

    def test_only_named_measures(self):
        whole = self.measured("tree.json")
        self.assertEqual(self.measured("tree.json", "--only", "triangles", "--only", "nodes"),
                         {name: whole[name] for name in ("nodes", "triangles")})
        self.assertEqual(self.measured("tree.json", "--each", "--only", "triangles")["triangles"], whole["triangles"])
        self.assertGreater(self.measured("tree.json", "--only", "leaf_exposure")["leaf_exposure"], 0)
        text = self.run_program("measure", "tree.json", "--only", "height").stdout
        self.assertRegex(text.decode(), r"^height +[0-9.]+ m\n$")
        message = self.assert_ends(WRONG_INPUT, "measure", "tree.json", "--only", "height,leaf_aera")
        self.assertIn("there is no measure 'leaf_aera'", message)
        self.assertIn("did you mean 'leaf_area'?", message)

    def test_light_on_leaves_only_if_asked(self):
        self.assertEqual(self.measured("tree.json")["leaf_exposure"], None)
        self.write("walnut.mtg", MTG)
        self.assertEqual(self.measured("walnut.mtg", "--unit", "cm")["lit_share"], None)
        measures = self.measured("tree.json", "--light")
        self.assertGreater(measures["leaf_exposure"], measures["leaf_irradiance"])
        self.assertGreater(measures["leaf_irradiance"], 0)
        self.assertLess(measures["leaf_exposure"], 1)
        # Under a roof, no sun reaches the crown and the leaves.
        roofed = json.loads(TREE)
        roofed["scene"] = {"obstacles": [{"box": [[-9, 5, -9], [9, 6, 9]]}]}
        self.write("roofed.json", json.dumps(roofed))
        dark = self.measured("roofed.json", "--light")
        self.assertEqual([dark[name] for name in ("lit_share", "leaf_exposure", "leaf_irradiance")], [0, 0, 0])
        self.assertGreater(measures["lit_share"], 0)

    def test_table_of_organs_agrees_with_the_means(self):
        self.assert_ends(DONE, "measure", "tree.json", "--organs", "leaves.csv", "--json", "-o", "measures.json")
        measures = json.loads(self.read("measures.json"))
        rows = list(csv.DictReader(io.StringIO(self.read("leaves.csv").decode())))
        self.assertEqual([int(row["instance"]) for row in rows], list(range(measures["leaf_count"])))
        self.assertEqual({row["component"] for row in rows}, {"leaf"})
        self.assertEqual({row["tree"] for row in rows}, {"0"})
        area = sum(float(row["area"]) for row in rows)
        self.assertAlmostEqual(area, measures["leaf_area"], places=5)
        for column in ("exposure", "irradiance"):
            mean = sum(float(row["area"]) * float(row[column]) for row in rows) / area
            self.assertAlmostEqual(mean, measures["leaf_" + column], places=5)
        for threads in ("1", "8"):
            done = self.run_program("measure", "tree.json", "--organs", "-", "-o", "a.json", "--threads", threads)
            self.assertEqual(done.stdout, self.read("leaves.csv"))

    def test_wrong_uses_of_the_table_of_organs(self):
        for arguments, message in ((["tree.json", "--organs", "tree.json"], "would be overwritten, and it is read"),
                                   (["tree.json", "--organs", "-"], "would be written to one file"),
                                   (["tree.json", "--organs", "./a", "-o", "a"], "would be written to one file"),
                                   (["walnut.mtg", "--organs", "a.csv"], "--organs has no effect on 'walnut.mtg'"),
                                   (["walnut.mtg", "--light"], "--light has no effect on 'walnut.mtg'")):
            self.write("walnut.mtg", MTG)
            self.assertIn(message, self.assert_ends(WRONG_INPUT, "measure", *arguments))
        self.assertIn("No such file or directory",
                      self.assert_ends(FAILED, "measure", "tree.json", "--organs", "no/such/a.csv", *LONG_GROWTH))

    def test_mtg_files_in_their_units(self):
        self.write("walnut.mtg", MTG)
        measures = self.measured("walnut.mtg", "--unit", "cm", "--diameter-unit", "mm", "--diameter", "Thickness")
        self.assertEqual((measures["height"], measures["metamers"], measures["axes"]), (4, 3, 2))
        self.assertAlmostEqual(measures["stem_diameter"], 0.4 - 0.65 * 0.2, places=6)
        self.assertAlmostEqual(measures["branching_angle_median"], 45, places=4)
        self.assertEqual(measures["leaf_count"], None)
        self.assertEqual(measures["stem_diameter"], self.measured("walnut.mtg", "--unit", "cm", "--diameter-unit", "mm",
                                                                  "--diameter", "Thickness", "--coordinates",
                                                                  "XX,YY,ZZ")["stem_diameter"])
        done = self.run_program("measure", "walnut.mtg")
        self.assertEqual(done.stderr.decode(), "warning: walnut.mtg: the plant is 400 m high; --unit gives the unit "
                                               "of its coordinates\n")
        self.assertIn(b"stem_diameter            -\n", done.stdout)

    def test_mtg_faults_have_file_line_and_column(self):
        self.write("walnut.mtg", MTG.replace("^<S2", "^<T2"))
        self.assertIn("walnut.mtg:17:3: 'T' is not a class", self.assert_ends(WRONG_INPUT, "measure", "walnut.mtg"))
        self.write("walnut.mtg", MTG)
        for arguments, message in ((["--diameter", "Thicknes"], "did you mean 'Thickness'?"),
                                   (["--coordinates", "XX,YY"], "--coordinates cannot be 'XX,YY'"),
                                   (["--set", "a=1"], "--set has no effect on 'walnut.mtg'"),
                                   (["--unit", "ft"], "--unit")):
            self.assertIn(message, self.assert_ends(WRONG_INPUT, "measure", "walnut.mtg", *arguments))
        self.assertIn("did you mean 'walnut.mtg'?", self.assert_ends(WRONG_INPUT, "measure", "wallnut.mtg"))

    def test_wrong_uses(self):
        self.assertIn("document is required", self.assert_ends(WRONG_INPUT, "measure"))
        self.assertIn("--unit has no effect on 'tree.json'",
                      self.assert_ends(WRONG_INPUT, "measure", "tree.json", "--unit", "cm"))
        self.assertIn("No such file or directory",
                      self.assert_ends(FAILED, "measure", "tree.json", "-o", "no/such/folder/a.json", *LONG_GROWTH))


if __name__ == "__main__":
    unittest.main()
