#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The command line as users meet it: exit codes, messages, files that are whole or not there, signals.

Usage: cli_test.py PROGRAM [unittest options]
"""

import csv
import io
import json
import os
import pty
import re
import resource
import select
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))

DONE, FAILED, WRONG_INPUT = 0, 1, 2

TREE = """{
  "meristem": 1,
  "variables": {"points": 300},
  "components": {
    "tree": {"type": "colonize", "crown": {"profile": [[0.2, 0.5], [1, 1], [0.2, 2]]}, "points": "points",
             "step": 0.05, "influence": 0.5, "kill": 0.15},
    "leaf": {"type": "leaf", "length": "0.05*(1 + 0.3*gauss(0,1))"}
  },
  "links": [{"from": "tree", "to": "leaf", "kind": "branch", "density": 20}]
}"""

BOX = '{"meristem": 1, "components": {"box": {"type": "simple"}}}'

# Enough work that a signal comes long before the end.
LONG_RENDER = ["--size", "600x600", "--samples", "2048"]
LONG_GROWTH = ["--set", "points=3000000", "--set", "tree.step=0.002", "--set", "tree.kill=0.002"]


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write("tree.json", TREE)
        self.write("box.json", BOX)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode())

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def run_program(self, *arguments, **options):
        options.setdefault("stdin", subprocess.DEVNULL if "input" not in options else None)
        if options["stdin"] is None:
            del options["stdin"]
        options.setdefault("stdout", subprocess.PIPE)
        return subprocess.run([PROGRAM, *arguments], cwd=self.folder, stderr=subprocess.PIPE, timeout=300, **options)

    def start(self, *arguments, **options):
        options.setdefault("stderr", subprocess.PIPE)
        return subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, **options)

    def assert_ends(self, code, *arguments, **options):
        """Runs and returns standard error; nothing may be left but the files that were there before."""
        before = sorted(os.listdir(self.folder))
        done = self.run_program(*arguments, **options)
        errors = done.stderr.decode()
        self.assertEqual(done.returncode, code, errors)
        if code != DONE:
            self.assertEqual(sorted(os.listdir(self.folder)), before)
            self.assertNotEqual(errors, "")
        return errors

    def stop(self, signal_number, *arguments):
        """Sends the signal once the program tells of its work, and returns its standard error."""
        process = self.start(*arguments)
        first = process.stderr.readline()
        self.assertRegex(first.decode(), r"^[a-z ]+ \d+ %\n$", "a plain line of progress")
        process.send_signal(signal_number)
        errors = process.stderr.read().decode()
        self.assertEqual(process.wait(60), -signal_number, errors)
        process.stdout.close()
        process.stderr.close()
        return errors

    def assert_rejects(self, document, message):
        self.write("bad.json", document)
        for command in (["check"], ["grow", "-o", "out.glb"]):
            errors = self.assert_ends(WRONG_INPUT, command[0], "bad.json", *command[1:])
            self.assertIn(message, errors)


class CommandLine(Case):
    def test_no_command_prints_help(self):
        self.assertIn(b"grow", self.run_program().stdout)

    def test_every_command_has_help_with_an_example(self):
        for command in ([], ["grow"], ["render"], ["measure"], ["derive"], ["check"], ["components"], ["models"], ["studio"]):
            done = self.run_program(*command, "--help")
            self.assertEqual(done.returncode, DONE)
            self.assertIn(b"Example: meristem", done.stdout, command)

    def test_version(self):
        self.assertRegex(self.run_program("--version").stdout.decode(), r"^meristem \d+\.\d+\.\d+\n$")

    def test_unknown_command_names_the_nearest(self):
        errors = self.assert_ends(WRONG_INPUT, "gorw", "box.json", "-o", "a.glb")
        self.assertIn("'gorw' was not expected; did you mean 'grow'?", errors)

    def test_unknown_option_names_the_nearest(self):
        errors = self.assert_ends(WRONG_INPUT, "grow", "box.json", "-o", "a.glb", "--thread", "2")
        self.assertIn("'--thread' was not expected; did you mean '--threads'?", errors)
        self.assertIn("'meristem grow --help' tells more", errors)

    def test_missing_or_wrong_option_values(self):
        for arguments in (["grow", "box.json"], ["grow", "-o", "a.glb"], ["grow", "box.json", "-o"],
                          ["grow", "box.json", "-o", "a.glb", "--threads", "0"],
                          ["grow", "box.json", "-o", "a.glb", "--seed", "-1"],
                          ["grow", "box.json", "-o", "a.glb", "--seed", "x"],
                          ["render", "box.json"],
                          ["render", "box.json", "-o", "a.png", "--size", "10"],
                          ["render", "box.json", "-o", "a.png", "--size", "0x10"],
                          ["render", "box.json", "-o", "a.png", "--size", "99999x10"],
                          ["render", "box.json", "-o", "a.png", "--samples", "0"],
                          ["render", "box.json", "-o", "a.png", "--view", "nan,3"],
                          ["render", "box.json", "-o", "a.png", "--view", "10,100"],
                          ["render", "box.json", "-o", "a.png", "--turntable", "0"],
                          ["render", "box.json", "-o", "a.png", "--turntable", "10001"],
                          ["render", "box.json", "-o", "a.png", "--time", "soon"],
                          ["render", "box.json", "-o", "a.png", "--time", "0:1"],
                          ["render", "box.json", "-o", "a.png", "--time", "0:1:0"],
                          ["render", "box.json", "-o", "a.png", "--time", "0:1:-1"],
                          ["render", "box.json", "-o", "a.png", "--time", "1:0:1"],
                          ["render", "box.json", "-o", "a.png", "--time", "0:inf:1"],
                          ["render", "box.json", "-o", "a.png", "--time", "0:10000:1"],
                          ["render", "box.json", "-o", "a.png", "--time", "0:1e300:1e-300"],
                          ["render", "box.json", "-o", "a.png", "--time", "0:1:1", "--turntable", "2"],
                          ["render", "box.json", "-o", "-", "--time", "0:1:1"],
                          ["grow", "box.json", "-o", "a.glb", "--time", "nan"],
                          ["grow", "box.json", "-o", "a.glb", "--time", "0:1:1"],
                          ["render", "box.json", "-o", "-", "--turntable", "2"]):
            self.assert_ends(WRONG_INPUT, *arguments)

    def test_unknown_format_names_the_known(self):
        errors = self.assert_ends(WRONG_INPUT, "grow", "box.json", "-o", "a.xyz")
        self.assertIn("'.xyz' is not a format that can be written; expected a file that ends in .glb, ", errors)
        self.assertIn("did you mean '.skeleton.ply'?",
                      self.assert_ends(WRONG_INPUT, "grow", "box.json", "-o", "a.skeleton.pyl"))
        self.assertIn("ends in .png", self.assert_ends(WRONG_INPUT, "render", "box.json", "-o", "a.gif"))

    def test_set_that_sets_nothing(self):
        self.assertIn("'points' sets nothing", self.assert_ends(WRONG_INPUT, "check", "tree.json", "--set", "points"))


class Documents(Case):
    def test_good_document(self):
        done = self.run_program("check", "tree.json")
        self.assertEqual((done.returncode, done.stdout.decode(), done.stderr.decode()),
                         (DONE, "tree.json: good, 3 components and 2 links\n", ""))

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
        self.assert_rejects('{"meristem": 1, %s, "links": [["a", "b"], ["b", "a"]]}' % boxes, "a > b > a lead in")

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
        self.assertIn("components.tree.iterations: the crown is out of reach",
                      self.assert_ends(WRONG_INPUT, "check", "far.json"))
        self.assert_ends(DONE, "check", "far.json", "--quick")

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


class Output(Case):
    def grown(self, *options):
        self.assert_ends(DONE, "grow", "tree.json", "-o", "out.glb", *options)
        return self.read("out.glb")

    def test_grown_file_is_announced(self):
        done = self.run_program("grow", "tree.json", "-o", "a.glb", "-o", "b.GLB")
        self.assertEqual(done.returncode, DONE)
        self.assertEqual(done.stdout, b"")
        self.assertRegex(done.stderr.decode(), r"^a\.glb, b\.GLB: \d+ nodes, \d+ organs, \d+ triangles, \d\.\d\d m high\n$")
        self.assertEqual(self.read("a.glb")[:4], b"glTF")
        self.assertEqual(self.read("a.glb"), self.read("b.GLB"))

    def test_same_bytes_on_any_number_of_threads(self):
        first = self.grown("--threads", "1")
        for threads in ("2", "3", "8"):
            self.assertEqual(self.grown("--threads", threads), first)

    def test_threads_that_the_system_does_not_start_are_done_without(self):
        for megabytes, threads in ((1024, "64"), (2048, "1024"), (600, "8")):
            limit = megabytes << 20
            bounded = lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit))  # noqa: E731
            done = self.run_program("grow", "tree.json", "-o", "out.csv", "--threads", threads, preexec_fn=bounded)
            with self.subTest(megabytes=megabytes, threads=threads):
                self.assertEqual(done.returncode, DONE, done.stderr)
                self.assertIn(f"{threads} threads take turns on", done.stderr.decode())

    def test_files_of_one_call_appear_together(self):
        self.write("out.glb", "before")
        os.symlink("/dev/full", self.path("full.csv"))
        self.assertEqual(self.run_program("grow", "tree.json", "-o", "out.glb", "-o", "full.csv").returncode, FAILED)
        self.assertEqual(self.read("out.glb"), b"before")
        self.assertEqual(sorted(os.listdir(self.folder)), ["box.json", "full.csv", "out.glb", "tree.json"])

    def test_seeds_are_whole_numbers_that_json_can_say(self):
        for seed in ("-1", " 1", "1 ", "1.5", "9007199254740993", "1e3"):
            with self.subTest(seed=seed):
                errors = self.assert_ends(WRONG_INPUT, "grow", "tree.json", "-o", "out.csv", f"--seed={seed}")
                self.assertIn("a whole number from 0 to 9007199254740992", errors)
        self.assert_ends(DONE, "check", "tree.json", "--quick", "--seed", "9007199254740992")

    def test_seed_and_set_change_the_plant(self):
        plain = self.grown()
        self.assertNotEqual(self.grown("--seed", "2"), plain)
        self.assertEqual(self.grown("--seed", "1"), plain)
        self.assertNotEqual(self.grown("--set", "points=200"), plain)
        self.assertNotEqual(self.grown("--set", "leaf.width=0.01"), plain)
        self.assertNotEqual(self.grown("--set", "links[0].density=40"), plain)

    def test_set_faults_name_the_option(self):
        self.assertIn("--set laef.width: components.laef.width: there is no component 'laef'; did you mean 'leaf'?",
                      self.assert_ends(WRONG_INPUT, "check", "tree.json", "--set", "laef.width=1"))

    def test_a_variable_that_breaks_a_rule_elsewhere_is_named(self):
        self.assertIn("(points is -3); expected a whole number",
                      self.assert_ends(WRONG_INPUT, "check", "tree.json", "--set", "points=-3"))

    def test_standard_input_and_output(self):
        done = self.run_program("grow", "-", "-o", "-", input=TREE.encode())
        self.assertEqual(done.returncode, DONE)
        self.assertEqual(done.stdout, self.grown())
        done = self.run_program("check", "-", input=b'{"meristem": 9}')
        self.assertIn("<standard input>:1:14: ", done.stderr.decode())
        picture = self.run_program("render", "box.json", "-o", "-", "--size", "20x10", "--samples", "1").stdout
        self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n")

    def test_a_turntable_writes_numbered_frames_from_all_sides(self):
        done = self.run_program("render", "box.json", "-o", "turn.png", "--turntable", "3", "--size", "16x16",
                                "--samples", "1")
        self.assertEqual(done.returncode, DONE)
        self.assertIn("turn_000.png to turn_002.png: 16 x 16 pixels", done.stderr.decode())
        frames = [self.read(f"turn_00{k}.png") for k in range(3)]
        self.assertEqual(len(set(frames)), 3)
        self.assertNotIn("turn.png", os.listdir(self.folder))
        # The first is the picture that there is without turning.
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
        # The camera stands where the last frame alone would have it, and a single time makes a single picture.
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
        # Where there is no crown, the picture is as it was.
        for options in ([], ["--hull"]):
            self.run_program("render", "box.json", "-o", f"box{len(options)}.png", *options, *size)
        self.assertEqual(self.read("box1.png"), self.read("box0.png"))
        # Each frame of a turntable has them, and time-lapses while there is a crown.
        self.run_program("render", "tree.json", "-o", "turn.png", "--hull", "--turntable", "2", *size)
        self.assertEqual(self.read("turn_000.png"), self.read("hull.png"))
        self.write("growing.json", TREE.replace('"influence"', '"iterations": "4 + 99*t", "influence"'))
        done = self.run_program("render", "growing.json", "-o", "grow.png", "--hull", "--time", "0:1:1", *size)
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.run_program("render", "growing.json", "-o", "bare.png", "--time", "0:1:1", *size)
        self.assertEqual(self.read("grow_000.png"), self.read("bare_000.png"))
        self.assertNotEqual(self.read("grow_001.png"), self.read("bare_001.png"))

    def test_standard_input_that_is_a_socket(self):
        import socket
        ours, theirs = socket.socketpair()
        ours.sendall(TREE.encode())
        ours.close()
        self.assertEqual(self.run_program("check", "-", stdin=theirs).returncode, DONE)
        theirs.close()

    def test_quiet_is_silent(self):
        done = self.run_program("grow", "tree.json", "-o", "out.glb", "-q")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (DONE, b"", b""))
        done = self.run_program("render", "box.json", "-o", "a.png", "--size", "9x9", "--samples", "1", "--quiet")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (DONE, b"", b""))

    def test_refused_paths_fail_before_the_work(self):
        for command, ending in (("grow", "glb"), ("render", "png")):
            options = LONG_RENDER if command == "render" else LONG_GROWTH
            errors = self.assert_ends(FAILED, command, "tree.json", "-o", "no/such/folder/a." + ending, *options)
            self.assertIn(f"cannot write 'no/such/folder/a.{ending}': No such file or directory", errors)
            os.makedirs(self.path("folder." + ending), exist_ok=True)
            errors = self.assert_ends(FAILED, command, "tree.json", "-o", "folder." + ending, *options)
            self.assertIn("Is a directory", errors)

    def test_full_disk(self):
        for command, ending in (("grow", "glb"), ("grow", "obj"), ("grow", "ply"), ("grow", "skeleton.ply"),
                                ("grow", "csv"), ("render", "png")):
            os.symlink("/dev/full", self.path("full." + ending))
            options = ["--size", "9x9", "--samples", "1"] if command == "render" else []
            errors = self.assert_ends(FAILED, command, "box.json", "-o", "full." + ending, *options)
            self.assertIn("No space left on device", errors)
        with open("/dev/full", "wb") as full:
            for arguments in (["components"], ["components", "--schema"], ["models"], ["--help"], ["--version"],
                              ["check", "box.json"], ["grow", "box.json", "-o", "-"]):
                self.assert_ends(FAILED, *arguments, stdout=full)

    def test_closed_pipe_is_a_failed_write(self):
        for arguments in (["grow", "tree.json", "-o", "-"], ["components", "--schema"]):
            process = self.start(*arguments)
            process.stdout.close()
            errors = process.stderr.read().decode()
            process.stderr.close()
            self.assertEqual(process.wait(60), FAILED, errors)
            self.assertEqual("Broken pipe" in errors, arguments[0] == "grow", errors)

    def test_standard_error_that_cannot_be_written(self):
        with open("/dev/full", "wb") as full:
            process = self.start("grow", "tree.json", "-o", "out.glb", stderr=full)
            process.stdout.close()
            self.assertEqual(process.wait(60), DONE)


class Formats(Case):
    """What the files of one plant say must be the same; they are read with Python's own means."""

    FILES = ["a.glb", "a.obj", "a.ply", "a.skeleton.ply", "a.csv", "a.mtg"]

    def setUp(self):
        super().setUp()
        outputs = [argument for name in self.FILES for argument in ("-o", name)]
        self.announcement = self.assert_ends(DONE, "grow", "tree.json", *outputs)

    def counted(self, what):
        return int(re.search(rf"(\d+) {what}", self.announcement)[1])

    def read_ply(self, name):
        """The header's comments, and a list of rows (dictionaries) for each element."""
        header, body = self.read(name).split(b"end_header\n", 1)
        codes = {"float": "f", "int": "i", "uchar": "B"}
        comments, elements = [], []
        for line in header.decode().splitlines():
            words = line.split()
            if words[0] == "comment":
                comments.append(line.removeprefix("comment "))
            elif words[0] == "element":
                elements.append((words[1], int(words[2]), [], []))
            elif words[0] == "property":
                elements[-1][2].append(words[-1])
                # All lists are triangles: a count and three numbers.
                elements[-1][3].append(codes[words[1]] if words[1] != "list" else "B3" + codes[words[3]])
        rows = {}
        for element, count, names, types in elements:
            record = struct.Struct("<" + "".join(types))
            chunk, body = body[:count * record.size], body[count * record.size:]
            rows[element] = [dict(zip(names, values)) if "B3i" not in types else values
                             for values in record.iter_unpack(chunk)]
        self.assertEqual(body, b"")
        return comments, rows

    def read_table(self):
        return list(csv.DictReader(io.StringIO(self.read("a.csv").decode(), newline="")))

    def test_all_are_written(self):
        self.assertEqual(sorted(os.listdir(self.folder)), sorted(self.FILES + ["a.mtl", "box.json", "tree.json"]))

    def test_meshes_have_the_same_vertices_and_triangles(self):
        _, ply = self.read_ply("a.ply")
        self.assertEqual(len(ply["face"]), self.counted("triangles"))
        self.assertTrue(all(count == 3 for count, *_ in ply["face"]))
        lines = self.read("a.obj").decode().splitlines()
        single = struct.Struct("<f")
        positions = [tuple(single.unpack(single.pack(float(number)))[0] for number in line.split()[1:4])
                     for line in lines if line.startswith("v ")]
        self.assertEqual(positions, [(row["x"], row["y"], row["z"]) for row in ply["vertex"]])
        faces = [tuple(int(corner.split("/")[0]) - 1 for corner in line.split()[1:])
                 for line in lines if line.startswith("f ")]
        self.assertEqual(faces, [row[1:] for row in ply["face"]])

    def test_obj_names_the_materials_of_its_mtl(self):
        lines = self.read("a.obj").decode().splitlines()
        self.assertIn("mtllib a.mtl", lines)
        self.assertEqual([line for line in lines if line.startswith("g ")], ["g tree", "g leaf"])
        used = {line.split()[1] for line in lines if line.startswith("usemtl ")}
        made = re.findall(r"^newmtl (.*)$", self.read("a.mtl").decode(), re.MULTILINE)
        self.assertEqual(sorted(used), sorted(made))

    def test_skeletons_have_the_same_nodes(self):
        comments, ply = self.read_ply("a.skeleton.ply")
        self.assertIn("component 0 tree", comments)
        self.assertIn("units: metres, y up", comments)
        table = self.read_table()
        self.assertEqual(len(table), self.counted("nodes"))
        self.assertEqual(len(ply["vertex"]), len(table))
        for number, (row, vertex) in enumerate(zip(table, ply["vertex"])):
            self.assertEqual(row["component"], "tree")
            self.assertEqual(int(row["node"]), number)
            self.assertEqual(int(row["parent"] or -1), vertex["parent"])
            self.assertLess(vertex["parent"], number)
            for column in ("instance", "axis", "order"):
                self.assertEqual(int(row[column]), vertex[column])
            for column in ("x", "y", "z", "radius", "birth"):
                self.assertEqual(struct.pack("<f", float(row[column])), struct.pack("<f", vertex[column]), column)
        edges = [(edge["vertex1"], edge["vertex2"]) for edge in ply["edge"]]
        self.assertEqual(edges, [(int(row["parent"]), int(row["node"])) for row in table if row["parent"]])

    def test_same_bytes_on_any_number_of_threads(self):
        for name in self.FILES[1:]:
            for threads in ("1", "3"):
                self.assert_ends(DONE, "grow", "tree.json", "-o", "b" + name, "--threads", threads)
                self.assertEqual(self.read("b" + name).replace(b"ba.mtl", b"a.mtl"), self.read(name))

    def test_help_lists_every_ending(self):
        text = self.run_program("grow", "--help").stdout.decode()
        self.assertEqual(re.findall(r"^  (\.\S+) ", text, re.MULTILINE), [name[1:] for name in self.FILES])


