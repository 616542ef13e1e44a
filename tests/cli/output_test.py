#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Files that `meristem grow` writes: complete or missing, and equal for any number of threads.

Usage: output_test.py PROGRAM [unittest options]
"""

import os
import resource
import unittest

import cli_case
from cli_case import DONE, FAILED, LONG_GROWTH, LONG_RENDER, TREE, WRONG_INPUT


class Output(cli_case.Case):
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


if __name__ == "__main__":
    unittest.main()
