#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Hostile files must not read outside a root, control the terminal, or put infinities into files."""

import json
import os
import unittest

import cli_case
from cli_case import DONE, FAILED, WRONG_INPUT

LEAF = {"meristem": 1, "components": {"leaf": {"type": "leaf"}}}

# Escape (C0), escape (C1), delete, right-to-left override, isolate, line separator.
HOSTILE = "a\x1b[2J\u009b31m\x7f\u202egpj\u2066\u2028\x07"
ESCAPED = "a\\u001b[2J\\u009b31m\\u007f\\u202egpj\\u2066\\u2028\\u0007"


def document(**components):
    return json.dumps({"meristem": 1, "components": components})


# One document for each kind of file that a document can name; each names FILE.
NAMING = {
    "skeleton table": document(tree={"type": "skeleton", "file": "FILE"}),
    "crown mesh": document(tree={"type": "colonize", "points": 50, "crown": {"mesh": "FILE"}}),
    "points": document(tree={"type": "colonize", "points": {"file": "FILE"}}),
    "obstacle": json.dumps({**LEAF, "scene": {"obstacles": [{"mesh": "FILE"}]}}),
    "picture": document(leaf={"type": "leaf", "texture": {"picture": {"colour": "FILE"}}}),
    "places": document(places={"type": "places", "table": "FILE"}, leaf={"type": "leaf"}),
    "sample": document(leaf={"type": "leaf", "length": {"sample": {"file": "FILE", "column": "x"}}}),
    "grammar": document(plant={"type": "lsystem", "file": "FILE"}),
    "included grammar": document(plant={"type": "lsystem", "grammar": ["#include FILE as T", "T"]}),
    "placed document": document(plant={"type": "document", "file": "FILE"}),
}


class Root(cli_case.Case):
    def setUp(self):
        super().setUp()
        os.mkdir(self.path("inside"))
        self.write("outside.csv", "x,y,z,parent\n0,0,0,-1\n")

    def refused(self, *arguments):
        errors = self.assert_ends(WRONG_INPUT, *arguments)
        self.assertIn("outside the folder that may be read", errors, arguments)
        return errors

    def test_no_kind_of_named_file_is_read_from_outside(self):
        os.symlink("../outside.csv", self.path("inside/link.csv"))
        os.symlink("../missing.csv", self.path("inside/nowhere.csv"))
        names = {
            "../outside.csv": "../missing.csv",
            self.path("outside.csv"): self.path("missing.csv"),
            "link.csv": "nowhere.csv",
            "x/../../outside.csv": "x/../../missing.csv",
        }
        for kind, text in NAMING.items():
            for there, missing in names.items():
                told = []
                for name in (there, missing):
                    self.write("inside/plant.json", text.replace("FILE", name))
                    errors = self.refused("check", "inside/plant.json", "--root", "inside")
                    told.append(errors.replace(name, "NAME"))
                self.assertEqual(told[0], told[1], f"{kind} tells whether {there} exists")

    def test_files_inside_are_read(self):
        self.write("inside/nodes.csv", "x,y,z,parent,radius\n0,0,0,-1,0.1\n0,0,1,0,0.1\n")
        self.write("inside/plant.json", NAMING["skeleton table"].replace("FILE", "nodes.csv"))
        self.assert_ends(DONE, "check", "inside/plant.json", "--root", "inside")
        self.assert_ends(DONE, "check", "inside/plant.json", "--root", ".")

    def test_documents_themselves_lie_inside(self):
        there = self.refused("check", "tree.json", "--root", "inside")
        missing = self.refused("check", "tree.jsom", "--root", "inside")
        self.assertEqual(there.replace("tree.json", "NAME"), missing.replace("tree.jsom", "NAME"))
        os.symlink("../tree.json", self.path("inside/tree.json"))
        self.refused("check", "inside/tree.json", "--root", "inside")

    def test_shipped_models_may_be_read(self):
        self.assert_ends(DONE, "check", "bush", "--quick", "--root", "inside")
        os.symlink("tree.json", self.path("oak"))  # a file with that name outside must not be used
        self.assert_ends(DONE, "check", "oak", "--quick", "--root", "inside")

    def test_all_commands_that_read_documents_keep_to_the_root(self):
        for command in (
            ["grow", "tree.json", "-o", "out.glb"],
            ["render", "tree.json", "-o", "out.png"],
            ["measure", "tree.json"],
            ["measure", "outside.csv"],
            ["shade", "tree.json", "--facade", "house", "--days", "172", "--hours", "6:20:1", "-o", "out.json"],
            ["scan", "tree.json", "-o", "out.csv"],
            ["derive", "tree.json"],
            ["graph", "tree.json"],
            ["check", "tree.json"],
            ["plan", "tree.json"],
            ["dataset", "tree.json", "-o", "out"],
        ):
            self.refused(*command, "--root", "inside")

    def test_grammars_include_from_inside(self):
        self.write("outside.txt", "A -> B\n")
        for name in ("../outside.txt", "../missing.txt"):
            self.write("inside/plant.txt", f"#include {name} as T\n#steps 1\nT\n")
            self.refused("derive", "inside/plant.txt", "--root", "inside")


