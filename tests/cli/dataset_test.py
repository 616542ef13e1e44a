#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Data sets and the annotations of pictures from the user's view. Usage: dataset_test.py PROGRAM"""

import csv
import io
import json
import os
import pathlib
import shutil
import signal
import struct
import time
import unittest
import zlib

import cli_case
from cli_case import DONE, FAILED, PARTLY_DONE, WRONG_INPUT

ROD = json.dumps({
    "meristem": 1,
    "variables": {"tall": {"value": 1, "min": 0.5, "max": 2}},
    "components": {"rod": {"type": "tree", "length": "tall", "radius": 0.02, "segments": 4},
                   "leaf": {"type": "leaf", "length": 0.2, "width": 0.1}},
    "links": [{"from": "rod", "to": "leaf", "kind": "branch", "density": 5}],
})
PLAN = {"meristem_dataset": 1, "documents": ["rod.json"], "seeds": 60, "rows": 25, "files": [".mtg"],
        "measures": ["height"], "vary": {"tall": {"uniform": [0.5, 2]}}}


def png_size_and_kind(data):
    """Returns width, height, bits per channel and colour type."""
    return struct.unpack(">IIBB", data[16:26])


def rows_of_png(data):
    """Returns the bytes of each row of a PNG, with filters of all kinds undone (PNG specification, 9.2)."""
    width, height, bits, kind = png_size_and_kind(data)
    step = {0: 1, 2: 3, 6: 4}[kind] * bits // 8
    packed, at = b"", 8
    while at < len(data):
        length = struct.unpack(">I", data[at:at + 4])[0]
        if data[at + 4:at + 8] == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    raw, before, rows = zlib.decompress(packed), bytes(width * step), []
    for y in range(height):
        line = raw[y * (width * step + 1):(y + 1) * (width * step + 1)]
        row = bytearray(line[1:])
        for k in range(len(row)):
            left = row[k - step] if k >= step else 0
            up, corner = before[k], before[k - step] if k >= step else 0
            guess = left + up - corner
            nearest = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            row[k] = (row[k] + [0, left, up, (left + up) // 2, nearest][line[0]]) & 255
        before = bytes(row)
        rows.append(before)
    return rows


class DataSets(cli_case.Case):
    def setUp(self):
        super().setUp()
        self.write("rod.json", ROD)
        self.write("plan.json", json.dumps(PLAN))

    def content(self, folder):
        """Returns all files of a data set except partial ones."""
        root = pathlib.Path(self.folder, folder)
        return {str(path.relative_to(root)): path.read_bytes() for path in sorted(root.rglob("*"))
                if path.is_file() and path.relative_to(root).parts[0] != "partial"}

    def test_same_bytes_on_any_number_of_threads(self):
        done = self.assert_ends(DONE, "dataset", "plan.json", "-o", "one", "--threads", "1")
        self.assertIn("one: 60 plants", done)
        one = self.content("one")
        for threads in ("3", "8"):
            self.assert_ends(DONE, "dataset", "plan.json", "-o", threads, "--threads", threads, "-q")
            self.assertEqual(self.content(threads), one)
        rows = list(csv.DictReader(io.StringIO("".join(
            one[f"manifest/{table:05}.csv"].decode().partition("\n")[2] if table else one["manifest/00000.csv"].decode()
            for table in range(3)))))
        self.assertEqual([row["key"] for row in rows], [f"{number:06}" for number in range(60)])
        for row in rows:
            self.assertEqual(len(one[row["files"]]), int(row["bytes"]))

    def test_goes_on_by_plan_or_folder_and_checks(self):
        self.assert_ends(DONE, "dataset", "plan.json", "-o", "rods", "-q")
        whole = self.content("rods")
        os.remove(os.path.join(self.folder, "rods/plants/0000/000030.mtg"))
        self.write("rods/plants/0000/000031.mtg", self.read("rods/plants/0000/000032.mtg").decode() + " ")
        done = self.assert_ends(FAILED, "dataset", "rods", "--verify")
        self.assertIn("000030.mtg is missing", done)
        self.assertIn("--repair makes again", done)
        done = self.assert_ends(DONE, "dataset", "rods")
        self.assertIn("what was not right was made again", done)
        self.assertIn("60 plants, 58 of them were there", done)
        self.assertEqual(self.content("rods"), whole)
        self.write("rods/plants/0000/000031.mtg", whole["plants/0000/000031.mtg"].decode().replace("A1", "A2", 1))
        self.write("rods/documents/rod/more.json", "{}")
        self.write("rods/plants/0000/.000003.mtg.4711-0.part", "half")
        self.assertIn("more.json belonged to no document and was removed",
                      self.assert_ends(DONE, "dataset", "rods", "--repair"))
        done = self.assert_ends(DONE, "dataset", "rods", "--verify")
        self.assertIn("60 of 60 plants, 0 failed, 60 files", done)
        self.assertEqual(self.content("rods"), whole)

    def test_a_killed_program_loses_nothing(self):
        many = dict(PLAN, seeds=2000, rows=500)
        self.write("many.json", json.dumps(many))
        process = self.start("dataset", "many.json", "-o", "killed", "-q")
        rows = pathlib.Path(self.folder, "killed/partial/rows")
        deadline = time.monotonic() + 60
        while not (rows.is_dir() and len(list(rows.iterdir())) >= 2) and time.monotonic() < deadline:
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
        process.communicate(timeout=60)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "killed/README.md")))
        told = self.assert_ends(FAILED, "dataset", "killed", "--verify")
        self.assertRegex(told, r"killed/manifest/0000\d.csv is missing: 500 plants")
        self.assertNotIn("changed", told)
        self.assert_ends(DONE, "dataset", "killed", "-q")
        self.assert_ends(DONE, "dataset", "many.json", "-o", "whole", "-q")
        self.assertEqual(self.content("killed"), self.content("whole"))

    def test_killed_at_any_moment_it_goes_on(self):
        many = dict(PLAN, seeds=300, rows=20)
        self.write("many.json", json.dumps(many))
        self.assert_ends(DONE, "dataset", "many.json", "-o", "whole", "-q")
        rows = pathlib.Path(self.folder, "killed")
        for tables in (0, 1, 3, 6, 10):
            process = self.start("dataset", "many.json", "-o", "killed", "-q", "--threads", "2")
            deadline = time.monotonic() + 60
            while (process.poll() is None and time.monotonic() < deadline
                   and len(list(rows.glob("manifest/*.csv"))) < tables):
                time.sleep(0.001)
            process.send_signal(signal.SIGKILL)
            process.communicate(timeout=60)
        self.assert_ends(DONE, "dataset", "many.json", "-o", "killed", "-q")
        self.assert_ends(DONE, "dataset", "killed", "--verify")
        self.assertEqual(self.content("killed"), self.content("whole"))
        left = [path for path in rows.rglob("*") if path.name.endswith(".part") or path.name.startswith("plant-")]
        self.assertEqual(left, [])

    def damages(self, whole):
        """Yields ways to damage a data set: file, bytes, and the expected message."""
        table = "manifest/00001.csv"
        lines = whole[table].splitlines(keepends=True)
        columns = lines[0].decode().rstrip().split(",")

        def changed(*changes):
            rows = [line.decode().rstrip("\n").split(",") for line in lines]
            for row, column, field in changes:
                rows[row][columns.index(column)] = field
            return "".join(",".join(row) + "\n" for row in rows).encode()

        def field(row, column):
            return lines[row].decode().rstrip().split(",")[columns.index(column)]

        height = field(3, "height")
        yield table, changed((3, "height", height[:-1] + ("1" if height[-1] != "1" else "2"))), \
            [f"{table}:4: row 000027, column 'height' ('"]
        yield table, changed((3, "height", field(9, "height")), (9, "height", field(3, "height"))), \
            [f"{table}:4: row 000027, column 'height'", f"{table}:10: row 000033, column 'height'"]
        yield table, changed((3, "tall", field(9, "tall")), (9, "tall", field(3, "tall"))), \
            [f"{table}:4: row 000027, column 'tall': '{field(9, 'tall')}' has changed; the plan draws '{field(3, 'tall')}'",
             f"{table}:10: row 000033, column 'tall'"]
        yield table, b"".join([*lines[:4], lines[5], lines[4], *lines[6:]]), [f"{table}:5: the row 000029 follows"]
        yield table, b"".join([*lines[:4], lines[3], *lines[4:]]), [f"{table}:5: the row 000027 stands twice"]
        yield "plan.json", whole["plan.json"].replace(b"60", b"61"), \
            ["plan.json: the plan has changed since the data set was begun: 'seeds' is '61', and was '60'"]
        yield "README.md", whole["README.md"] + b"more", ["README.md has other bytes than were written"]
        yield "dataset.json", whole["dataset.json"].replace(b'"plants": 60', b'"plants": 59'), \
            ["dataset.json: 'plants' is 59; the plan says 60"]
        yield "plants/0000/000031.mtg", whole["plants/0000/000031.mtg"][:-1] + b" ", \
            ["plants/0000/000031.mtg has other bytes than were written"]

    def test_each_damage_is_told_and_repaired(self):
        self.assert_ends(DONE, "dataset", "plan.json", "-o", "rods", "-q")
        whole = self.content("rods")
        self.assertIn("all as written", self.assert_ends(DONE, "dataset", "rods", "--verify"))
        for name, damaged, messages in self.damages(whole):
            with self.subTest(messages[0]):
                self.write("rods/" + name, damaged)
                told = self.assert_ends(FAILED, "dataset", "rods", "--verify")
                for message in messages:
                    self.assertIn("rods/" + message, told)
                self.assertIn("was not right was made again", self.assert_ends(DONE, "dataset", "rods", "--repair"))
                self.assertIn("all as written", self.assert_ends(DONE, "dataset", "rods", "--verify"))
                self.assertEqual(self.content("rods"), whole)

    def test_a_repair_says_what_it_cannot_repair(self):
        self.assert_ends(DONE, "dataset", "plan.json", "-o", "rods", "-q")
        whole = self.content("rods")
        for damaged in (ROD + " ", "{", ROD.replace("0.02", "0.03")):
            self.write("rods/documents/rod/rod.json", damaged)
            told = self.assert_ends(FAILED, "dataset", "rods", "--verify")
            self.assertIn("rods/documents/rod/rod.json has changed since the data set was begun", told)
            told = self.assert_ends(FAILED, "dataset", "rods", "--repair")
            self.assertIn("'rods' cannot be repaired from the folder alone", told)
            self.assertIn("meristem dataset PLAN -o rods --repair", told)
            self.assert_ends(DONE, "dataset", "plan.json", "-o", "rods", "--repair")
            self.assertEqual(self.content("rods"), whole)

    def test_tables_without_hashes_are_not_certified(self):
        self.assert_ends(DONE, "dataset", "plan.json", "-o", "rods", "-q")
        whole = self.content("rods")
        info = json.loads(self.read("rods/dataset.json"))
        for name in ("files", "tables", "hash"):
            del info[name]
        del info["documents"][0]["files"]
        info["meristem_dataset_folder"] = 1
        self.write("rods/dataset.json", json.dumps(info))
        shutil.rmtree(os.path.join(self.folder, "rods/checks"))
        told = self.assert_ends(FAILED, "dataset", "rods", "--verify")
        self.assertIn("rods/dataset.json: the tables could not be checked", told)
        self.assertIn("--allow-old accepts them", told)
        self.assertNotIn("as written", told)
        told = self.assert_ends(DONE, "dataset", "rods", "--verify", "--allow-old")
        self.assertIn("warning: rods/dataset.json: the tables could not be checked", told)
        self.assertIn("as written as far as it was checked", told)
        os.remove(os.path.join(self.folder, "rods/plants/0000/000030.mtg"))
        told = self.assert_ends(FAILED, "dataset", "rods", "--verify", "--allow-old")
        self.assertIn("000030.mtg is missing", told)
        self.assert_ends(WRONG_INPUT, "dataset", "rods", "--allow-old")
        self.assert_ends(DONE, "dataset", "rods", "-q")
        self.assertEqual(self.content("rods"), whole)
        self.assertIn("all as written", self.assert_ends(DONE, "dataset", "rods", "--verify"))

    def test_links_lead_nowhere_outside_the_root(self):
        os.mkdir(os.path.join(self.folder, "sets"))
        shutil.copy(os.path.join(self.folder, "rod.json"), os.path.join(self.folder, "sets"))
        shutil.copy(os.path.join(self.folder, "plan.json"), os.path.join(self.folder, "sets"))
        rods = "sets/rods"
        self.assert_ends(DONE, "dataset", "sets/plan.json", "-o", rods, "-q", "--root", "sets")
        whole = self.content(rods)
        ways = {"plants/0000/000004.mtg": "a plant", "checks/plan.json": "the copy of the plan", "plants": "all plants",
                "manifest/00001.csv": "a table", "documents/rod": "a document"}
        for name, what in ways.items():
            with self.subTest(what):
                inside, outside = os.path.join(self.folder, rods, name), os.path.join(self.folder, "outside")
                shutil.move(inside, outside)
                os.symlink(outside, inside)
                before = self.content(rods)
                for arguments in ([rods, "--verify"], [rods, "--repair"], [rods],
                                  ["sets/plan.json", "-o", rods, "--repair"]):
                    told = self.assert_ends(WRONG_INPUT, "dataset", *arguments, "--root", "sets")
                    self.assertIn(f"{rods}/{name}: this link leads outside the folder that may be read", told)
                self.assertEqual(self.content(rods), before)
                os.remove(inside)
                shutil.move(outside, inside)
                os.symlink(inside, os.path.join(self.folder, rods, "partial", "inside"))
                self.assertIn("all as written", self.assert_ends(DONE, "dataset", rods, "--verify", "--root", "sets"))
                self.assert_ends(DONE, "dataset", rods, "--repair", "--root", "sets")
                os.remove(os.path.join(self.folder, rods, "partial", "inside"))
        self.assertEqual(self.content(rods), whole)

    def test_says_how_many_plants_have_failed(self):
        self.write("some.json", """{"meristem": 1, "variables": {"q": {"value": 10}}, "limits": {"nodes": 33},
          "components": {"p": {"type": "lsystem", "steps": 6,
                               "grammar": ["A", "A : 1 -> F[+A][-A]", "A : 1 -> FA"]}}}""")
        self.write("some_plan.json", json.dumps({"meristem_dataset": 1, "documents": ["some.json"], "seeds": 12,
                                                 "measures": ["nodes"], "files": [".glb"]}))
        for arguments in (["some_plan.json", "-o", "some"], ["some"], ["some", "-q"], ["some", "--repair"]):
            done = self.run_program("dataset", *arguments)
            last = done.stderr.decode().splitlines()[-1]
            self.assertEqual(done.returncode, PARTLY_DONE, last)
            self.assertRegex(last, r"^some: \d+ of 12 plants written, \d+ failed: 0000\d\d: .*nodes.*"
                                   r"; \d+ more in the column 'error' of the manifest$")
        rows = list(csv.DictReader(io.StringIO(self.read("some/manifest/00000.csv").decode())))
        failed = sum(row["error"] != "" for row in rows)
        self.assertIn(f"{12 - failed} of 12 plants written, {failed} failed", last)
        told = self.assert_ends(DONE, "dataset", "some", "--verify")
        self.assertIn(f"12 of 12 plants, {failed} failed", told)

    def test_refuses_what_is_not_its_own(self):
        self.assert_ends(DONE, "dataset", "plan.json", "-o", "rods", "-q")
        before = self.content("rods")
        self.write("other.json", json.dumps(dict(PLAN, seeds=5)))
        cases = [(("other.json", "-o", "rods"), "another plan: 60 plants"),
                 (("plan.json", "-o", "rods", "--fresh"), "holds a data set already"),
                 (("plan.json",), "no folder for the data set is given"),
                 (("rod.json", "-o", "x"), "'meristem' is not a parameter of a plan"),
                 (("nothing", "--verify"), "holds no data set"),
                 (("plann.json", "-o", "x"), "did you mean 'plan.json'?"),
                 (("empty", "-o", "x"), "empty: the folder holds no data set")]
        os.mkdir(os.path.join(self.folder, "empty"))
        for arguments, message in cases:
            done = self.assert_ends(WRONG_INPUT, "dataset", *arguments)
            self.assertIn(message, done)
        self.write("rod.json", ROD + " ")
        done = self.assert_ends(WRONG_INPUT, "dataset", "plan.json", "-o", "rods")
        self.assertIn("the document 'rod' or a file that it names has changed", done)
        self.assertEqual(self.content("rods"), before)
        self.write("wrong.json", '{"meristem_dataset": 1, "documents": ["rod.json"],\n "files": [".gbl"]}')
        done = self.assert_ends(WRONG_INPUT, "dataset", "wrong.json", "-o", "x")
        self.assertIn("wrong.json:2:12: files[0]: '.gbl' is not a format", done)
        self.assertIn("did you mean '.glb'?", done)

    def test_render_writes_the_truth_behind_a_picture(self):
        self.assert_ends(DONE, "render", "rod.json", "-o", "a.png", "--size", "60x40", "--samples", "1", "--depth",
                         "a.depth.png", "--normals", "a.pfm", "--organs", "organs.png", "--shoots", "shoots.png",
                         "--plants", "plants.png", "--coco", "a.json", "-q")
        self.assertEqual(png_size_and_kind(self.read("a.depth.png")), (60, 40, 16, 0))
        self.assertTrue(self.read("a.pfm").startswith(b"PF\n60 40\n-1.0\n"))
        coco = json.loads(self.read("a.json"))
        self.assertEqual(coco["images"][0]["file_name"], "a.png")
        # Each annotation must agree with the mask of its level.
        levels = {category["id"]: category["supercategory"] for category in coco["categories"]}
        self.assertEqual(set(levels.values()), {"organ", "shoot", "plant"})
        masks = {}
        for level in ("organ", "shoot", "plant"):
            rows = rows_of_png(self.read(f"{level}s.png"))
            masks[level] = [[row[3 * x] + 256 * row[3 * x + 1] for x in range(60)] for row in rows]
        for annotation in coco["annotations"]:
            mask = masks[levels[annotation["category_id"]]]
            pixels = [(x, y) for y in range(40) for x in range(60) if mask[y][x] == annotation["number"]]
            self.assertEqual(len(pixels), annotation["area"])
            left, top = min(x for x, _ in pixels), min(y for _, y in pixels)
            self.assertEqual(annotation["bbox"][:2], [left, top])
        done = self.assert_ends(WRONG_INPUT, "render", "rod.json", "--depth", "a.jpg")
        self.assertIn("a file that ends in .png or .pfm", done)
        self.assert_ends(WRONG_INPUT, "render", "rod.json", "--depth", "a.png", "--cards", "2")
        for other in (["--show", "scale"], ["--show", "scale", "--no-plant"], ["--hull"], ["--lod", "1"]):
            done = self.assert_ends(WRONG_INPUT, "render", "rod.json", "-o", "b.png", "--depth", "c.png", *other)
            self.assertIn(f"expected no {other[0]}", done)
        for twice in (["-o", "b.png", "--organs", "./b.png"], ["--depth", "b.png", "--organs", "b.png"],
                      ["--depth", "b.png", "--organs", "c.png", "--shoots", f"{self.folder}/b.png"]):
            done = self.assert_ends(WRONG_INPUT, "render", "rod.json", *twice)
            self.assertIn("would be written twice", done)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "b.png")))
        self.assert_ends(DONE, "render", "rod.json", "--plants", "p.png", "--turntable", "2", "--size", "20x20", "-q")
        self.assertEqual(sorted(name for name in os.listdir(self.folder) if name.startswith("p_")),
                         ["p_000.png", "p_001.png"])


if __name__ == "__main__":
    unittest.main()
