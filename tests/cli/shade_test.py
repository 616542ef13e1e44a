#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Shade and measured light from the user's view. Usage: shade_test.py PROGRAM [unittest options]"""

import csv
import io
import json
import math
import unittest

import cli_case
from cli_case import DONE, TREE, WRONG_INPUT

# A house with its south wall at z = 0, and a ball of 1 m radius in front of the wall.
STREET = {
    "meristem": 1,
    "scene": {"latitude": 50, "sun": {"day": 80, "hour": 12},
              "obstacles": [{"name": "house", "box": [[-4, 0, -8], [4, 6, 0]]},
                            {"name": "shed", "box": [[20, 0, 20], [22, 2, 22]]}]},
    "components": {"ball": {"type": "simple", "shape": "sphere", "size": [2, 2, 2], "segments": 64,
                            "frame": {"translate": [0, 5, 4]}}},
}


class Shade(cli_case.Case):
    def setUp(self):
        super().setUp()
        self.write("street.json", json.dumps(STREET))

    def rows(self, *arguments):
        """Returns the table of moments, with cells converted to numbers if possible."""
        done = self.run_program("shade", "street.json", "-q", *arguments)
        self.assertEqual(done.returncode, DONE, done.stderr.decode())
        return [{name: float(value) if value and "-" not in value[1:5] else value for name, value in row.items()}
                for row in csv.DictReader(io.StringIO(done.stdout.decode()))]

    def test_a_facade_by_hour_with_and_without_the_plant(self):
        noon, evening, night = self.rows("--facade", '{"obstacle": "house", "side": "south"}', "--days", "80",
                                         "--hours", "12,17.9,23", "--spacing", "0.1")
        # The ball's shadow on the wall is its disc divided by the cosine to the wall's normal.
        self.assertAlmostEqual(noon["shade"] * 48, math.pi / math.cos(math.radians(noon["altitude"])), delta=0.05)
        self.assertEqual(noon["shade_without_plants"], 0)
        self.assertAlmostEqual(noon["cosine"], math.cos(math.radians(noon["altitude"])), places=5)
        self.assertLess(noon["direct"], noon["cosine"])
        self.assertEqual(evening["shade"], 0)
        self.assertEqual((night["shade"], night["direct"]), ("", ""))

    def test_surfaces_agree_with_one_another(self):
        """A panel on the wall has the shade of the wall, and a panel on the ground has the shade of the ground."""
        times = ("--days", "80:110:30", "--hours", "9:15:3", "--spacing", "0.1")
        wall = self.rows("--facade", '{"obstacle": "0", "side": "south"}', *times)
        panel = self.rows("--panels", '{"position": [0, 3, 0.01], "width": 8, "length": 6, "tilt": 90}', *times)
        for one, other in zip(wall, panel):
            self.assertAlmostEqual(one["shade"], other["shade"], delta=0.003)
        ground = self.rows("--ground", "[[-5, 1], [5, 9]]", *times)
        flat = self.rows("--panels", '{"position": [0, 0, 5], "width": 10, "length": 8, "tilt": 0}', *times)
        for one, other in zip(ground, flat):
            self.assertAlmostEqual(one["shade"], other["shade"], delta=0.003)

    def test_every_format_tells_the_same(self):
        arguments = ("--ground", "[[-6, -10], [6, 6]]", "--days", "80,172", "--hours", "8:16:4", "--spacing", "0.5")
        self.assert_ends(DONE, "shade", "street.json", *arguments, "-o", "a.csv", "-o", "a.json", "-o", "a.png", "-o",
                         "a.jpg", "--points", "points.csv")
        table = self.rows(*arguments)
        self.assertEqual(self.read("a.csv").decode().count("\n"), 1 + len(table))
        found = json.loads(self.read("a.json"))
        self.assertEqual([round(moment["shade"], 5) for moment in found["moments"]],
                         [round(row["shade"], 5) for row in table])
        self.assertEqual((found["grid"]["columns"], found["grid"]["rows"]), (24, 32))
        flat = [share for row in found["grid"]["shade"] for share in row]
        self.assertEqual(sum(share is None for share in flat), 16 * 16)
        points = list(csv.DictReader(io.StringIO(self.read("points.csv").decode())))
        self.assertEqual(len(points), found["points"])
        self.assertAlmostEqual(sum(float(point["shade"]) for point in points) / len(points),
                               sum(row["shade"] for row in table) / len(table), places=5)
        self.assertTrue(self.read("a.png").startswith(b"\x89PNG"))
        self.assertTrue(self.read("a.jpg").startswith(b"\xff\xd8"))

    def test_same_bytes_on_any_number_of_threads(self):
        arguments = ("shade", "street.json", "--facade", "house", "--days", "80", "--hours", "8:16:1", "--json", "-q")
        first = self.run_program(*arguments, "--threads", "1").stdout
        self.assertIn(b'"moments"', first)
        for threads in ("2", "8"):
            self.assertEqual(self.run_program(*arguments, "--threads", threads).stdout, first)

    def test_clock_time_of_options_and_of_the_document(self):
        surface = ("--facade", "house", "--hours", "15:30")
        by_option = self.rows(*surface, "--days", "2026-06-21", "--longitude", "13.4", "--utc-offset", "2")[0]
        self.assertAlmostEqual(by_option["solar_hour"], 14.36, places=2)
        street = json.loads(json.dumps(STREET))
        street["scene"]["sun"] = {"date": "2026-06-21", "time": "15:30", "longitude": 13.4, "utc_offset": 2}
        self.write("street.json", json.dumps(street))
        by_document = self.rows(*surface, "--days", "2026-06-21")[0]
        self.assertEqual(by_document, by_option)
        self.assertIn("has no year", self.assert_ends(WRONG_INPUT, "shade", "street.json", *surface, "--days", "172"))

    def test_holes_of_a_picture_let_light_pass(self):
        """A leaf with an edge cut by a picture casts the shadow of its visible area, not of its mesh."""
        leaf = {"type": "leaf", "length": 2, "width": 1.4, "rows": 2, "edge": "picture", "variety": 0,
                "texture": {"leaf": {"veins": "pinnate"}}, "frame": {"translate": [0, 1, 0], "rotate": [-90, 0, 0]}}
        self.write("street.json", json.dumps({"meristem": 1, "components": {"leaf": leaf}}))
        row = self.rows("--ground", "[[-2, -3], [2, 3]]", "--days", "80", "--hours", "12", "--latitude", "0.2427",
                        "--spacing", "0.02")[0]
        measured = json.loads(self.run_program("measure", "street.json", "--json").stdout)
        self.assertAlmostEqual(row["shade"] * 24, measured["leaf_area"], delta=0.01 * measured["leaf_area"])

    def test_what_cannot_be_is_refused(self):
        def refuses(message, *arguments):
            self.assertIn(message, self.assert_ends(WRONG_INPUT, "shade", "street.json", *arguments))

        days = ("--days", "80")
        refuses("no obstacle is called 'huose'; expected one of house, shed; did you mean 'house'?", "--facade", "huose", *days)
        refuses("facade.side: ", "--facade", '{"obstacle": "house", "side": "sooth"}', *days)
        refuses("panels.tilt: ", "--panels", '{"position": [0, 1, 0], "tilt": 120}', *days)
        refuses("ground.area: the area has 1 corners", "--ground", "[[0, 0]]", *days)
        refuses("no surface is given", *days)
        refuses("days: 'june' is not a day", "--facade", "house", "--days", "june")
        refuses("hours: '25' is not an hour", "--facade", "house", *days, "--hours", "25")
        refuses("clock time needs both", "--facade", "house", *days, "--longitude", "7")
        refuses("spacing: ", "--facade", "house", *days, "--spacing", "0")
        refuses("points are too many", "--facade", "house", *days, "--spacing", "0.001")
        refuses("'a.txt' has no ending that names a format", "--facade", "house", *days, "-o", "a.txt")
        refuses("would be overwritten, and it is read", "--facade", "house", *days, "-o", "street.json")
        refuses("--days is required", "--facade", "house")
        self.write("dark.json", json.dumps({"meristem": 1, "components": STREET["components"]}))
        self.assertIn("latitude: the scene has no latitude",
                      self.assert_ends(WRONG_INPUT, "shade", "dark.json", "--ground", "[[0, 0], [1, 1]]", *days))