class Looks(Case):
    """Textures and instances in the files that `grow` writes."""

    TEXTURED = TREE.replace('"type": "leaf"', '"type": "leaf", "texture": {"leaf": "pinnate", "pixels": 64}, "variety": 1')

    def setUp(self):
        super().setUp()
        self.write("textured.json", self.TEXTURED)

    def grown_json(self, *options):
        """The size of a binary glTF, and its JSON."""
        self.assert_ends(DONE, "grow", "textured.json", "-o", "out.glb", *options)
        data = self.read("out.glb")
        return len(data), json.loads(data[20:20 + struct.unpack("<I", data[12:16])[0]])

    def test_pictures_stand_in_glb(self):
        _, gltf = self.grown_json()
        leaf = next(material for material in gltf["materials"] if material["name"] == "leaf")
        self.assertIn("baseColorTexture", leaf["pbrMetallicRoughness"])
        self.assertEqual({image["mimeType"] for image in gltf["images"]}, {"image/png"})

    def test_pictures_stand_beside_obj(self):
        self.assert_ends(DONE, "grow", "textured.json", "-o", "my oak.obj")
        named = set(re.findall(r"^(?:map_\w+|norm) (.*)$", self.read("my_oak.mtl").decode(), re.MULTILINE))
        self.assertIn("my_oak_leaf_colour.png", named)
        for name in named:
            self.assertEqual(self.read(name)[:8], b"\x89PNG\r\n\x1a\n")

    def test_refused_pictures_fail_before_the_work(self):
        os.mkdir(self.path("a_leaf_normals.png"))
        errors = self.assert_ends(FAILED, "grow", "textured.json", "-o", "a.obj", *LONG_GROWTH)
        self.assertIn("cannot write 'a_leaf_normals.png': Is a directory", errors)

    def test_files_that_are_read_are_never_written_over(self):
        self.assert_ends(DONE, "grow", "textured.json", "-o", "own.obj")
        picture = self.read("own_leaf_colour.png")
        self.write("own.json", TREE.replace('"type": "leaf"', '"type": "leaf", "texture": {"picture": {"colour": '
                                            '"own_leaf_colour.png"}}'))
        refused = "would be written over, and it is read"
        for command, output in (("grow", "own.obj"), ("render", "own_leaf_colour.png"), ("measure", "own.json"),
                                ("render", "./own_leaf_colour.png")):
            options = {"grow": LONG_GROWTH, "render": LONG_RENDER, "measure": LONG_GROWTH}[command]
            self.assertIn(refused, self.assert_ends(WRONG_INPUT, command, "own.json", "-o", output, *options))
        self.write("walnut.mtg", MTG)
        self.assertIn(refused, self.assert_ends(WRONG_INPUT, "measure", "walnut.mtg", "-o", "walnut.mtg"))
        self.assertEqual(self.read("own_leaf_colour.png"), picture)
        self.assertEqual(self.read("walnut.mtg").decode(), MTG)
        self.assert_ends(DONE, "grow", "own.json", "-o", "other.obj")

    def test_instanced_files_are_small_and_whole(self):
        plain_size, _ = self.grown_json()
        size, gltf = self.grown_json("--instanced")
        self.assertLess(size, plain_size)
        self.assertIn("EXT_mesh_gpu_instancing", gltf["extensionsUsed"])
        self.assertIn("EXT_mesh_gpu_instancing", gltf["nodes"][-1]["extensions"])

    def test_instanced_needs_a_format_that_can(self):
        for option in ("--instanced", "--nodes"):
            errors = self.assert_ends(WRONG_INPUT, "grow", "textured.json", "-o", "a.obj", option)
            self.assertIn(f"{option} changes none of the files; expected a file that ends in .glb", errors)
        self.assert_ends(WRONG_INPUT, "grow", "textured.json", "-o", "a.glb", "--instanced", "--nodes")

    def test_same_bytes_on_any_number_of_threads(self):
        for options in ([], ["--instanced"]):
            files = []
            for threads in ("1", "3"):
                self.assert_ends(DONE, "grow", "textured.json", "-o", "out.glb", "--threads", threads, *options)
                files.append(self.read("out.glb"))
            self.assertEqual(files[0], files[1])