class Terminal(cli_case.Case):
    def shown(self, *arguments):
        done = self.run_program(*arguments)
        for text in (done.stdout.decode(), done.stderr.decode()):
            for character in text:
                self.assertTrue(character == "\n" or character.isprintable() or character == "\t",
                                f"{arguments}: {character!r} in {text!r}")
        return done.returncode, done.stdout.decode() + done.stderr.decode()

    def test_names_of_files_are_escaped_in_messages_of_success(self):
        self.write(HOSTILE + ".json", cli_case.TREE)
        for command in (
            ["check"],
            ["grow", "-o", HOSTILE + ".glb"],
            ["grow", "-o", HOSTILE + ".csv"],
            ["render", "--size", "20x20", "--samples", "1", "-o", HOSTILE + ".png"],
            ["graph", "-o", HOSTILE + ".svg"],
            ["measure", "-o", HOSTILE + ".txt"],
        ):
            code, _ = self.shown(command[0], HOSTILE + ".json", *command[1:])
            self.assertEqual(code, DONE, command)
        self.assertIn(ESCAPED, self.shown("check", HOSTILE + ".json")[1])

    def test_names_of_files_are_escaped_in_messages_of_faults(self):
        self.write(HOSTILE, "{")
        for command in ("check", "measure", "graph", "plan", "derive", "dataset", "scan", "shade", "render", "grow"):
            for name in (HOSTILE, "no" + HOSTILE + ".json"):
                code, told = self.shown(command, name, *(["-o", "out.glb"] if command == "grow" else []))
                self.assertNotEqual(code, DONE, command)
        code, told = self.shown("grow", "tree.json", "-o", f"none/{HOSTILE}.glb")
        self.assertEqual(code, FAILED)
        self.assertIn(ESCAPED, told)

    def test_bytes_that_are_no_text_are_escaped(self):
        name = b"caf\xe9\x9b.json"
        with open(os.path.join(os.fsencode(self.folder), name), "wb") as file:
            file.write(cli_case.TREE.encode())
        code, told = self.shown("check", name)
        self.assertEqual(code, DONE)
        self.assertIn("caf\\xe9\\x9b.json: good", told)

    def test_names_in_documents_are_escaped(self):
        for text in (
            document(**{HOSTILE: {"type": "leaf"}}),
            document(leaf={"type": HOSTILE}),
            document(leaf={"type": "leaf", HOSTILE: 1}),
            document(leaf={"type": "leaf", "length": HOSTILE}),
            document(tree={"type": "skeleton", "file": HOSTILE}),
            json.dumps({**LEAF, HOSTILE: 1}),
            json.dumps({**LEAF, "name": HOSTILE}),
            json.dumps({**LEAF, "variables": {"unused": {"value": 1, "doc": HOSTILE}}}),
            json.dumps({**LEAF, "links": [["leaf", HOSTILE]]}),
        ):
            self.write("named.json", text)
            self.shown("check", "named.json")
            self.shown("measure", "named.json", "--each")
            self.shown("grow", "named.json", "-o", "out.csv")


class Numbers(cli_case.Case):
    def test_radii_beyond_all_measure_are_refused_with_their_place(self):
        self.write("nodes.csv", "x,y,z,radius,parent\n0,0,0,0.1,-1\n0,0,1,1e308,0\n")
        self.write("tree.json", NAMING["skeleton table"].replace("FILE", "nodes.csv"))
        for output in ("out.glb", "out.obj", "out.csv"):
            errors = self.assert_ends(WRONG_INPUT, "grow", "tree.json", "-o", output)
            self.assertIn("nodes.csv:3:7", errors)
        self.assertIn("nodes.csv:3:7", self.assert_ends(WRONG_INPUT, "measure", "nodes.csv"))

    def test_every_number_of_a_document_has_a_range(self):
        tables = json.loads(self.run_program("components", "--json").stdout)["tables"]
        kinds = ("number", "integer", "vector", "points", "positions", "box", "integers")
        endless = [
            (table, row["name"])
            for table, rows in tables.items()
            for row in rows["rows"]
            if row["kind"] in kinds and not ("max" in row and ("min" in row or "above" in row))
        ]
        # Values of variables are used in other numbers, which have ranges.
        self.assertEqual(sorted(endless),
                         [("set_value", "value"), ("variable", "max"), ("variable", "min"), ("variable", "value")])

    def test_scales_that_multiply_each_other_lead_to_no_infinity(self):
        components = {f"p{k}": {"type": "simple", "frame": {"scale": [1000, 1000, 1000]}} for k in range(30)}
        links = [[f"p{k}", f"p{k + 1}"] for k in range(29)]
        self.write("plant.json", json.dumps({"meristem": 1, "components": components, "links": links}))
        for output in ("out.glb", "out.obj", "out.ply"):
            self.assertIn("finite", self.assert_ends(WRONG_INPUT, "grow", "plant.json", "-o", output))

    def test_numbers_of_documents_lead_to_no_infinity(self):
        """Sets numbers to 1e308, one at a time. The document must be rejected, or the files must contain finite
        numbers."""
        for kind in ("leaf", "tree", "simple", "revolution"):
            for member, value in (
                ("frame", {"scale": [1e308, 1, 1]}),
                ("frame", {"translate": [1e308, 0, 0]}),
                ("length", 1e308),
                ("length", "1e300*1e300"),
                ("radius", 1e308),
                ("size", [1e308, 1e308, 1e308]),
            ):
                self.write("plant.json", document(plant={"type": kind, member: value}))
                for output in ("out.obj", "out.csv"):
                    done = self.run_program("grow", "plant.json", "-o", output)
                    if done.returncode == DONE:
                        self.assertNotRegex(self.read(output).lower(), rb"\b(inf|nan)\b", (kind, member, value))
                    else:
                        self.assertEqual(done.returncode, WRONG_INPUT, done.stderr)
                        self.assertFalse(os.path.exists(self.path(output)))


if __name__ == "__main__":
    unittest.main()
