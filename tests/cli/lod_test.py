#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Levels of detail from the user's view. Usage: lod_test.py PROGRAM [unittest options]"""

import os
import re
import unittest

import cli_case
from cli_case import DONE, WRONG_INPUT


class Lod(cli_case.Case):
    def grow(self, *arguments):
        """Runs the program and returns the triangles of each line of the report, by the text before the colon."""
        errors = self.assert_ends(DONE, "grow", "tree.json", *arguments)
        return {files: int(count) for files, count in re.findall(r"^(\S[^:]*): .*?(\d+) triangles", errors, re.MULTILINE)}

    def files(self):
        return sorted(set(os.listdir(self.folder)) - {"tree.json", "box.json"})

    def test_each_level_is_a_file_of_about_a_quarter_of_the_triangles(self):
        counts = self.grow("-o", "tree.glb", "--lod", "3")
        # Worthless levels are reported in a separate line.
        names = [name for name in counts if name.endswith(".glb")]
        self.assertEqual(names, ["tree.glb", "tree_lod1.glb", "tree_lod2.glb", "tree_lod3.glb"][:len(names)])
        self.assertGreaterEqual(len(names), 2)
        self.assertEqual(self.files(), sorted(names))
        for finer, coarser in zip(names, names[1:]):
            self.assertLess(counts[coarser], 0.35 * counts[finer])
            self.assertGreater(counts[coarser], 0.15 * counts[finer])

    def test_levels_that_are_worth_nothing_are_not_written(self):
        errors = self.assert_ends(DONE, "grow", "tree.json", "-o", "a.glb", "--lod", "8")
        self.assertRegex(errors, r"(?m)^a_lod(\d)\.glb and coarser ones are not written: (it would have|with) \d+ triangles")
        self.assertNotIn("a_lod8.glb", self.files())

    def test_cards_are_a_last_level_of_few_triangles(self):
        counts = self.grow("-o", "a.glb", "-o", "a.obj", "-o", "a.ply", "--lod", "1", "--cards", "2")
        self.assertEqual(counts["a_cards.glb, a_cards.obj"], 6)
        self.assertNotIn("a_cards.ply", self.files())
        again = self.read("a_cards.glb")
        self.grow("-o", "a.glb", "--cards", "2", "--threads", "1")
        self.assertEqual(self.read("a_cards.glb"), again)
        self.assert_ends(DONE, "render", "tree.json", "-o", "c.png", "--cards", "2", "--size", "40x40", "--samples", "1")

    def test_cards_that_cannot_be_are_refused(self):
        def refuses(message, *arguments):
            self.assertIn(message, self.assert_ends(WRONG_INPUT, *arguments))

        refuses("--cards cannot be 17; expected 0 to 16 cards", "grow", "tree.json", "-o", "a.glb", "--cards", "17")
        refuses("--cards changes none of the files", "grow", "tree.json", "-o", "a.ply", "--cards", "2")
        refuses("cards cannot be written to standard output", "grow", "tree.json", "-o", "-", "--cards", "2")
        refuses("'a_cards.glb' would be written twice", "grow", "tree.json", "-o", "a.glb", "-o", "a_cards.glb",
                "--cards", "2")
        refuses("--cards cannot be 0; expected 1 to 16 cards", "render", "tree.json", "-o", "a.png", "--cards", "0")

    def test_level_0_is_the_file_without_levels_on_any_number_of_threads(self):
        self.grow("-o", "plain.glb")
        self.grow("-o", "one.glb", "--lod", "1", "--threads", "1")
        self.grow("-o", "three.glb", "--lod", "1", "--threads", "3")
        self.assertEqual(self.read("one.glb"), self.read("plain.glb"))
        for level in ("", "_lod1"):
            self.assertEqual(self.read(f"one{level}.glb"), self.read(f"three{level}.glb"))

    def test_every_format_with_meshes_has_levels_and_others_are_written_once(self):
        counts = self.grow("-o", "a.OBJ", "-o", "a.ply", "-o", "a.csv", "-o", "a.skeleton.ply", "--lod", "1")
        self.assertEqual(list(counts), ["a.OBJ, a.ply, a.csv, a.skeleton.ply", "a_lod1.OBJ, a_lod1.ply"])
        self.assertEqual([name for name in self.files() if not name.endswith(".png")],
                         ["a.OBJ", "a.csv", "a.mtl", "a.ply", "a.skeleton.ply", "a_lod1.OBJ", "a_lod1.mtl", "a_lod1.ply"])

    def test_the_document_says_how_many_levels_unless_the_option_does(self):
        self.write("tree.json", cli_case.TREE.replace('"meristem": 1,', '"meristem": 1, "output": {"lod": 2},'))
        self.assertEqual(len(self.grow("-o", "a.glb")), 3)
        self.assertEqual(len(self.grow("-o", "a.glb", "--lod", "1")), 2)
        self.assertEqual(len(self.grow("-o", "a.glb", "--set", "output.lod=0")), 1)
        before = self.files()
        self.assertEqual(self.grow("-o", "a.csv"), {})  # a table needs no meshes, so no triangles are counted
        self.assertEqual(set(self.files()) - set(before), {"a.csv"})
        self.assertTrue(self.run_program("grow", "tree.json", "-o", "-").stdout.startswith(b"glTF"))

    def test_what_cannot_be_is_refused(self):
        def refuses(message, *arguments):
            self.assertIn(message, self.assert_ends(WRONG_INPUT, *arguments))

        refuses("--lod cannot be -1; expected 0 to 8 levels", "grow", "tree.json", "-o", "a.glb", "--lod", "-1")
        refuses("--lod cannot be 9", "grow", "tree.json", "-o", "a.glb", "--lod", "9")
        refuses("--lod cannot be 9", "render", "tree.json", "-o", "a.png", "--lod", "9")
        refuses("--lod changes none of the files", "grow", "tree.json", "-o", "a.csv", "--lod", "1")
        refuses("levels of detail cannot be written to standard output", "grow", "tree.json", "-o", "-", "--lod", "1")
        refuses("'a_lod1.glb' would be written twice", "grow", "tree.json", "-o", "a.glb", "-o", "a_lod1.glb",
                "--lod", "1")
        refuses("output.lod", "grow", "tree.json", "-o", "a.glb", "--set", "output.lod=9")
        refuses("output.lod", "grow", "tree.json", "-o", "a.glb", "--set", "output.lod=-1")

    def test_a_level_that_cannot_be_written_is_told_before_the_plant_grows(self):
        os.mkdir(self.path("a_lod2.glb"))
        self.assert_ends(cli_case.FAILED, "grow", "tree.json", "-o", "a.glb", "--lod", "2")

    def test_pictures_show_a_level(self):
        picture = ["--size", "60x60", "--samples", "2"]
        for level in "02":
            self.assert_ends(DONE, "render", "tree.json", "-o", f"{level}.png", "--lod", level, *picture)
        self.assertNotEqual(self.read("0.png"), self.read("2.png"))


if __name__ == "__main__":
    unittest.main()
