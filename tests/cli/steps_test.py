#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Growth step by step on the command line: --step, --show, tables of attraction points.

Usage: steps_test.py PROGRAM [unittest options]
"""

import csv
import io
import unittest

import cli_case
from cli_case import DONE, WRONG_INPUT

SIZE = ("--size", "48x48", "--samples", "1", "--view", "150,10", "--quiet")


class Steps(cli_case.Case):
    def done(self, *arguments):
        done = self.run_program(*arguments)
        self.assertEqual(done.returncode, DONE, done.stderr)
        return done

    def points(self, *options):
        self.done("grow", "tree.json", "-o", "tree.points.csv", "--quiet", *options)
        return list(csv.DictReader(io.StringIO(self.read("tree.points.csv").decode())))

    def test_a_step_is_the_plant_of_as_many_iterations(self):
        for name, options in (("step.csv", ["--step", "12"]), ("less.csv", ["--set", "tree.iterations=12"])):
            self.done("grow", "tree.json", "-o", name, *options)
        self.assertEqual(self.read("step.csv"), self.read("less.csv"))
        told = self.done("grow", "tree.json", "-o", "step.csv", "--step", "12").stderr.decode()
        self.assertRegex(told, r"step\.csv: step 12 of \d+, \d+ nodes")
        far = self.done("grow", "tree.json", "-o", "far.csv", "--step", "100000").stderr.decode()
        self.assertRegex(far, r"step (\d+) of \1,")
        self.done("grow", "tree.json", "-o", "whole.csv")
        self.assertEqual(self.read("far.csv"), self.read("whole.csv"))
        self.assert_ends(WRONG_INPUT, "grow", "tree.json", "-o", "a.csv", "--step", "-1")

    def test_points_are_used_up_step_by_step(self):
        whole = self.points()
        early = self.points("--step", "6")
        self.assertEqual([len(whole), len(early)], [300, 300])
        self.assertEqual({row["component"] for row in whole}, {"tree"})
        used = [sum(row["state"] == "used" for row in rows) for rows in (early, whole)]
        self.assertLess(used[0], used[1])
        self.assertTrue(all((row["state"] == "used") == (row["used_in"] != "0") for row in whole))
        self.assertLessEqual(max(int(row["used_in"]) for row in early), 6)
        self.assertEqual(self.points("--threads", "1"), whole)

    def test_pictures_show_what_is_asked(self):
        self.done("render", "tree.json", "-o", "plain.png", *SIZE)
        seen = {self.read("plain.png")}
        for names in ("points", "points,skeleton", "sun,compass,scale", "hull", "light", "ways", "pulls"):
            self.done("render", "tree.json", "-o", "shown.png", "--show", names, "--step", "9", *SIZE)
            self.assertNotIn(self.read("shown.png"), seen, names)
            seen.add(self.read("shown.png"))
        self.done("render", "tree.json", "-o", "alone.png", "--show", "skeleton", "--no-plant", *SIZE)
        self.assertNotIn(self.read("alone.png"), seen)

    def test_fingerprints_tell_overlays_and_steps(self):
        told = [self.done("render", "tree.json", "--fingerprint", "--quiet", *options).stdout
                for options in ([], ["--step", "9"], ["--show", "points"], ["--show", "points", "--step", "9"],
                                ["--show", "points", "--no-plant"])]
        self.assertEqual(len(set(told)), len(told))

    def test_wrong_names_are_refused_with_the_nearest(self):
        errors = self.assert_ends(WRONG_INPUT, "render", "tree.json", "-o", "a.png", "--show", "point")
        self.assertIn("did you mean 'points'", errors)
        self.assert_ends(WRONG_INPUT, "render", "tree.json", "-o", "a.png", "--no-plant")
        told = self.run_program("render", "--help").stdout.decode()
        for name in ("points", "losses", "markers", "compass"):
            self.assertRegex(told, rf"\n  {name} +[A-Z]")


if __name__ == "__main__":
    unittest.main()
