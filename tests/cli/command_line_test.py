#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Commands, options and listings from the user's view: help, exit codes, nearest names.

Usage: command_line_test.py PROGRAM [unittest options]
"""

import json
import pathlib
import re
import unittest

import cli_case
from cli_case import DONE, WRONG_INPUT


class CommandLine(cli_case.Case):
    def test_no_command_prints_help(self):
        self.assertIn(b"grow", self.run_program().stdout)

    def test_every_command_has_help_with_an_example(self):
        for command in ([], ["grow"], ["render"], ["measure"], ["derive"], ["check"], ["components"], ["models"], ["studio"]):
            done = self.run_program(*command, "--help")
            self.assertEqual(done.returncode, DONE)
            self.assertIn(b"Example: meristem", done.stdout, command)

    def test_version(self):
        line = self.run_program("--version").stdout.decode()
        self.assertRegex(line, r"^meristem \d+\.\d+\.\d+( \(([0-9a-f]{8,40}, )?\w+\))?\n$")

    def test_no_file_depends_on_the_commit(self):
        commit = re.search(rb"\(([0-9a-f]{8,40}), ", self.run_program("--version").stdout)
        if not commit:
            self.skipTest("the program was built without git")
        for name in ("a.glb", "a.csv", "a.mtg", "a.png"):
            self.assert_ends(DONE, "render" if name == "a.png" else "grow", "tree.json", "-o", name)
            self.assertNotIn(commit[1], self.read(name), name)

    def test_unknown_command_names_the_nearest(self):
        errors = self.assert_ends(WRONG_INPUT, "gorw", "box.json", "-o", "a.glb")
        self.assertIn("'gorw' was not expected; did you mean 'grow'?", errors)

    def test_unknown_option_names_the_nearest(self):
        errors = self.assert_ends(WRONG_INPUT, "grow", "box.json", "-o", "a.glb", "--thread", "2")
        self.assertIn("'--thread' was not expected; did you mean '--threads'?", errors)
        self.assertIn("'meristem grow --help' lists what is allowed", errors)

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


class Listing(cli_case.Case):
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
        paths = [pathlib.Path(path) for path in self.run_program("models", "--paths").stdout.decode().splitlines()]
        self.assertEqual([path.stem for path in paths], [line.split()[0] for line in lines])
        self.assertTrue(all(path.is_file() for path in paths))
        self.assert_ends(DONE, "check", str(paths[0]))


if __name__ == "__main__":
    unittest.main()
