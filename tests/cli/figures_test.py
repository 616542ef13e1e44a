#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares figures in the manual's sentences and tables with `meristem measure`. Shipped models must grow without
warnings.

Usage: figures_test.py PROGRAM ROOT [unittest options]

A test measures the document of a picture with the settings in docs/manual/figures/figures.txt. From the measures it
makes a sentence or a table cell, which the page must contain word by word. console_test.py runs the sessions of the
manual, and study_pages_test.py compares the tables of studies.
"""

import functools
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import unittest

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
FIGURES = ROOT / "docs" / "manual" / "figures"


@functools.cache
def pictures():
    """Returns the document and the settings of each picture."""
    planned = {}
    for line in (FIGURES / "figures.txt").read_text(encoding="utf-8").splitlines():
        if line.strip() and not line.startswith("#"):
            name, document, *options = line.split()
            # Options that only `render` has do not affect measures.
            settings = [(options[k], options[k + 1]) for k in range(len(options) - 1) if options[k] in ("--set", "--time", "--seed")]
            planned[name] = (FIGURES / f"{document}.json", [word for pair in settings for word in pair])
    return planned


@functools.cache
def measuring(document, *options):
    """Runs `meristem measure` once per document: a path, or the name of a shipped model."""
    return subprocess.run([PROGRAM, "measure", document, "--json", *options], check=True, capture_output=True, timeout=300,
                          encoding="utf-8")


def measured_document(document, *options):
    """Returns all measures of the plant of a document."""
    return json.loads(measuring(document, *options).stdout)


def measured(picture, *options):
    """Returns all measures of a picture's plant."""
    document, settings = pictures()[picture]
    return measured_document(str(document), *settings, *options)


