#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads MTG files that `grow` writes by the rules of the MTG user guide, with Python's standard library.

Usage: mtg_test.py PROGRAM [unittest options]
"""

import csv
import io
import json
import re
import struct
import unittest

import cli_case
from cli_case import DONE

CLASS_COLUMNS = ["SYMBOL", "SCALE", "DECOMPOSITION", "INDEXATION", "DEFINITION"]
STEP = re.compile(r"([/<+])([A-Za-z]+)(\d+)")


def single(value):
    """Returns the 32-bit number nearest to a text or a number."""
    return struct.unpack("<f", struct.pack("<f", float(value)))[0]


class Entity:
    def __init__(self, relation, name, number, scale, column):
        self.relation, self.name, self.number, self.scale, self.column = relation, name, number, scale, column
        self.whole = None  # the entity of the next coarser scale that contains it
        self.bearer = None  # of the same scale
        self.base = None  # the entity of any scale on which it was set
        self.has_parts = False
        self.values = {}

    def at_scale(self, scale):
        return self if self.scale <= scale else self.whole.at_scale(scale)


class Mtg:
    """Form A: sections with their heads, then entities. Their codes continue from the entity above in the same column
    (`^`) or in the previous column."""

    def __init__(self, text):
        lines = [line for line in text.split("\n") if not line.startswith("#")]
        assert lines[0] == "CODE:\tFORM-A" and lines[-1] == ""
        self.scales = {row[0]: int(row[1]) for row in self.section(lines, "CLASSES:", CLASS_COLUMNS)}
        self.rules = self.section(lines, "DESCRIPTION:", ["LEFT", "RIGHT", "RELTYPE", "MAX"])
        self.types = dict(self.section(lines, "FEATURES:", ["NAME", "TYPE"]))
        codes = lines[lines.index("MTG:") + 1:-1]
        head = codes[0].split("\t")
        assert head[0] == "ENTITY-CODE"
        self.columns = 1 + head[1:].count("")
        assert head[self.columns:] == list(self.types), "all features, in the order of their declaration"
        self.entities = []
        self.above = {}
        for line in codes[1:]:
            self.read_line(line)

    @staticmethod
    def section(lines, name, columns):
        begin = lines.index(name) + 1
        assert lines[begin].split("\t") == columns
        return [line.split("\t") for line in lines[begin + 1:lines.index("", begin)]]

    def read_line(self, line):
        cells = line.split("\t")
        column = next(k for k, cell in enumerate(cells) if cell)
        assert column < self.columns and not any(cells[column + 1:self.columns])
        code = cells[column]
        place = self.above[column] if code[0] == "^" else self.above.get(column - 1)
        steps = STEP.findall(code)
        assert code.lstrip("^") == "".join(map("".join, steps)), code
        for relation, name, number in steps:
            place = self.add(place, relation, name, int(number), column)
        self.above[column] = place
        # Entities in columns to the right belonged to an entity that is no longer the last one here.
        self.above = {k: entity for k, entity in self.above.items() if k <= column}
        for feature, cell in zip(self.types, cells[self.columns:]):
            if cell:
                assert not set(cell) & set("+<>/[](),=;"), cell
                place.values[feature] = cell if self.types[feature] == "ALPHA" else float(cell)

    def add(self, place, relation, name, number, column):
        made = Entity(relation, name, number, self.scales[name], column)
        if relation == "/":
            made.whole = place.at_scale(made.scale - 1) if place else None
            is_first = made.whole and not made.whole.has_parts
            if made.whole:
                made.whole.has_parts = True
            # The first part of an entity is joined to the base of that entity.
            if is_first and made.whole.base:
                made.base = made.whole.base
                made.bearer = made.base.at_scale(made.scale)
                made.relation = made.whole.relation
        else:
            made.base = place
            made.bearer = place.at_scale(made.scale)
            made.whole = made.bearer.whole
        self.entities.append(made)
        return made

    def of(self, *names):
        return [entity for entity in self.entities if entity.name in names]


class MtgFiles(cli_case.Case):
    def grow(self, *arguments):
        self.assert_ends(DONE, "grow", *arguments, "-o", "a.mtg", "-o", "a.csv")
        self.table = list(csv.DictReader(io.StringIO(self.read("a.csv").decode(), newline="")))
        return Mtg(self.read("a.mtg").decode())

    def check_relations(self, mtg):
        """Checks the entities against CLASSES and DESCRIPTION."""
        self.assertEqual(mtg.scales, {"$": 0, "P": 1, "A": 2, "B": 3, "S": 3})
        allowed = {(left, right, relation): most for left, right, relation, most in mtg.rules}
        borne = {}
        for entity in mtg.entities:
            if entity.whole:
                self.assertEqual(entity.whole.scale, entity.scale - 1)
            if entity.bearer:
                key = (entity.bearer.name, entity.name, entity.relation)
                self.assertIn(key, allowed)
                borne.setdefault((id(entity.bearer), entity.relation), []).append(entity)
        for (_, relation), entities in borne.items():
            self.assertTrue(relation == "+" or len(entities) == 1, "one successor at most")

    def check_nodes(self, mtg):
        """Checks that roots and segments are the nodes of the table, and that axes agree."""
        nodes = mtg.of("B", "S")
        self.assertEqual(sorted(int(entity.values["node"]) for entity in nodes), list(range(len(self.table))))
        for entity in nodes:
            row = self.table[int(entity.values["node"])]
            parent = str(int(entity.bearer.values["node"])) if entity.bearer else ""
            self.assertEqual(parent, row["parent"])
            for feature, column, factor in (("XX", "x", 1), ("YY", "z", -1), ("ZZ", "y", 1), ("TopDia", "radius", 2),
                                            ("birth", "birth", 1)):
                self.assertEqual(single(entity.values[feature]), factor * single(row[column]), feature)
            self.assertEqual(entity.column, int(row["order"]), "branches of order k stand in column k")
            axis = entity.whole
            self.assertEqual((axis.name, axis.number), ("A", int(row["axis"])))
            self.assertEqual((axis.values["component"], int(axis.values["instance"])),
                             (row["component"], int(row["instance"])))
            previous = entity.bearer if entity.bearer and entity.bearer.whole is axis else None
            counted = previous.number + 1 if previous else int(entity.name == "S")
            self.assertEqual(entity.number, int(row.get("metamer", counted)))
            self.assertEqual(axis.values.get("label"), row.get("label"))
            for feature in mtg.types.keys() & row.keys() - {"node", "birth", "component", "instance", "label"}:
                self.assertEqual(entity.values.get(feature), float(row[feature]) if row[feature] else None)
        roots = [row for row in self.table if not row["parent"]]
        self.assertEqual([entity.number for entity in mtg.of("P")], list(range(1, 1 + len(roots))))
        self.assertEqual(len(mtg.of("B")), len(roots))
        self.assertEqual(len(mtg.of("A")), len({row["axis"] for row in self.table}))

    def test_say_of_a_plant_what_its_table_says(self):
        for document in ("tree.json", "mint", "birch", "fern"):
            with self.subTest(document):
                mtg = self.grow(document)
                self.check_relations(mtg)
                self.check_nodes(mtg)

    def test_have_the_labels_of_shoots(self):
        self.write("shoots.json", """{"meristem": 1, "components": {"tree": {
            "type": "organize", "iterations": 8, "length": 0.1, "roots": [[0, 0, 0], [2, 0, 0]]}}}""")
        mtg = self.grow("shoots.json")
        self.check_relations(mtg)
        self.check_nodes(mtg)
        for entity in mtg.of("S"):
            if entity.relation == "+":
                bearer = entity.bearer
                self.assertEqual(entity.whole.values["label"], f"{bearer.whole.values['label']}.{bearer.number}")
        self.assertEqual([axis.values["label"] for axis in mtg.of("A") if not axis.base], ["main", "main"])
        self.assertTrue(any(axis.values["label"].count(".") > 1 for axis in mtg.of("A")))

    def test_hold_several_trees(self):
        self.write("two.json", cli_case.TREE.replace('"leaf": {', '"shrub": {"type": "colonize", "crown": {"profile": '
                   '[[0.2, 0.3], [0.5, 0.5], [0.2, 1]]}, "points": 100, "step": 0.05, "influence": 0.5, "kill": 0.15, '
                   '"frame": {"translate": [2, 0, 0]}},\n    "leaf": {'))
        mtg = self.grow("two.json")
        self.assertEqual(len(mtg.of("P")), 2)
        self.assertEqual({entity.values["component"] for entity in mtg.of("A")}, {"tree", "shrub"})
        self.check_relations(mtg)
        self.check_nodes(mtg)

    def test_are_measured_as_the_plant_is(self):
        self.assert_ends(DONE, "grow", "tree.json", "-o", "a.mtg")
        self.assert_ends(DONE, "measure", "tree.json", "--json", "-o", "plant.json")
        self.assert_ends(DONE, "measure", "a.mtg", "--json", "-o", "file.json")
        plant, file = (json.loads(self.read(name)) for name in ("plant.json", "file.json"))
        wood = [name for name in plant if file[name] is not None and not name.startswith("leaf") and name != "organs"]
        self.assertGreater(len(wood), 30)
        for name in wood:
            self.assertEqual(file[name], plant[name], name)


if __name__ == "__main__":
    unittest.main()
