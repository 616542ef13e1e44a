#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests objects of plants in files, and set operations between them. Usage: combine_test.py MERISTEM [unittest
options]"""

import unittest

from cli_case import DONE, WRONG_INPUT, Case

BUSH = """{
  "meristem": 1,
  "components": {"bush": {"type": "lsystem", "steps": 0, "width": 0.1, "grammar": "F(1)[&(60)F(0.5)]",
    "surface": {"style": "blend", "shading": "flat", "resolution": 20, "triangles": 100,
                "crown": {"diameter": 0.8, "resolution": 12, "triangles": 100}}}}
}"""


class Combine(Case):
    def setUp(self):
        super().setUp()
        self.write("bush.json", BUSH)

    def objects(self, name):
        return [line[2:].decode() for line in self.read(name).splitlines() if line.startswith(b"o ")]

    def test_objects_are_chosen(self):
        self.assert_ends(DONE, "grow", "bush.json", "-o", "bush.obj")
        self.assertEqual(self.objects("bush.obj"), ["bush", "bush_crown"])
        self.assert_ends(DONE, "grow", "bush.json", "-o", "crown.obj", "--only", "bush_crown")
        self.assertEqual(self.objects("crown.obj"), ["bush_crown"])
        self.assert_ends(DONE, "render", "bush.json", "-o", "a.png", "--size", "32x32", "--samples", "1")
        self.assert_ends(DONE, "render", "bush.json", "-o", "b.png", "--size", "32x32", "--samples", "1",
                         "--only", "bush")
        self.assertNotEqual(self.read("a.png"), self.read("b.png"))
        self.assertIn("did you mean 'bush_crown'?",
                      self.assert_ends(WRONG_INPUT, "grow", "bush.json", "-o", "a.obj", "--only", "bush_corwn"))
        self.assertIn("--only changes none of the files",
                      self.assert_ends(WRONG_INPUT, "grow", "bush.json", "-o", "a.csv", "--only", "bush"))

    def test_faces_of_ply_share_vertices(self):
        self.assert_ends(DONE, "grow", "bush.json", "-o", "plain.ply")
        self.assert_ends(DONE, "grow", "bush.json", "-o", "shared.ply", "--shared-vertices")
        self.assertIn(b"property float nx", self.read("plain.ply"))
        self.assertNotIn(b"property float nx", self.read("shared.ply"))
        self.assertLess(2 * len(self.read("shared.ply")), len(self.read("plain.ply")))
        self.assertIn("--shared-vertices changes none of the files",
                      self.assert_ends(WRONG_INPUT, "grow", "bush.json", "-o", "a.glb", "--shared-vertices"))

    def test_set_operations(self):
        self.assert_ends(DONE, "grow", "bush.json", "-o", "trunk.obj", "--only", "bush")
        self.assert_ends(DONE, "grow", "bush.json", "-o", "crown.ply", "--only", "bush_crown", "--shared-vertices")
        for operation in ("union", "intersection", "difference"):
            for ending in ("obj", "ply", "glb"):
                self.assert_ends(DONE, "combine", operation, "trunk.obj", "crown.ply", "-o", f"{operation}.{ending}",
                                 "--resolution", "40")
        self.assert_ends(DONE, "combine", "union", "union.obj", "crown.ply", "-o", "few.obj", "--triangles", "300")
        self.assertEqual(self.read("few.obj").count(b"\nf "), 300)

    def test_faults(self):
        self.assert_ends(DONE, "grow", "bush.json", "-o", "trunk.obj", "--only", "bush")
        self.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.assertIn("did you mean 'union'?", self.assert_ends(
            WRONG_INPUT, "combine", "unoin", "trunk.obj", "trunk.obj", "-o", "a.obj"))
        self.assertIn("open.obj", self.assert_ends(
            WRONG_INPUT, "combine", "union", "trunk.obj", "open.obj", "-o", "a.obj"))
        self.assertIn(".obj, .ply or .glb", self.assert_ends(
            WRONG_INPUT, "combine", "union", "trunk.obj", "trunk.obj", "-o", "a.stl"))
        self.assertIn("the difference encloses nothing", self.assert_ends(
            WRONG_INPUT, "combine", "difference", "trunk.obj", "trunk.obj", "-o", "a.obj"))


if __name__ == "__main__":
    unittest.main()
