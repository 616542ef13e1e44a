#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pictures that `meristem render` makes: series, time, JPEG, fingerprints, hulls.

Usage: pictures_test.py PROGRAM [unittest options]
"""

import os
import unittest

import cli_case
from cli_case import DONE, TREE, WRONG_INPUT


class Pictures(cli_case.Case):
    def test_a_turntable_writes_numbered_frames_from_all_sides(self):
        done = self.run_program("render", "box.json", "-o", "turn.png", "--turntable", "3", "--size", "16x16",
                                "--samples", "1")
        self.assertEqual(done.returncode, DONE)
        self.assertIn("turn_000.png to turn_002.png: 16 x 16 pixels", done.stderr.decode())
        frames = [self.read(f"turn_00{k}.png") for k in range(3)]
        self.assertEqual(len(set(frames)), 3)
        self.assertNotIn("turn.png", os.listdir(self.folder))
        # The first frame is the picture without rotation.
        self.run_program("render", "box.json", "-o", "one.png", "--size", "16x16", "--samples", "1")
        self.assertEqual(frames[0], self.read("one.png"))

    def test_time_changes_what_grows_and_writes_numbered_frames(self):
        self.write("rising.json", '{"meristem": 1, "components": {"b": {"type": "simple", "size": [1, "1 + t", 1]}}}')
        for time in ("0", "1.5"):
            self.assertEqual(self.run_program("grow", "rising.json", "-o", f"at{time}.obj", "--time", time).returncode,
                             DONE)
        self.assertNotEqual(self.read("at0.obj"), self.read("at1.5.obj"))
        size = ("--size", "16x16", "--samples", "1", "--view", "150,10")
        done = self.run_program("render", "rising.json", "-o", "rise.png", "--time", "0:1:0.5", *size)
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertIn("rise_000.png to rise_002.png: 16 x 16 pixels", done.stderr.decode())
        frames = [self.read(f"rise_00{k}.png") for k in range(3)]
        self.assertEqual(len(set(frames)), 3)
        # The camera has the position for the last frame alone, and a single time makes a single picture.
        self.run_program("render", "rising.json", "-o", "last.png", "--time", "1", *size)
        self.assertEqual(frames[2], self.read("last.png"))

    def test_jpegs_have_a_quality_and_a_largest_size(self):
        size = ("--size", "64x48", "--samples", "4")
        for name, options in (("fine.jpg", ["--quality", "95"]), ("rough.jpeg", ["--quality", "20"]),
                              ("small.jpg", ["--max-size", "1.2"])):
            self.assertEqual(self.run_program("render", "tree.json", "-o", name, *options, *size).returncode, DONE)
            self.assertEqual(self.read(name)[:3], b"\xff\xd8\xff")
        self.assertLess(len(self.read("rough.jpeg")), len(self.read("fine.jpg")))
        self.assertLessEqual(len(self.read("small.jpg")), 1200)
        for wrong in (["-o", "a.png", "--quality", "80"], ["-o", "a.jpg", "--quality", "0"],
                      ["-o", "a.jpg", "--max-size", "0"], ["-o", "a.jpg", "--transparent"], []):
            self.assert_ends(WRONG_INPUT, "render", "box.json", *wrong)

    def test_a_fingerprint_stays_as_long_as_the_picture_does(self):
        def fingerprint(document, *options):
            done = self.run_program("render", document, "--fingerprint", "--quiet", *options)
            self.assertEqual(done.returncode, DONE, done.stderr)
            self.assertRegex(done.stdout, rb"^[0-9a-f]{16}\n$")
            return done.stdout
        plain = fingerprint("tree.json")
        self.assertEqual(fingerprint("tree.json", "--threads", "1"), plain)
        for options in (["--seed", "2"], ["--set", "leaf.colour=#102030"], ["--size", "64x48"], ["--view", "10,20"],
                        ["--hull"], ["--lod", "1"], ["--samples", "3"]):
            self.assertNotEqual(fingerprint("tree.json", *options), plain, options)
        self.assertNotIn("picture.png", os.listdir(self.folder))

    def test_hulls_surround_crowns_in_pictures(self):
        size = ("--size", "24x24", "--samples", "1", "--view", "150,10")
        self.run_program("render", "tree.json", "-o", "plain.png", *size)
        self.run_program("render", "tree.json", "-o", "hull.png", "--hull", *size)
        self.assertNotEqual(self.read("hull.png"), self.read("plain.png"))
        # Without a crown, the picture does not change.
        for options in ([], ["--hull"]):
            self.run_program("render", "box.json", "-o", f"box{len(options)}.png", *options, *size)
        self.assertEqual(self.read("box1.png"), self.read("box0.png"))
        # All frames of a turntable have hulls, and time-lapses have them while there is a crown.
        self.run_program("render", "tree.json", "-o", "turn.png", "--hull", "--turntable", "2", *size)
        self.assertEqual(self.read("turn_000.png"), self.read("hull.png"))
        self.write("growing.json", TREE.replace('"influence"', '"iterations": "4 + 99*t", "influence"'))
        done = self.run_program("render", "growing.json", "-o", "grow.png", "--hull", "--time", "0:1:1", *size)
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.run_program("render", "growing.json", "-o", "bare.png", "--time", "0:1:1", *size)
        self.assertEqual(self.read("grow_000.png"), self.read("bare_000.png"))
        self.assertNotEqual(self.read("grow_001.png"), self.read("bare_001.png"))


if __name__ == "__main__":
    unittest.main()