def written_megabytes(model, *options):
    """Returns the size of a model's GLB file."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "plant.glb"
        subprocess.run([PROGRAM, "grow", model, "-o", str(path), "--quiet", *options], check=True, timeout=300)
        return path.stat().st_size / 1e6


def hundreds(count):
    return f"{round(count, -2):,}"


class Page(unittest.TestCase):
    PAGE = ""

    def setUp(self):
        self.text = re.sub(r"\s+", " ", (ROOT / "docs" / "manual" / self.PAGE).read_text(encoding="utf-8"))

    def says(self, *sentences):
        for sentence in sentences:
            with self.subTest(sentence=sentence):
                self.assertTrue(sentence in self.text, f"{self.PAGE} does not say: {sentence}")


class SpaceColonization(Page):
    PAGE = "space-colonization.md"

    def test_spread_and_number_of_points(self):
        even, outside = (measured(name)["length"] for name in ("points-uniform", "points-outside"))
        many, few = (measured(name)["tips"] for name in ("points-900", "points-300"))
        self.says(f"| 2,700 uniform points: {even:.0f} m of branches.",
                  f"| Nine tenths of the points in the outer 15 %: {outside:.0f} m of branches.",
                  f"as published; {outside:.0f} m of branches instead of {even:.0f} m |",
                  f"| 900 points: {many} tips.", f"| 300 points in the same crown: {few} tips.",
                  f"| {few} instead of {many} tips |")

    def test_finish(self):
        raw, decimated, smooth = (measured(f"skeleton-{name}")["nodes"] for name in ("raw", "decimated", "smooth"))
        removed = 100 * (1 - decimated / raw)
        self.says(f"| Raw: {raw:,} nodes.", f"| {decimated} of {raw:,} nodes remain; {removed:.1f} % are removed.",
                  f"| {smooth:,} nodes, nearly as many as in the raw skeleton.",
                  f"| {raw:,} to {decimated}, −{removed:.1f} % |", f"| {smooth:,} of {raw:,} |")
        angles = [f"{measured(f'skeleton-{name}')['branching_angle_mean']:.0f}°" for name in ("raw", "decimated", "relaxed")]
        self.says(f"from the direction of the parent: {', '.join(angles)}")

    def test_shed_branches(self):
        whole, forgotten = (1000 * measured("shed", *more)["stem_diameter"] for more in ((), ("--set", "tree.memory=0.5")))
        self.says(f"At breast height the stem is {whole:.1f} mm thick, as before; {forgotten:.1f} mm with `memory` 0.5")

    def test_heights(self):
        self.says(f"| {measured('bush')['height']:.1f} m and {measured('slender')['height']:.1f} m |")


class SelfOrganizing(Page):
    PAGE = "self-organizing.md"

    def test_apical_control(self):
        heights = [measured(f"organize-lambda-{number}")["height"] for number in (46, 50, 52, 54)]
        self.says("| `... --set tree.resource.lambda=0.46`: {:.1f} m | 0.5: {:.1f} m | 0.52, the default: {:.1f} m | "
                  "0.54: {:.1f} m |".format(*heights))

    def test_branching_angles(self):
        document = str(FIGURES / "organize.json")
        found = [measured_document(document, "--set", f"tree.branching_angle={angle}") for angle in (30, 45, 55, 65, 80)]
        means = " | ".join(f"{one['branching_angle_mean']:.0f}°" for one in found)
        ranges = " | ".join(f"{one['branching_angle_low']:.0f}° to {one['branching_angle_high']:.0f}°" for one in found)
        self.says(f"| mean of the measured angles | {means} |", f"| 5th to 95th percentile | {ranges} |")
        less, none = (measured_document(document, "--set", f"tree.direction.light={light}")["branching_angle_mean"]
                      for light in (0.2, 0))
        self.says(f"with 0.2 the mean at 55 is {less:.0f}°, and with 0 it is {none:.0f}°")

    def test_vigour(self):
        counts = [hundreds(measured(name)["metamers"]) for name in ("organize-alpha-19", "organize-lambda-52",
                                                                    "organize-alpha-23")]
        self.says("| `... --set tree.resource.alpha=1.9`: {} metamers | 2, the default: {} | 2.3: {} |".format(*counts))

    def test_shedding(self):
        full, open_inside, thin = (measured(name) for name in ("organize-lambda-52", "organize-shed", "organize-memory"))
        self.says(f"| 0: {hundreds(full['metamers'])} metamers, a stem of {100 * full['stem_diameter']:.0f} cm | "
                  f"`... --set tree.shedding.below=0.3`: {hundreds(open_inside['metamers'])}, and "
                  f"{100 * open_inside['stem_diameter']:.0f} cm | `... --set tree.memory=0`: "
                  f"{100 * thin['stem_diameter']:.0f} cm |")

    def test_thickness(self):
        slim = [measured(name)["slenderness"] for name in ("organize-pipe-2", "organize-lambda-52", "organize-pipe-3")]
        self.says("| `... --set tree.pipe_exponent=2`: height over thickness {:.0f} | 2.4, the default: {:.0f} | 3: "
                  "{:.0f} |".format(*slim))

    def test_cut(self):
        self.says(f"| Not cut: {measured('organize-cut-not')['height']:.1f} m | The leader cut in iteration 9, shown in "
                  f"iteration 12: {measured('organize-cut')['height']:.1f} m, and a wider crown |")
        self.assertGreater(measured("organize-cut")["crown_mean_width"], measured("organize-cut-not")["crown_mean_width"])

    def test_the_old_oak(self):
        oak = measured_document("old-oak")
        self.says(f"at each bud, {round(oak['leaf_count'], -4):,} leaves in all",
                  f"The old oak has {round(oak['metamers'], -4):,} metamers")

    def test_ages_of_the_lime(self):
        heights = [measured(f"organize-time-{age}")["height"] for age in range(6, 37, 6)]
        cells = [f"{age}: {height:.1f} m" if height < 9.95 else f"{age}: {height:.0f} m"
                 for age, height in zip(range(6, 37, 6), heights)]
        self.says("| " + " | ".join(cells) + " |")


class Light(Page):
    PAGE = "light.md"

    def test_means_of_limited_space(self):
        document = str(FIGURES / "light-tree.json")
        means = [statistics.fmean(measured_document(document, "--seed", str(seed), "--set", f"tree.light.limit.share={share}")
                                  ["lit_share"] for seed in range(10)) for share in (0, 0.36, 0.6)]
        self.says("(Means over the seeds 0 to 9: {:.2f}, {:.2f} and {:.2f}.)".format(*means))

    def test_heights_of_both_responses(self):
        moved, held = (measured(name)["height"] for name in ("scene-b-7", "drift-held"))
        self.says(f"![Response A: {moved:.1f} m high](figures/scene-b-7.jpg) ![Response B: {held:.1f} m high]")


class PlantsFromParts(Page):
    PAGE = "p-graph.md"

    def test_the_sunflower(self):
        flower = measured_document("sunflower")
        self.says(f"The sunflower has {round(flower['instances'], -3):,} instances and {round(flower['triangles'], -4):,} triangles")


class BushesAndTreesFromParts(Page):
    PAGE = "p-graph-trees.md"

    def test_parts_of_the_large_maple(self):
        maple = measured_document("large-maple")
        # A leaf is one organ, and this tree has no other organs.
        self.assertEqual(maple["instances"] - maple["leaf_count"], len(maple["order_histogram"]))
        self.says(f"{hundreds(sum(maple['order_histogram']))} stems have",
                  f"{round(maple['leaf_count'], -3):,} leaves have")
        wood = measured_document("large-maple", "--set", "leaf.hidden=true")["triangles"]
        self.says(f"stems have {wood / 1e6:.1f} million triangles", f"leaves have {(maple['triangles'] - wood) / 1e6:.1f} million")


class Leaves(Page):
    PAGE = "leaves.md"

    @staticmethod
    def triangles(**leaf):
        document = {"meristem": 1, "components": {"leaf": {"type": "leaf", **leaf}}}
        done = subprocess.run([PROGRAM, "measure", "-", "--json", "--quiet"], input=json.dumps(document), check=True,
                              stdout=subprocess.PIPE, timeout=60, encoding="utf-8")
        return json.loads(done.stdout)["triangles"]

    def test_leaves_of_few_triangles(self):
        kinds = ("kite", "broad", "oak", "lobed", "tuft", "frond")
        counts = []
        for kind in kinds:
            hidden = [f"{other}.hidden={'false' if other == kind else 'true'}" for other in (*kinds, "side")]
            counts.append(measured("low-leaves", *(word for setting in hidden for word in ("--set", setting)))["triangles"])
        self.says("{}, {}, {}, {}, {} and {} triangles, the frond also from the side".format(*counts))

    def test_pointed_leaves(self):
        counts = [self.triangles(rows=rows) for rows in (2, 3, 4)]
        self.says("has {} triangles with 2 `rows`, {} with 3, {} with 4".format(*counts))
        self.assertEqual(self.triangles(rows=2, petiole=0.02) - counts[0], 9)
        self.says("A `petiole` costs 9.")


class LowPoly(Page):
    PAGE = "low-poly.md"

    def test_thickened_twigs(self):
        measures = measured("twin-low")
        below, length, volume = (measures[f"thickened_{what}"] for what in ("below", "length", "volume"))
        self.says(f"thickened_below {below:.4g} m thickened_length {length:.4g} thickened_volume {volume:.4g}",
                  f"{100 * length:.0f} % of the branches' length had a radius below {100 * below:.1f} cm")
        self.assertEqual(round(1 + volume), 9)
        self.says("the wood has nine times its volume")


class Grass(Page):
    PAGE = "grass.md"

    def test_reduced_leaves_keep_their_area(self):
        leaves = measured("grass-reduce")
        self.assertEqual(leaves["leaf_count"], 5)
        self.assertEqual(leaves["triangles"], 6 + 14 + 30 + 62 + 190)
        self.says(f"each of these five leaves an area of {leaves['leaf_area'] / 5:.6f} m², with 6, 14, 30, 62 and 190 triangles")


class Maize(Page):
    PAGE = "maize.md"

    def test_one_plant(self):
        bare, whole = (measured_document("maize", *more) for more in (("--set", "husk.hidden=true"), ()))
        self.assertEqual(bare["leaf_count"], 10)
        self.says(f"ten green and dry leaves of {bare['leaf_area']:.2f} m²",
                  f"The whole plant has {round(whole['triangles'], -3):,} triangles")

    def test_field(self):
        field = measured_document("maize-field")
        self.says(f"counts {field['leaf_count']:,} leaves of {field['leaf_area']:.0f} m² over 120 m² of ground, a leaf area "
                  f"index of {field['leaf_area'] / 120:.1f}, and {field['triangles'] / 1e6:.2f} million triangles in "
                  f"{field['instances']:,} instances")

    def test_files(self):
        sizes = [written_megabytes(*arguments) for arguments in (("maize",), ("maize-field", "--instanced"), ("maize-field",))]
        self.says("takes {:.1f} MB as a GLB file".format(sizes[0]), f"writes {sizes[1]:.1f} MB; without `--instanced` the file "
                  f"has {sizes[2]:.0f} MB")


class Files(Page):
    PAGE = "files.md"

    def test_sizes_of_the_oaks_files(self):
        rows = re.findall(r"\| `(\.\S+)` \| [^|]+ \| [^|]+ \| [^|]+ \| ([^|]+) \|", self.text)
        endings = [ending for ending, size in rows if size.endswith(" MB")]
        self.assertEqual([row for row in rows if row[0] not in endings], [(".operations.csv", "its head alone")])
        with tempfile.TemporaryDirectory() as folder:
            outputs = [word for ending in endings for word in ("-o", f"{folder}/oak{ending}")]
            subprocess.run([PROGRAM, "grow", "oak", "--quiet", *outputs], check=True, timeout=300)
            for ending in endings:
                size = pathlib.Path(f"{folder}/oak{ending}").stat().st_size / 1e6
                [cell] = re.findall(rf"\| `{re.escape(ending)}` \| [^|]+ \| [^|]+ \| [^|]+ \| ([\d.]+) MB \|", self.text)
                self.assertEqual(cell, f"{size:.0f}" if size >= 1 else f"{size:.1f}", ending)
        self.says(f"The oak takes {written_megabytes('oak', '--instanced'):.0f} MB instead of {written_megabytes('oak'):.0f}.",
                  f"the shipped chestnut has {written_megabytes('chestnut', '--nodes'):.0f} MB instead of "
                  f"{written_megabytes('chestnut'):.0f}.")


class Gallery(Page):
    PAGE = "../gallery.md"

    def test_plants(self):
        """Compares triangles, height and leaf area of all plants, except the three scenes with more than a hundred
        million triangles, which are only grown. No plant may have a warning."""
        rows = re.findall(r"\| \[`([\w-]+)`\]\([^)]+\) \| [^|]+ \| ([\d,]+) \| [\d.]+ \| [\d.]+ \| ([\d.]+|-) \| ([\d.,]+|-) \|",
                          self.text)
        models = {path.stem for path in (ROOT / "models").glob("*.json")}
        self.assertEqual({row[0] for row in rows}, models)
        scenes = [row[0] for row in rows if int(row[1].replace(",", "")) > 10_000_000]
        self.assertLessEqual(len(scenes), 3)
        for scene in scenes:
            done = subprocess.run([PROGRAM, "check", scene], capture_output=True, timeout=300, encoding="utf-8")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotIn("warning", done.stderr, scene)
        for model, triangles, height, leaf_area in rows:
            if model in scenes:
                continue
            with self.subTest(model=model):
                self.assertNotIn("warning", measuring(model).stderr)
                measures = measured_document(model)
                self.assertEqual(triangles, f"{measures['triangles']:,}")
                self.assertEqual(height, f"{measures['height']:.2f}" if measures["height"] else "-")
                area = measures["leaf_area"]
                self.assertEqual(leaf_area, format(area, ".3g" if area < 100 else ",.0f") if area else "-")


class LowPolyTrees(Page):
    PAGE = "low-poly-trees.md"

    def test_triangles(self):
        for model in sorted((ROOT / "models").glob("low-poly-*.json")):
            triangles = measured_document(model.stem)["triangles"]
            [cell] = re.findall(rf"\(\.\./\.\./models/{model.name}\) \| ([\d,]+) \|", self.text)
            self.assertEqual(cell, f"{triangles:,}", model.name)


class ForGameMakers(Page):
    PAGE = "for-game-makers.md"

    def test_triangles_of_low_poly_trees(self):
        counts = [measured_document(model.stem)["triangles"] for model in sorted((ROOT / "models").glob("low-poly-*.json"))]
        self.assertEqual(len(counts), 8)
        self.says(f"Eight low-poly trees with flat shading are shipped, with {round(min(counts) / 50) * 50} to "
                  f"{round(max(counts) / 50) * 50:,} triangles each")


class Measures(Page):
    PAGE = "measures.md"

    def test_shadow_of_the_oaks_leaves(self):
        oak = measured_document("oak", "--light")
        self.says(f"{oak['leaf_area'] * oak['leaf_irradiance']:.1f} m² ({oak['leaf_area']:.1f} × {oak['leaf_irradiance']:.4f})",
                  f"The {oak['leaf_count']:,} leaves of the oak")


class ShippedTreesOfTheFitStudy(Page):
    """Compares shipped trees with measured trees, by measures of the program. Here the diameter is interpolated along
    the stem, in the study it is the diameter at a node, so it may differ by a few percent."""

    PAGE = "fit-study.md"

    def test_table(self):
        rows = re.findall(r"\| `([\w-]+)` \| [^|]+ \| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \| (\d+) \| ([\d.]+) \|", self.text)
        self.assertEqual(len(rows), 11)
        for model, height, diameter, crown, slenderness, spread in rows:
            with self.subTest(model=model):
                measures = measured_document(model)
                self.assertEqual(height, f"{measures['height']:.1f}")
                self.assertAlmostEqual(float(diameter) / 100, measures["stem_diameter"], delta=0.05 * measures["stem_diameter"])
                self.assertAlmostEqual(float(slenderness), measures["height"] / (float(diameter) / 100), delta=1.5)
                self.assertAlmostEqual(float(spread), float(crown) / measures["height"], delta=0.02)


if __name__ == "__main__":
    unittest.main()
