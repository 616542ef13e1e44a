#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Documents that the command line reads: errors with line and column, warnings, limits.

Usage: documents_test.py PROGRAM [unittest options]
"""

import json
import os
import unittest

import cli_case
from cli_case import BOX, DONE, FAILED, WRONG_INPUT


class Documents(cli_case.Case):
    def test_good_document(self):
        done = self.run_program("check", "tree.json")
        self.assertEqual((done.returncode, done.stdout.decode(), done.stderr.decode()),
                         (DONE, "tree.json: good, 2 components and 1 link\n", ""))

    def test_check_counts_the_camera_only_if_it_is_written(self):
        self.write("box.json", BOX)
        self.write("seen.json", BOX.replace('"box"', '"view": {"type": "camera"}, "box"', 1)
                   .replace("}}}", '}}, "links": [["view", "box"]]}'))
        for name, size in (("box", "1 component and 0 links"), ("seen", "2 components and 1 link")):
            self.assertIn(f"good, {size}", self.run_program("check", f"{name}.json").stdout.decode())

    def test_check_warns_of_values_in_a_range_that_would_be_refused(self):
        box = {"meristem": 1, "variables": {"size": {"value": 1, "min": 0, "max": 2, "doc": "Size."}, "free": 1},
               "components": {"box": {"type": "simple", "size": ["size", "size", "free"]}}}
        self.write("box.json", json.dumps(box))
        errors = self.assert_ends(DONE, "check", "box.json")
        self.assertIn("if size is 0, which its range allows, the expression's value 0 is out of range for 'size'", errors)
        self.assertEqual(errors.count("warning"), 1)
        self.assertEqual(self.assert_ends(DONE, "check", "box.json", "-q"), "")
        box["variables"]["size"]["min"] = 0.1
        self.write("box.json", json.dumps(box))
        self.assertEqual(self.assert_ends(DONE, "check", "box.json"), "")

    def test_check_grows_plants_at_the_ends_of_ranges_if_asked_to(self):
        tree = {"meristem": 1, "variables": {"wall": {"value": 2, "min": -1, "max": 2, "doc": "Begin of the wall."}},
                "scene": {"obstacles": [{"box": [["wall", -1, -1], [3, 1, 1]]}]},
                "components": {"tree": {"type": "colonize", "points": 50,
                                        "crown": {"sphere": {"centre": [0, 2, 0], "radius": 1}}}}}
        self.write("tree.json", json.dumps(tree))
        self.assertNotIn("its range allows", self.assert_ends(DONE, "check", "tree.json"))
        errors = self.assert_ends(DONE, "check", "tree.json", "--ranges")
        self.assertIn("if wall is -1, which its range allows, a root stands inside an obstacle", errors)

    def test_paths_that_cannot_be_read(self):
        self.assertIn("No such file", self.assert_ends(FAILED, "check", "none.json"))
        self.assertIn("Is a directory", self.assert_ends(FAILED, "check", "."))
        if os.geteuid() != 0:
            self.write("secret.json", BOX)
            os.chmod(self.path("secret.json"), 0)
            self.assertIn("Permission denied", self.assert_ends(FAILED, "check", "secret.json"))

    def test_unknown_model_names_the_nearest(self):
        self.assertIn("no shipped model 'oka'; expected a document, or the name of a shipped model; did you mean "
                      "'oak'?", self.assert_ends(WRONG_INPUT, "check", "oka"))

    def test_model_goes_before_a_folder_of_its_name(self):
        os.mkdir(self.path("oak"))
        self.assert_ends(DONE, "check", "oak")

    def test_faults_have_file_line_and_column(self):
        self.assert_rejects('{"meristem": 1,\n "components": {"a": {"type": "simpel"}}}',
                            "bad.json:2:31: components.a.type: 'simpel' is not a type of component; did you mean 'simple'?")
        self.assert_rejects('{"meristem": 1 "seed": 2}', "bad.json:1:16: unexpected string literal; expected ',' or '}'")
        self.assert_rejects(b'{"name": "\xff"}', "bad.json:1:11: invalid string: ill-formed UTF-8 byte")

    def test_every_fault_is_told(self):
        self.write("bad.json", '{"meristem": 1, "a": 1, "b": 2, "components": {"c": 3}, "links": 4}')
        self.assertEqual(self.assert_ends(WRONG_INPUT, "check", "bad.json").count("bad.json:1:"), 4)

    def test_links(self):
        boxes = '"components": {"a": {"type": "simple"}, "b": {"type": "simple"}}'
        self.assert_rejects('{"meristem": 1, %s, "links": [["a", "c"]]}' % boxes, "there is no component 'c'")
        self.assert_rejects('{"meristem": 1, %s, "links": [["a", "b"], ["b", "a"]]}' % boxes, "a > b > a form")

    def test_growth_that_cannot_be(self):
        tree = '{"meristem": 1, "components": {"t": {"type": "colonize", "crown": {"profile": %s}, %s}}}'
        crown = "[[1, 0], [1, 1]]"
        self.assert_rejects(tree % (crown, '"points": 1000000000'), "attraction points are too many; expected at most")
        self.assert_rejects(tree % (crown, '"step": 0'), "the value 0 is out of range for 'step'")
        self.assert_rejects(tree % ("[[0, 0], [0, 1]]", '"points": 9'), "the crown is empty")

    def test_numbers_that_are_not_finite(self):
        self.write("bad.json", '{"meristem": 1, "components": {"l": {"type": "leaf", "curl": "sqrt(-1 - i)"}}}')
        errors = self.assert_ends(WRONG_INPUT, "grow", "bad.json", "-o", "out.glb")
        self.assertRegex(errors, r"bad\.json:1:\d+: components\.l\.curl: ")

    def test_nesting(self):
        self.assert_rejects("[" * 10000 + "]" * 10000, "bad.json:1:65: ")

    def test_huge_document_is_refused_soon(self):
        with open(self.path("huge.json"), "wb") as file:
            file.truncate(200_000_000)
        self.assertIn("the document is larger than 16000000 bytes", self.assert_ends(WRONG_INPUT, "check", "huge.json"))

    def test_control_characters_do_not_reach_the_terminal(self):
        self.write("bad.json", '{"meristem": 1, "\\u001b[2J": 3}')
        self.assertNotIn("\x1b", self.assert_ends(WRONG_INPUT, "check", "bad.json"))

    def test_check_tells_what_growing_would(self):
        tree = ('{"meristem": 1, %s "components": {"tree": {"type": "colonize", "points": 50, '
                '"crown": {"sphere": {"centre": [0, %s, 0], "radius": 1}}}}}')
        box = '"scene": {"obstacles": [{"box": [[-1, -1, -1], [1, 1, 1]]}]},'
        self.write("walled.json", tree % (box, 2))
        self.write("far.json", tree % ("", 9000))
        self.assertIn("components.tree.roots: a root stands inside an obstacle",
                      self.assert_ends(WRONG_INPUT, "check", "walled.json"))
        self.assertIn("components.tree.iterations: growth ends in the trunk: the crown begins 8999 m from the root",
                      self.assert_ends(DONE, "check", "far.json"))

    def test_an_expanded_training_grows_the_same_bytes(self):
        for form in ("espalier", "cordon", "fan", "spindle", "open_vase", "standard", "half_standard", "hedge"):
            tree = {"type": "organize", "iterations": 9, "length": 0.1, "resource": {"alpha": 2.3}}
            trained = {"meristem": 1, "components": {"tree": {**tree, "training": {"form": form}}}}
            self.write("trained.json", json.dumps(trained))
            expanded = json.loads(self.run_program("check", "--expand", "-q", "trained.json").stdout)
            self.assertTrue(expanded["tree"]["operations"], form)
            self.write("listed.json", json.dumps({"meristem": 1, "components": {"tree": {**tree, **expanded["tree"]}}}))
            for name in ("trained", "listed"):
                self.assert_ends(DONE, "grow", f"{name}.json", "-o", f"{name}.csv", "-q")
            self.assertEqual(self.read("trained.csv"), self.read("listed.csv"), form)

    def test_stems_in_obstacles_are_warned_of(self):
        self.write("limb.json", '{"meristem": 1, "scene": {"obstacles": [{"box": [[-1, 1, -1], [1, 2, 1]]}]},\n'
                   '"components": {"limb": {"type": "tree", "length": 3}}}')
        for command in (["check", "limb.json"], ["grow", "limb.json", "-o", "limb.csv"],
                        ["measure", "limb.json"], ["render", "limb.json", "--fingerprint"]):
            errors = self.assert_ends(DONE, *command)
            self.assertRegex(errors, r"warning: limb\.json:2:\d+: components\.limb: 'limb' does not avoid obstacles")

    def test_warnings_say_so_and_do_not_refuse(self):
        self.write("night.json", BOX.replace('"comp', '"scene": {"sun": {"azimuth": 0, "altitude": -9}}, "comp'))
        errors = self.assert_ends(DONE, "check", "night.json")
        self.assertRegex(errors, r"^warning: night\.json:1:\d+: scene\.sun: the sun is below the horizon")
        self.assertEqual(self.assert_ends(DONE, "check", "night.json", "--quiet"), "")


if __name__ == "__main__":
    unittest.main()
