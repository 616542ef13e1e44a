#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Scans and tables of cylinders from the user's view. Usage: scan_test.py PROGRAM [unittest options]"""

import csv
import json
import math
import os
import struct
import unittest

import cli_case
from cli_case import DONE, WRONG_INPUT

COARSE = ("--set", "instrument.step=0.5", "-q")
EXTRA_BYTES = {1: "B", 2: "b", 3: "H", 4: "h", 5: "I", 6: "i", 7: "Q", 8: "q", 9: "f", 10: "d"}


def read_las(path):
    """Returns the points of a LAS 1.4 file of format 6 with its extra bytes, by the tables of the specification."""
    with open(path, "rb") as file:
        data = file.read()
    assert data[:4] == b"LASF" and data[24:26] == b"\1\4"
    header_size, first, records = struct.unpack_from("<HII", data, 94)
    point_format, length = struct.unpack_from("<BH", data, 104)
    assert (header_size, point_format) == (375, 6)
    scale = struct.unpack_from("<3d", data, 131)
    offset = struct.unpack_from("<3d", data, 155)
    count, = struct.unpack_from("<Q", data, 247)
    names, layout = [], "<iiiHBBBBhHd"
    at = header_size
    for _ in range(records):
        user, number, size = struct.unpack_from("<2x16sHH", data, at)
        if user.rstrip(b"\0") == b"LASF_Spec" and number == 4:
            for k in range(at + 54, at + 54 + size, 192):
                layout += EXTRA_BYTES[data[k + 2]]
                names.append(data[k + 4:k + 36].rstrip(b"\0").decode())
        at += 54 + size
    assert at == first and struct.calcsize(layout) == length
    points = []
    for k in range(count):
        x, y, z, intensity, returns, _, kind, _, _, station, time, *extra = struct.unpack_from(layout, data, first + k * length)
        place = [scale[a] * value + offset[a] for a, value in enumerate((x, y, z))]
        points.append({"x": place[0], "y": place[1], "z": place[2], "intensity": intensity, "return": returns & 15,
                       "returns": returns >> 4, "class": kind, "station": station, "time": time, **dict(zip(names, extra))})
    return points


class Scans(cli_case.Case):
    def scan(self, *arguments, document="tree.json"):
        done = self.run_program("scan", document, *arguments)
        self.assertEqual(done.returncode, DONE, done.stderr.decode())
        return done

    def rows(self, path="a.csv"):
        with open(os.path.join(self.folder, path), newline="") as file:
            return list(csv.DictReader(file))

    def fault(self, *arguments):
        done = self.run_program("scan", "tree.json", *arguments)
        self.assertEqual(done.returncode, WRONG_INPUT, done.stderr.decode())
        return done.stderr.decode()

    def test_every_format_has_the_same_points(self):
        self.scan("-o", "a.csv", "-o", "a.las", "-o", "a.ply", "--ground", "--set", "instrument.farthest=8", *COARSE)
        rows = self.rows()
        points = read_las(os.path.join(self.folder, "a.las"))
        self.assertEqual(len(points), len(rows))
        self.assertGreater(len(rows), 500)
        for row, point in zip(rows, points):
            self.assertAlmostEqual(float(row["x"]), point["x"], delta=1e-4)
            self.assertAlmostEqual(float(row["y"]), point["z"], delta=1e-4)
            self.assertAlmostEqual(float(row["z"]), -point["y"], delta=1e-4)
            self.assertAlmostEqual(float(row["true_range"]), point["true_range"], places=4)
            self.assertEqual((int(row["return"]), int(row["returns"])), (point["return"], point["returns"]))
            self.assertEqual(int(row["shoot"] or 0xffffffff), point["shoot"])
            self.assertEqual(2 if row["kind"] == "ground" else 5, point["class"])
        with open(os.path.join(self.folder, "a.ply"), "rb") as file:
            head = file.read(4000)
        self.assertIn(b"\nelement vertex %d\n" % len(rows), head)
        self.assertEqual({row["component"] for row in rows}, {"tree", "leaf", "ground"})
        self.assertEqual({row["kind"] for row in rows}, {"wood", "organ", "ground"})

    def test_distances_are_those_from_the_station(self):
        self.scan("-o", "a.csv", "--station", "0,1,5", "--set", "instrument.noise=0", *COARSE)
        for row in self.rows():
            x, y, z = (float(row[name]) for name in "xyz")
            self.assertAlmostEqual(math.dist((x, y, z), (0, 1, 5)), float(row["range"]), places=4)

    def test_instruments_come_by_name_json_and_file(self):
        self.write("camera.json", '{"kind": "depth_camera", "columns": 40, // few\n "rows": 30}')
        messages = []
        for instrument in ('{"kind": "depth_camera", "columns": 40, "rows": 30}', "camera.json"):
            done = self.scan("-o", "a.csv", "--instrument", instrument, "--around", "2")
            messages.append(done.stderr.decode().strip().splitlines()[-1])
        self.assertEqual(messages[0], messages[1])
        self.assertIn("of 2400 pulses from 2 stations", messages[0])
        done = self.scan("-o", "a.csv", "--instrument", "drone", "--set", "instrument.altitude=20",
                         "--set", "instrument.advance=0.5", "--set", "tree.step=0.1")
        self.assertIn("lines", done.stderr.decode())

    def test_faults_name_their_place(self):
        self.assertIn("did you mean 'drone'", self.fault("-o", "a.csv", "--instrument", "drohne"))
        self.assertIn("instrument.stepp", self.fault("-o", "a.csv", "--set", "instrument.stepp=1"))
        self.write("bad.json", '{"kind": "phase",\n  "noise": -1}')
        self.assertIn("bad.json:2:12: instrument.noise", self.fault("-o", "a.csv", "--instrument", "bad.json"))
        self.assertIn(".las", self.fault("-o", "a.laz"))
        self.assertIn("stations[0]", self.fault("-o", "a.csv", "--station", "1,2"))
        self.assertIn("altitude", self.fault("-o", "a.csv", "--instrument", "drone", "--set", "instrument.altitude=1"))

    def test_threads_change_no_byte(self):
        files = []
        for threads in ("1", "3"):
            self.scan("-o", "a.las", "--threads", threads, *COARSE)
            with open(os.path.join(self.folder, "a.las"), "rb") as file:
                files.append(file.read())
        self.assertEqual(files[0], files[1])