class MeasuredLight(cli_case.Case):
    def measured(self, *arguments):
        done = self.run_program("measure", "tree.json", "--json", *arguments)
        self.assertEqual(done.returncode, DONE, done.stderr.decode())
        return json.loads(done.stdout)

    def setUp(self):
        super().setUp()
        tree = json.loads(TREE)
        tree["scene"] = {"latitude": 50, "sun": {"day": 80, "hour": 12}}
        tree["components"]["tree"]["light"] = {"shift": 0.3}
        self.write("tree.json", json.dumps(tree))

    def test_the_light_measured_need_not_be_the_one_of_growth(self):
        own = self.measured("--light")
        same = self.measured("--light", "--sun", '{"day": 80, "hour": 12}')
        other = self.measured("--light", "--sun", '{"day": 172, "hour": 7}')
        self.assertEqual(same, own)
        self.assertEqual(other["nodes"], own["nodes"])
        self.assertEqual(other["crown_hull_area"], own["crown_hull_area"])
        self.assertNotEqual(other["leaf_irradiance"], own["leaf_irradiance"])
        self.assertNotEqual(other["lit_share"], own["lit_share"])
        grown = self.measured("--light", "--set", 'scene.sun={"day": 172, "hour": 7}')
        self.assertNotEqual(grown["crown_hull_area"], own["crown_hull_area"])
        day = self.measured("--light", "--sun", '{"day": 172, "every_hours": 1}', "--set", "scene.sun.hour=9")
        self.assertGreater(day["leaf_exposure"], 0)

    def test_a_wrong_sun_is_told_by_its_option(self):
        errors = self.assert_ends(WRONG_INPUT, "measure", "tree.json", "--sun", '{"day": 172, "hour": 25}')
        self.assertIn("--sun: scene.sun.hour: ", errors)
        errors = self.assert_ends(WRONG_INPUT, "measure", "tree.json", "--sun", '{"dai": 172}')
        self.assertIn("did you mean 'day'?", errors)
        self.assertIn("below the horizon",
                      self.run_program("measure", "tree.json", "--sun", '{"day": 172, "hour": 0}').stderr.decode())

    def test_layers_sum_up_to_the_leaf_area(self):
        measures = self.measured("--layers", "0.25")
        self.assertAlmostEqual(sum(layer["leaf_area"] for layer in measures["layers"]), measures["leaf_area"], places=9)
        for below, above in zip(measures["layers"], measures["layers"][1:]):
            self.assertEqual(below["high"], above["low"])
        text = self.run_program("measure", "tree.json", "--layers", "0.25").stdout.decode()
        self.assertIn("\nleaf area by height\n", text)

    def test_measures_at_a_time(self):
        self.write("tree.json", json.dumps({"meristem": 1, "components": {
            "stem": {"type": "tree", "length": "1 + t", "radius": 0.02}}}))
        self.assertAlmostEqual(self.measured("--time", "1")["height"], 2 * self.measured()["height"], places=5)

    def test_obstacles_in_files(self):
        tree = json.loads(TREE)
        tree["scene"] = {"obstacles": [{"box": [[3, 0, 3], [5, 4, 5]], "name": "shed"},
                                       {"box": [[7, 0, 3], [8, 4, 5]], "hidden": True}]}
        self.write("tree.json", json.dumps(tree))
        for ending in ("glb", "obj", "ply"):
            self.assert_ends(DONE, "grow", "tree.json", "-o", "plain." + ending)
            self.assert_ends(DONE, "grow", "tree.json", "-o", "whole." + ending, "--obstacles")
        self.assertNotIn(b"\ng obstacles\n", self.read("plain.obj"))
        whole = self.read("whole.obj")
        self.assertIn(b"\ng obstacles\nusemtl shed\n", whole)
        self.assertEqual(whole.split(b"\ng obstacles\n")[1].count(b"\nf "), 12)
        self.assertIn(b'"name":"obstacles"', self.read("whole.glb"))
        self.assertIn("--obstacles changes none of the files",
                      self.assert_ends(WRONG_INPUT, "grow", "tree.json", "-o", "a.csv", "--obstacles"))


if __name__ == "__main__":
    unittest.main()
