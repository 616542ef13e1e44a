#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The content of the files of one plant, read with Python's standard library.

Usage: formats_test.py PROGRAM REPOSITORY [unittest options]
"""

import csv
import io
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import unittest

import cli_case
from cli_case import DONE, FAILED, LONG_GROWTH, LONG_RENDER, MTG, TREE, WRONG_INPUT

REPOSITORY = pathlib.Path(sys.argv.pop(1))


def endings():
    """Returns the endings of all formats in the order of the program's table, which its help lists."""
    text = subprocess.run([cli_case.PROGRAM, "grow", "--help"], capture_output=True, check=True, timeout=300).stdout
    return re.findall(r"^  (\.\S+) ", text.decode(), re.MULTILINE)


class Formats(cli_case.Case):
    """All files of one plant must have equal content. They are read with Python's standard library."""

    FILES = ["a" + ending for ending in endings()]

    def setUp(self):
        super().setUp()
        outputs = [argument for name in self.FILES for argument in ("-o", name)]
        self.announcement = self.assert_ends(DONE, "grow", "tree.json", *outputs)

    def counted(self, what):
        return int(re.search(rf"(\d+) {what}", self.announcement)[1])

    def read_ply(self, name):
        """Returns the header's comments, and a list of rows (dictionaries) for each element."""
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

    def test_pages_name_the_endings_of_the_table(self):
        known = endings()
        self.assertIn(".glb", known)

        def page(name):
            return (REPOSITORY / name).read_text(encoding="utf-8")

        table = page("docs/manual/files.md").split("| ending |", 1)[1].split("\n\n", 1)[0]
        self.assertEqual(re.findall(r"^\| `(\.\S+)` \|", table, re.MULTILINE), known)
        sentence = page("docs/manual/command-line.md").split("The file's ending selects the format:", 1)[1].split("[Files]")[0]
        self.assertCountEqual(re.findall(r"`(\.\S+)`", sentence), known)
        row = page("docs/manual/many-plants.md").split("| `files` |", 1)[1].split("or [scans]")[0]
        self.assertEqual(re.findall(r"`(\.\S+)`", row), known)
        docstring = page("python/bindings/plant.cpp").split('.def("save", &save', 1)[1].split('R"(', 1)[1]
        self.assertEqual(re.findall(r"(\.[a-z.]*[a-z])(?=[,.])", docstring.split("selects the format:", 1)[1].split("\n\n")[0]),
                         known)


class Looks(cli_case.Case):
    """Textures and instances in the files that `grow` writes."""

    TEXTURED = TREE.replace('"type": "leaf"', '"type": "leaf", "texture": {"leaf": "pinnate", "pixels": 64}, "variety": 1')

    def setUp(self):
        super().setUp()
        self.write("textured.json", self.TEXTURED)

    def grown_json(self, *options):
        """Returns the size of a binary glTF and its JSON."""
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
        refused = "would be overwritten, and it is read"
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


if __name__ == "__main__":
    unittest.main()