class Cylinders(cli_case.Case):
    def measures(self, path):
        done = self.run_program("measure", path, "--json", "-q")
        self.assertEqual(done.returncode, DONE, done.stderr.decode())
        return json.loads(done.stdout)

    def test_tables_are_measured_as_the_plant(self):
        done = self.run_program("grow", "tree.json", "-o", "a.qsm.csv", "-o", "a.trees.txt", "-o", "a.csv", "-q")
        self.assertEqual(done.returncode, DONE, done.stderr.decode())
        plant = self.measures("tree.json")
        for path in ("a.qsm.csv", "a.trees.txt", "a.csv"):
            table = self.measures(path)
            for name in ("trees", "nodes", "tips", "axes", "order_histogram", "strahler_streams"):
                self.assertEqual(table[name], plant[name], (path, name))
            for name in ("height", "length", "crown_width"):
                self.assertAlmostEqual(table[name] / plant[name], 1, places=4, msg=(path, name))

    def test_labelled_meshes_have_a_label_per_face(self):
        done = self.run_program("grow", "tree.json", "-o", "a.labels.ply", "-q")
        self.assertEqual(done.returncode, DONE, done.stderr.decode())
        with open(os.path.join(self.folder, "a.labels.ply"), "rb") as file:
            head, body = file.read().split(b"end_header\n", 1)
        lines = head.decode().splitlines()
        counts = {line.split()[1]: int(line.split()[2]) for line in lines if line.startswith("element ")}
        floats = sum(line.startswith("property float") for line in lines)
        at = counts["vertex"] * (4 * floats + 3 + 4)
        kinds = set()
        for k in range(counts["face"]):
            corners, *_ = struct.unpack_from("<B", body, at)
            kind, order, tree, component, instance, shoot = struct.unpack_from("<BHiiii", body, at + 13)
            self.assertEqual(corners, 3)
            self.assertEqual(tree, 0)
            self.assertLess(shoot, counts["shoot"])
            kinds.add((kind, component))
            at += 32
        self.assertEqual(kinds, {(1, 0), (2, 1)})
        labels = []
        for _ in range(counts["shoot"]):
            labels.append(body[at + 1:at + 1 + body[at]].decode())
            at += 1 + body[at]
        self.assertEqual((at, labels[0]), (len(body), "main"))

    def test_options_for_other_files_are_mistakes(self):
        self.run_program("grow", "tree.json", "-o", "a.qsm.csv", "-q")
        for options in (("--set", "points=3"), ("--diameter", "d"), ("--light",)):
            done = self.run_program("measure", "a.qsm.csv", *options)
            self.assertEqual(done.returncode, WRONG_INPUT)
            self.assertIn(f"{options[0]} has no effect", done.stderr.decode())


if __name__ == "__main__":
    unittest.main()
