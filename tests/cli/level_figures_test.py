#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares slow figures of the manual's page on files: levels of detail.

Usage: level_figures_test.py PROGRAM ROOT [unittest options]
"""

import pathlib
import re
import subprocess
import tempfile
import unittest

from figures_test import PROGRAM, ROOT, Page


class Levels(Page):
    PAGE = "files.md"

    def test_levels_of_low_poly_models(self):
        levels = {}
        for model in sorted((ROOT / "models").glob("low-poly-*.json")):
            with tempfile.TemporaryDirectory() as folder:
                subprocess.run([PROGRAM, "grow", str(model), "--quiet", "--lod", "8", "-o", f"{folder}/plant.ply"], check=True,
                               timeout=300)
                levels[model.stem] = len(list(pathlib.Path(folder).iterdir())) - 1
        self.assertEqual(levels.pop("low-poly-palm"), 0)
        self.assertEqual(len(levels), 7)
        self.assertEqual({model for model, count in levels.items() if count == 2}, {"low-poly-oak", "low-poly-shrub"})
        self.assertEqual(set(levels.values()), {1, 2})
        self.says("Seven of the low-poly models have a level 1, and the oak and the shrub have a level 2,", "The palm has no level")

    def test_triangles_of_levels(self):
        for model, row in (("oak", "oak, triangles"), ("apple", "apple"), ("spruce", "spruce")):
            with tempfile.TemporaryDirectory() as folder:
                done = subprocess.run([PROGRAM, "grow", model, "--lod", "3", "-o", f"{folder}/plant.ply"], check=True,
                                      stderr=subprocess.PIPE, timeout=300, encoding="utf-8")
            counts = re.findall(r"(\d+) triangles", done.stderr)
            self.assertEqual(len(counts), 4)
            self.says(f"| {row} | " + " | ".join(f"{int(count):,}" for count in counts) + " |")


if __name__ == "__main__":
    unittest.main()