MTG = """CODE:\tFORM-A
CLASSES:
P\t1\tFREE\tFREE\tEXPLICIT
A\t2\tFREE\tFREE\tEXPLICIT
S\t3\tFREE\tFREE\tEXPLICIT
FEATURES:
XX\tREAL
YY\tREAL
ZZ\tREAL
Thickness\tREAL
MTG:
ENTITY-CODE\t\tXX\tYY\tZZ\tThickness
/P1
^/A1\t\t0\t0\t0\t400
^/S1\t\t0\t0\t200\t200
\t+A1/S1\t100\t0\t300\t120
^<S2\t\t0\t0\t400\t160
"""


class Measuring(Case):
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
        self.assertNotIn("leaf_count", measures["each"][0])
        self.assertEqual([(tree["component"], tree["instance"], tree["position"]) for tree in measures["each"]],
                         [("left", 0, [-3, 0, 0]), ("right", 0, [3, 0, 0])])
        self.assertIn(b"\ntree 2: right 0, at 3, 0, 0\n", self.run_program("measure", "stand.json", "--each").stdout)

    def test_light_on_leaves_only_if_asked(self):
        self.assertEqual(self.measured("tree.json")["leaf_exposure"], None)
        self.write("walnut.mtg", MTG)
        self.assertEqual(self.measured("walnut.mtg", "--unit", "cm")["lit_share"], None)
        measures = self.measured("tree.json", "--light")
        self.assertGreater(measures["leaf_exposure"], measures["leaf_irradiance"])
        self.assertGreater(measures["leaf_irradiance"], 0)
        self.assertLess(measures["leaf_exposure"], 1)
        # Under a roof no sun comes to crown and leaves.
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
        area = sum(float(row["area"]) for row in rows)
        self.assertAlmostEqual(area, measures["leaf_area"], places=5)
        for column in ("exposure", "irradiance"):
            mean = sum(float(row["area"]) * float(row[column]) for row in rows) / area
            self.assertAlmostEqual(mean, measures["leaf_" + column], places=5)
        for threads in ("1", "8"):
            done = self.run_program("measure", "tree.json", "--organs", "-", "-o", "a.json", "--threads", threads)
            self.assertEqual(done.stdout, self.read("leaves.csv"))

    def test_wrong_uses_of_the_table_of_organs(self):
        for arguments, message in ((["tree.json", "--organs", "tree.json"], "would be written over, and it is read"),
                                   (["tree.json", "--organs", "-"], "would be written to the same file"),
                                   (["tree.json", "--organs", "./a", "-o", "a"], "would be written to the same file"),
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
        self.assertEqual(done.stderr.decode(), "warning: walnut.mtg: the plant is 400 m high; --unit says what its "
                                               "coordinates are in\n")
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


class Listing(Case):
    def test_components_and_their_parameters(self):
        listed = self.run_program("components").stdout.decode()
        names = [line.split()[0] for line in listed.splitlines()]
        self.assertIn("colonize", names)
        for name in names:
            done = self.run_program("components", name)
            self.assertEqual(done.returncode, DONE)
            self.assertTrue(done.stdout.decode().startswith(name + ": "))
        self.assertIn("length - a number (m) from 0.0001 to 100; default 0.08",
                      self.run_program("components", "leaf").stdout.decode())

    def test_links_and_variables_are_listed_as_components_are(self):
        links = self.run_program("components", "link").stdout.decode()
        self.assertIn("density - a number", links)
        self.assertIn("a crown link: ", links)
        self.assertIn("private", self.run_program("components", "variable").stdout.decode())

    def test_unknown_component_names_the_nearest(self):
        self.assertIn("did you mean 'leaf'?", self.assert_ends(WRONG_INPUT, "components", "laef"))

    def test_schema_is_json(self):
        schema = json.loads(self.run_program("components", "--schema").stdout)
        self.assertEqual(schema["$schema"], "http://json-schema.org/draft-07/schema#")

    def test_tables_are_json_for_editors(self):
        done = self.run_program("components", "--json")
        self.assertEqual(done.returncode, DONE)
        self.assertEqual(done.stdout.count(b"\n"), 1)
        tables = json.loads(done.stdout)
        self.assertEqual(tables["format"], 1)
        rows = {row["name"]: row for row in tables["tables"][tables["components"]["leaf"]["table"]]["rows"]}
        length = rows["length"]
        self.assertEqual((length["kind"], length["unit"], length["min"], length["max"], length["default"]),
                         ("number", "m", 0.0001, 100, 0.08))
        self.assertTrue(length["min"] <= length["usual"][0] < 0.08 < length["usual"][1] <= 1)
        self.assertEqual(length["varies"], "instance")
        for table in tables["tables"].values():
            for row in table["rows"]:
                self.assertIn(row.get("table", "leaf"), tables["tables"])
        self.assert_ends(WRONG_INPUT, "components", "--json", "--schema")

    def test_models(self):
        lines = self.run_program("models").stdout.decode().splitlines()
        self.assertIn("oak", [line.split()[0] for line in lines])
        for line in lines:
            self.assertGreater(len(line.split()), 2, "a description: " + line)
        for path in self.run_program("models", "--paths").stdout.decode().splitlines():
            self.assert_ends(DONE, "check", path)


class Signals(Case):
    def test_render_leaves_nothing(self):
        before = sorted(os.listdir(self.folder))
        errors = self.stop(signal.SIGINT, "render", "tree.json", "-o", "a.png", *LONG_RENDER)
        self.assertIn("nothing was left half-written", errors)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_growth_leaves_an_existing_file(self):
        self.write("a.glb", "before")
        before = sorted(os.listdir(self.folder))
        self.stop(signal.SIGTERM, "grow", "tree.json", "-o", "a.glb", *LONG_GROWTH)
        self.assertEqual(sorted(os.listdir(self.folder)), before)
        self.assertEqual(self.read("a.glb"), b"before")

    def test_measuring_leaves_nothing(self):
        before = sorted(os.listdir(self.folder))
        self.stop(signal.SIGINT, "measure", "tree.json", "-o", "a.txt", "--organs", "a.csv", *LONG_GROWTH)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_ignored_signals_stay_ignored(self):
        process = self.start("render", "tree.json", "-o", "a.png", *LONG_RENDER,
                             preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
        process.stderr.readline()
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, -signal.SIGTERM)

    def test_terminal_shows_a_bar_and_takes_it_away(self):
        ours, theirs = pty.openpty()
        process = self.start("render", "tree.json", "-o", "a.png", *LONG_RENDER, stderr=theirs)
        os.close(theirs)
        shown = b""
        deadline = time.monotonic() + 120
        while not re.search(rb"rendering +\[=* *\] +\d+ %", shown) and time.monotonic() < deadline:
            if select.select([ours], [], [], 1)[0]:
                shown += os.read(ours, 4096)
        self.assertRegex(shown, rb"\r\x1b\[Krendering +\[=* *\] +\d+ %")
        process.send_signal(signal.SIGINT)
        try:
            while piece := os.read(ours, 4096):
                shown += piece
        except OSError:  # how a terminal ends on Linux
            pass
        os.close(ours)
        process.stdout.close()
        self.assertEqual(process.wait(60), -signal.SIGINT)
        self.assertRegex(shown, rb"\r\x1b\[Kmeristem: stopped")


if __name__ == "__main__":
    unittest.main()
