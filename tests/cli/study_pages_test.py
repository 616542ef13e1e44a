#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares figures in the pages of studies with the tables of the studies. Usage: study_pages_test.py ROOT [unittest
options]

The studies take minutes, so their tables are committed beside their pictures, in docs/manual/figures/NAME-study. The
command at the top of each page writes them again. The tests make sentences and rows from the tables, which the page
must contain word by word.
"""

import csv
import functools
import pathlib
import re
import statistics
import sys
import unittest

MANUAL = pathlib.Path(sys.argv.pop(1)).resolve() / "docs" / "manual"


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


@functools.cache
def table(path):
    with open(MANUAL / "figures" / path, newline="", encoding="utf-8") as file:
        return [{name: number(value) for name, value in row.items()} for row in csv.DictReader(file)]


def signed(value, digits):
    """Formats a number like pages do: +1.2 or −1.2."""
    return f"{value:+.{digits}f}".replace("-", "−")


class Page(unittest.TestCase):
    PAGE = ""

    def setUp(self):
        text = (MANUAL / self.PAGE).read_text(encoding="utf-8") if self.PAGE else ""
        self.text = re.sub(r"\s+", " ", text)

    def says(self, *sentences):
        for sentence in sentences:
            self.assertIn(sentence, self.text)


class LightStudy(Page):
    PAGE = "light-study.md"

    @staticmethod
    def mean(response, scene, strength):
        [row] = [row for row in table("light-study/means.csv")
                 if (row["response"], row["scene"], row["strength"]) == (response, scene, strength)]
        return row

    def gain(self, response, scene, strength, share="lit_share_day"):
        """Returns percentage points relative to trees without a response."""
        return 100 * (self.mean(response, scene, strength)[share] - self.mean(response, scene, 0)[share])

    def test_runs(self):
        """Checks the number of trees, and that means agree with the table of trees."""
        trees = table("light-study/trees.csv")
        # Trees in scaled clouds grow twice: the height of the first one determines the scale of the second.
        self.says(f"The study grows {len(trees) + sum(tree['response'] == 'shift_scaled' for tree in trees):,} trees")
        for row in table("light-study/means.csv"):
            trees = [tree for tree in table("light-study/trees.csv")
                     if all(tree[name] == row[name] for name in ("response", "scene", "strength"))]
            self.assertEqual(len(trees), row["trees"])
            self.assertAlmostEqual(statistics.fmean(tree["height"] for tree in trees), row["height"], places=4)

    def test_lean(self):
        def a(strength):
            return self.mean("shift", "A", strength)

        def b(strength):
            return self.mean("shift", "B", strength)

        strong = [a(k / 1000) for k in range(5, 11)]
        azimuths = [row["inclination_azimuth"] for row in strong]
        self.says(
            f"| A: azimuth at `shift_m` 0 | scattered | spread {a(0)['inclination_azimuth_spread']:.0f}° |",
            f"| {min(azimuths):.1f}° to {max(azimuths):.1f}°, spread at most "
            f"{max(row['inclination_azimuth_spread'] for row in strong):.1f}° |",
            f"| from {a(0)['inclination_altitude']:.1f}° to {a(0.01)['inclination_altitude']:.1f}°; a line explains",
            f"| {b(0.003)['inclination_altitude']:.1f}° at 0.003, {b(0.004)['inclination_altitude']:.1f}° at 0.004 |",
            f"| spread {b(0.007)['inclination_azimuth_spread']:.0f}°; {b(0.008)['inclination_azimuth_spread']:.0f}° at 0.008 |",
            f"| {b(0.007)['inclination_altitude']:.1f}° at 0.007 |",
            "| " + ", ".join(f"{b(k)['inclination_azimuth']:.0f}°" for k in (0.008, 0.009, 0.01)) + " |",
            f"| by {(b(0.007)['inclination_altitude'] - b(0.01)['inclination_altitude']) / 3:.1f}° per 0.001; from 0 to 0.004 "
            f"by {(b(0)['inclination_altitude'] - b(0.004)['inclination_altitude']) / 4:.1f}° per 0.001 |")
        off_north = [abs((b(k / 1000)["inclination_azimuth"] + 180) % 360 - 180) for k in range(2, 7)]
        self.says("| from 0.002 to 0.006 within 8° of 0° |")
        self.assertTrue(7 < max(off_north) <= 8)
        [line] = [row for row in table("light-study/expectations.csv") if "R² of a line" in row["what"]]
        self.says(f"a line explains {100 * line['found']:.1f} %")

    def test_centroid(self):
        a = [self.mean("shift", "A", k / 1000) for k in range(11)]
        b = [self.mean("shift", "B", k / 1000) for k in range(11)]
        azimuths = [row["centroid_azimuth"] for row in a[1:]]
        self.says(f"| {a[0]['centroid_radius']:.2f} m, any direction |",
                  f"| {min(azimuths):.0f}° to {max(azimuths):.0f}° |",
                  f"| to {a[10]['centroid_radius']:.2f} m at 0.010 |",
                  f"| {b[7]['centroid_radius']:.2f} m at 0.007, {b[10]['centroid_radius']:.2f} m at 0.010 |",
                  "| within 8° of north |")
        self.assertLessEqual(max(abs((row["centroid_azimuth"] + 180) % 360 - 180) for row in b[1:]), 8)

    def test_light(self):
        def share(name, response, scene, strength):
            return f"{100 * self.mean(response, scene, strength)['lit_share_' + name]:.1f} %"

        still = self.gain("shift", "A", 0.01, "lit_share_still")
        gains = [self.gain("shift", "A", k / 1000) for k in range(1, 11)]
        self.says(
            f"| {signed(still, 1)} points, from {share('still', 'shift', 'A', 0)} to {share('still', 'shift', 'A', 0.01)} |",
            f"| {signed(gains[-1], 1)} points; between {signed(min(gains), 1)} and {signed(max(gains), 1)} at all strengths |",
            f"| {signed(self.gain('shift', 'B', 0.01), 1)} points, from {share('day', 'shift', 'B', 0)} to "
            f"{share('day', 'shift', 'B', 0.01)} |",
            f"| {signed(self.gain('shift_scaled', 'B', 0.005), 1)} points at 0.005, "
            f"{signed(self.gain('shift_scaled', 'B', 0.01), 1)} at 0.010 |",
            f"{self.mean('shift', 'A', 0.01)['height']:.1f} m (scene A) or {self.mean('shift', 'B', 0.01)['height']:.1f} m "
            "(scene B) at 0.010")

    def test_a_day_in_the_open(self):
        rows = {(row["response"], row["strength"], row["hour"]): row for row in table("light-study/hours.csv")}
        day = [100 * rows["limit", share, -1]["lit_share"] for share in (0, 0.36, 0.6)]
        self.says(f"a lit share of {day[0]:.1f}, {day[1]:.1f} and {day[2]:.1f} % over this day")
        for hour in range(5, 13):
            none, some, most = (100 * rows["limit", share, hour]["lit_share"] for share in (0, 0.36, 0.6))
            self.says(f"| {hour} | {rows['limit', 0, hour]['altitude']:.1f}° | {none:.1f} % | {some:.1f} % | {most:.1f} % | "
                      f"{signed(most - none, 1)} |")

        def change(weight):
            weights = {hour: weight(rows["shift", 0, hour]["altitude"]) for hour in range(5, 20)}
            return sum(100 * weight / sum(weights.values()) *
                       (rows["shift", 0.01, hour]["lit_share"] - rows["shift", 0, hour]["lit_share"])
                       for hour, weight in weights.items())

        trees = {(tree["strength"], tree["seed"]): 100 * tree["lit_share_day"] for tree in table("light-study/trees.csv")
                 if (tree["response"], tree["scene"]) == ("shift", "A")}
        spread = statistics.stdev(trees[0.01, seed] - trees[0, seed] for seed in range(10))
        self.says(f"the share changes by {signed(change(lambda altitude: 1), 1)} points",
                  f"weighted by the sun's altitude, by {signed(change(lambda altitude: altitude), 1)}.",
                  f"varies by {spread:.1f} points from cloud to cloud",
                  f"a mean of ten is certain to {spread / 10 ** 0.5:.1f} points")

    def test_what_response_b_gains(self):
        rows = {"A": [("A, `shift_m` 0.010", "shift", 0.01), ("A, `shift_m` 0.010, cloud scaled", "shift_scaled", 0.01),
                      ("B, `limit.share` 0.36", "limit", 0.36), ("B, `limit.share` 0.6", "limit", 0.6)],
                "B": [("A, `shift_m` 0.010", "shift", 0.01), ("A, `shift_m` 0.005, cloud scaled", "shift_scaled", 0.005),
                      ("A, `shift_m` 0.010, `hold_height`", "shift_held", 0.01),
                      ("B, `drift` 0.9, `hold_height`", "drift", 0.9), ("B, `drift` 1, `hold_height`", "drift", 1)]}
        for scene, share in (("A", "lit_share_still"), ("B", "lit_share_day")):
            plain = self.mean("shift", scene, 0)
            self.says(f"| no response | {plain['height']:.2f} m | {100 * plain[share]:.1f} % | |")
            for words, response, strength in rows[scene]:
                row = self.mean(response, scene, strength)
                gain = signed(self.gain(response, scene, strength, share), 1)
                gain = f"**{gain}**" if words.startswith("B") else gain
                self.says(f"| {words} | {row['height']:.2f} m | {100 * row[share]:.1f} % | {gain} |")

    def test_further_results(self):
        plain, limited = self.mean("limit", "A", 0), self.mean("limit", "A", 0.6)
        self.says(
            f"({signed(self.gain('limit', 'B', 0.6), 1)} points at 0.6)",
            f"({signed(self.gain('drift', 'A', 0.9, 'lit_share_still'), 1)} at 0.9)",
            f"from {plain['crown_hull_area']:.1f} to {limited['crown_hull_area']:.1f} m² at 0.6",
            f"stays {plain['crown_hull_area'] * plain['lit_share_still']:.1f} m², with {limited['length']:.0f} m of branches "
            f"instead of {plain['length']:.0f} m",
            f"falls from {100 * plain['lit_share_day']:.1f} to {100 * limited['lit_share_day']:.1f} % at 0.6",
            f"sunward by {limited['centroid_radius']:.2f} m at 0.6",
            f"lean clearly: {self.mean('drift', 'B', 0.9)['inclination_altitude']:.0f}° at 0.9")
        self.assertAlmostEqual(limited["crown_hull_area"] * limited["lit_share_still"],
                               plain["crown_hull_area"] * plain["lit_share_still"], delta=0.05)
        drift, none = self.mean("drift", "B", 0.9), self.mean("drift", "B", 0)
        self.says(f"lights {drift['crown_hull_area'] * drift['lit_share_day']:.1f} instead of "
                  f"{none['crown_hull_area'] * none['lit_share_day']:.1f} m² over the day")


class GrowthInTheLight(Page):
    PAGE = "light.md"

    def test_nodes_of_the_evaluation_tree(self):
        self.says(f"(900 points, {round(LightStudy.mean('shift', 'A', 0)['nodes'], -2):,.0f} nodes)")


class CutStudy(Page):
    PAGE = "cut-study.md"

    @staticmethod
    def row(name, key, value):
        [row] = [row for row in table(f"cut-study/{name}.csv") if row[key] == value]
        return row

    def test_table(self):
        row = self.row("readings", "reading", "as in the text")
        trees = table("cut-study/cuts.csv")
        self.says(f"| {row['total']:.2f} → {row['total_cut']:.2f} (−{100 * row['fall']:.1f} %) |",
                  f"| {row['leader']:.2f} ({100 * row['leader_share']:.1f} %) |",
                  f"| in {100 * row['alike']:.0f} of {len(trees)} trees |",
                  f"| in {100 * row['all_rise']:.0f} of {len(trees)} trees |")
        for k in range(1, 6):
            before, after = row[f"lateral_{k}"], row[f"lateral_{k}_cut"]
            self.says(f"| {before:.2f} → {after:.2f} ({signed(100 * (after / before - 1), 0)} %)")

    def test_table_follows_from_the_trees(self):
        row = self.row("readings", "reading", "as in the text")
        trees = table("cut-study/cuts.csv")
        for column in ("total", "total_cut", "leader", "lateral_3", "lateral_5_cut"):
            values = [tree[column] for tree in trees if tree[column] != ""]
            self.assertAlmostEqual(statistics.fmean(values), row[column], places=4)
        self.says(f"goes from {min(tree['total'] for tree in trees):.0f} to {max(tree['total'] for tree in trees):.0f}, and is "
                  f"above the published total in {sum(tree['total'] > 41.62 for tree in trees)} of 100 trees",
                  f"No lateral 3 of our trees has more than {max(tree['lateral_3'] for tree in trees):.1f}",
                  f"It opens in {sum(tree['lateral_2_cut'] >= 1.8 for tree in trees)} of 100 trees")
        falls = [1 - tree["total_cut"] / tree["total"] for tree in trees]
        self.says(f"by 8 to 25 % in {sum(0.08 <= fall <= 0.25 for fall in falls)} of 100 trees")
        buds = [tree for tree in trees if tree["lateral_4"] != "" and f"{tree['branches']:05.0f}"[3] == "0"]
        self.says(f"in the {len(buds)} trees where lateral 4 is a bud, "
                  f"{statistics.fmean(tree['lateral_4'] for tree in buds):.2f} → "
                  f"{statistics.fmean(tree['lateral_4_cut'] for tree in buds):.2f}")
        # Branches and buds below the cut are arranged like in the published tree.
        alike = [tree for tree in trees if f"{tree['branches']:05.0f}" == "10101"]
        gains = [100 * (statistics.fmean(tree[f"lateral_{k}_cut"] for tree in alike) /
                        statistics.fmean(tree[f"lateral_{k}"] for tree in alike) - 1) for k in range(1, 6)]
        self.says(f"The {len(alike)} trees that branch as the published tree does",
                  f"the gains are {gains[0]:.0f}, {gains[2]:.0f} and {gains[4]:.0f} %, from bud to bud {gains[1]:.0f} and "
                  f"{gains[3]:.0f} %")

    def test_trials_for_laterals_3_and_5(self):
        rows = {row["settings"]: row for row in table("cut-study/trials.csv")}
        self.assertEqual(len(rows), 8)
        for row in rows.values():
            numbers = " | ".join(f"{row[name]:.2f}" for name in ("total", "lateral_1", "lateral_3", "lateral_5"))
            self.says(f"| {row['trees']:.0f} | {numbers} | {row['largest_3']:.1f} |")
        less = rows["less shade: a 0.1"]
        self.assertAlmostEqual(less["lateral_5"], 7.94, delta=0.1)
        self.assertAlmostEqual(less["lateral_3"] / 8.234, 2 / 3, delta=0.05)
        largest = rows["more for the terminal side: lambda 0.53"]["largest_3"]
        self.says(f"the largest lateral 3 has {largest:.1f}")
        self.assertLess(max(row["lateral_3"] for row in rows.values() if row["total"] < 45), 8.2)

    def test_readings(self):
        for words, reading in (("**the reading of this page**", "as in the text"),
                               ("only branches are counted, no buds", "five branches"),
                               ("cut above a branch that is an iteration older", "lateral an iteration older"),
                               ("read before the growth of iteration 9", "read before growth 9"),
                               ("cut after iteration 9", "cut at 9"),
                               ("cut after iteration 9, above a branch that is an iteration older",
                                "cut at 9, lateral an iteration older")):
            row = self.row("readings", "reading", reading)
            self.says(f"| {words} | {row['total']:.2f} → {row['total_cut']:.2f} | {100 * row['fall']:.1f} % | "
                      f"{100 * row['leader_share']:.1f} % | {100 * row['all_rise']:.0f} % |")

    def test_adaptations(self):
        def adaptation(name):
            return self.row("adaptations", "adaptation", name)

        regrown, bush = adaptation("cut buds grow again"), adaptation("laterals open as terminals")
        whole = adaptation("all on")
        self.says(
            f"Only {100 * adaptation('nothing passed back')['grows_on']:.0f} % of the shoots",
            f"straight on ({regrown['turn']:.0f}°). The total falls by {100 * regrown['fall']:.0f} %",
            f"A bush: {bush['uncut_metamers']:.0f} metamers after 14 iterations instead of {whole['uncut_metamers']:.0f}. The "
            f"cut removes {100 * bush['leader_share']:.0f} % of the bush",
            f"stands aside by {adaptation('no turn to the leader')['turn']:.0f}° instead of {whole['turn']:.0f}°")

    def test_growth_and_apical_control(self):
        def metamers(kind, iteration):
            [row] = [row for row in table("cut-study/growth.csv") if (row["set"], row["iteration"]) == (kind, iteration)]
            return row["metamers"]

        slim, full = ([metamers(kind, k) for k in (9, 18, 25)] for kind in ("slim", "full"))
        self.says(f"The study finds {slim[0]:,.0f}, {slim[1]:,.0f} and {slim[2] + 1e-9:,.0f} metamers (slim), and "
                  f"{full[0]:,.0f}, {full[1]:,.0f} and {full[2]:,.0f} (full)")
        for kind in ("slim", "full"):
            rows = [row for row in table("cut-study/lambda.csv") if row["set"] == kind]
            heights = [row["height"] for row in rows]
            self.assertEqual(heights, sorted(heights))
            self.says(f"from {heights[0]:.0f} to {heights[-1]:.0f}")
            self.assertEqual(min(rows, key=lambda row: row["metamers"])["lambda"], 0.51)


class LowPolyStudy(Page):
    PAGE = "low-poly-study.md"

    def test_series(self):
        for row in table("low-poly-study/series.csv"):
            self.says(f"| {row['resolution']:.0f} | {row['trunk_published']:,.0f} | {row['trunk']:,.0f} | "
                      f"{row['crown_published']:,.0f} | {row['crown']:,.0f} | {row['ratio_published']:.2f} | "
                      f"{row['ratio']:.2f} |")

    def test_readings(self):
        for row in table("low-poly-study/readings.csv"):
            self.says(f"| {row['trunk']:,.0f} | {row['crown']:,.0f} | {row['ratio']:.2f} |")

    def test_parameters(self):
        for row in table("low-poly-study/parameters.csv"):
            self.says(f"| {row['trunk']:,.0f}, {row['crown']:,.0f} | {row['height']:.2f}, {row['width']:.2f} |")

    def test_trees(self):
        for row in table("low-poly-study/trees.csv"):
            crown = f"{row['crown']:,.0f}" if row["crown"] else "–"
            self.assertRegex(self.text, rf"{row['trunk']:,.0f}, {crown}[^|]* \| {row['open_edges']:.0f} \|")


class FitStudy(Page):
    PAGE = "fit-study.md"
    REASONS = {"reached": "found", "growths": "all growths spent", "converged": "nothing new to try"}

    def test_medians(self):
        found = table("fit-study/fits.csv")
        within = sum(row["error"] <= 0.05 for row in found)
        growths = {(row["model"], row["planting"]): row["growths"] for row in found}
        self.assertEqual(len(growths), 20)
        self.assertLessEqual(max(growths.values()), 400)
        self.says(f"The median error of the {len(found)} variables is "
                  f"{100 * statistics.median(row['error'] for row in found):.2f} % of their range. {within} of them "
                  f"are within 5 %. Half of the fits grow at most {int(statistics.median(growths.values()))} plants.")
        for row in found:
            if row["error"] > 0.05:
                planting = ("first", "second")[int(row["planting"])]
                self.says(f"- `{row['variable']}` of the {planting} `{row['model']}`")

    def test_plantings(self):
        found = table("fit-study/fits.csv")
        for model, planting in {(row["model"], row["planting"]) for row in found}:
            rows = [row for row in found if (row["model"], row["planting"]) == (model, planting)]
            worst = max(rows, key=lambda row: row["error"])
            middle = statistics.median(row["error"] for row in rows)
            self.says(f"| `{model}` | {worst['system']} | {planting + 1:.0f} | {100 * middle:.2f} % | "
                      f"{100 * worst['error']:.2f} % | `{worst['variable']}` | {worst['growths']:.0f} | "
                      f"{self.REASONS[worst['reason']]} |")


class GrassStudy(Page):
    PAGE = "grass-study.md"

    def test_fits(self):
        found = {row["what"]: row["found"] for row in table("grass-study/expectations.csv")}
        for plant in ("wheat", "maize"):
            distance = found[f"{plant}: root mean square distance, midribs of at least 12 points"]
            length = found[f"{plant}: length of midribs that turn to and fro by at most 20°, off the polyline's"]
            self.says(f"| {distance.replace(' at most in', ' at most, of')} |",
                      length.replace(", 3 of 3 within", ", of 3").replace(", 23", "; 23"))
        self.says(f"| {found['wheat: its median']} | {found['maize: its median']} |",
                  found["wheat by age: length, off the polyline's"].replace(", 50 of 50 within", ", of 50"),
                  f"| {found['wheat: area off the trapezium rule' + chr(39) + 's'].replace(' in', ', of')} | "
                  f"{found['maize: area off the trapezium rule' + chr(39) + 's'].replace(' in', ', of')} |")
        leaves = {row["plant"]: row for row in table("grass-study/ranks.csv") if row["rank"] == "all"}
        self.says("| " + " | ".join(f"{leaves[plant]['all_hold'] * leaves[plant]['leaves']:.0f} of "
                                    f"{leaves[plant]['leaves']:.0f}" for plant in ("wheat", "maize")) + " |",
                  f"shorter by {-100 * leaves['wheat']['length']:.1f} % in the median")

    def test_smoothing(self):
        within = {row["smoothing"]: 100 * row["length_holds"] for row in table("grass-study/smoothings.csv")
                  if row["plant"] == "wheat"}
        self.says(f"{within[0.0025]:.0f} % of all 450 fits are within 1 %",
                  f"With a smoothing of 0.1 % the share within 1 % would be {within[0.001]:.0f} %, with 0.5 % only "
                  f"{within[0.005]:.0f} %")

    def test_ages(self):
        for kind in (1, 2):
            rows = [row for row in table("grass-study/ages.csv") if row["leaf_class"] == kind]
            most = max(row["most"] for row in rows)
            middle = statistics.median(row["tip"] for row in rows)
            self.says(f"{100 * middle:.1f} % " + ("of the length in class 1 (median; at most " if kind == 1 else
                                                  "in class 2 (at most ") + f"{100 * most:.1f} %)")
        self.says(f"up to {100 * max(row['nearest'] for row in table('grass-study/ages.csv')):.0f} %")

    def test_triangles(self):
        counts = (2, 6, 14, 30, 62, 126)
        levels = {row["triangles"]: row for row in table("grass-study/levels.csv")}
        times = {row["triangles"]: row for row in table("grass-study/times.csv")}

        def share(value):
            """Formats a share with two digits and at most two decimals."""
            return f"{value:.0f} %" if value >= 9.95 else f"{value:.1f} %" if value >= 0.95 else f"{value:.2f} %"

        for words, column in (("Hausdorff distance of the midrib, median leaf", "distance"),
                              ("Hausdorff distance that one leaf in ten exceeds", "distance_tenth"),
                              ("error of the area, before widths are scaled", "area")):
            self.says(f"| {words} | " + " | ".join(share(100 * levels[count][column]) for count in counts) + " |")
        self.says("| time to reduce and mesh, microseconds | " +
                  " | ".join(f"{times[count]['mesh']:.1f}" for count in counts) + " |",
                  f"{(times[126]['mesh'] - times[2]['mesh']) / 124:.2f} µs more for each triangle")
        self.assertLess(max(row["kept_area"] for row in levels.values()), 4.5e-16)

    @staticmethod
    def light(plant, form, stand, light, column="efficiency"):
        [row] = [row for row in table("grass-study/light.csv") if (row["plant"], row["form"], row["stand"], row["light"]) ==
                 (plant, form, stand, light)]
        return row[column]

    FORMS = ("curved", "straight as it leaves the stem", "straight from collar to tip")
    SKY, SUN = "uniform sky", "clear summer's day"

    def test_light_of_whole_plants(self):
        ground = 0.75 * 0.18  # square metres per plant of the field
        for words, plant, stand, light, column, unit in (
                ("field, sky: share of the light on the field that all leaves take", "full grown", "in a field", self.SKY,
                 "taken", ground),
                ("field, sun: share of the light on the field that all leaves take", "full grown", "in a field", self.SUN,
                 "taken", ground),
                ("alone, sky: light, compared with the leaves laid flat in the open", "full grown", "alone", self.SKY,
                 "efficiency", 1),
                ("alone, sun: light, compared with the leaves laid flat in the open", "full grown", "alone", self.SUN,
                 "efficiency", 1),
                ("young plant as measured, field, sky", "young, as measured", "in a field", self.SKY, "taken", ground),
                ("young plant as measured, field, sun", "young, as measured", "in a field", self.SUN, "taken", ground)):
            cells = [f"{100 * self.light(plant, form, stand, light, column) / unit:.1f} %" for form in self.FORMS]
            self.says(f"| {words} | " + " | ".join(cells) + " |")

    def test_light_of_upper_and_lower_leaves(self):
        for light, word in ((self.SKY, "sky"), (self.SUN, "sun")):
            shares = []
            for form in self.FORMS:
                leaves = sorted((row["leaf"], row["share"]) for row in table("grass-study/leaf_light.csv")
                                if (row["plant"], row["form"], row["stand"], row["light"]) ==
                                ("full grown", form, "in a field", light))
                self.assertEqual(len(leaves), 12)
                shares.append((sum(share for _, share in leaves[-4:]), sum(share for _, share in leaves[:4])))
            self.says(*(f"| field, {word}: share of this light that the {end} four leaves take | " +
                        " | ".join(f"{100 * share[k]:.1f} %" for share in shares) + " |"
                        for k, end in ((0, "upper"), (1, "lower"))))

    def test_gains_of_curved_leaves(self):
        def gain(form, stand, light):
            return 100 * (self.light("full grown", "curved", stand, light) / self.light("full grown", form, stand, light) - 1)

        erect, along = self.FORMS[1:]
        self.says(f"alone {gain(erect, 'alone', self.SKY):.0f} % more under the sky and {gain(erect, 'alone', self.SUN):.0f} % "
                  "more in the sun",
                  f"in the field {gain(erect, 'in a field', self.SKY):.0f} and {gain(erect, 'in a field', self.SUN):.0f} % more",
                  f"{-gain(along, 'alone', self.SKY):.0f} % and {-gain(along, 'alone', self.SUN):.0f} % less alone")


class TrainingStudy(Page):
    PAGE = "training-study.md"

    @staticmethod
    def mean(name, column, **where):
        return statistics.fmean(row[column] for row in table(f"training-study/{name}.csv")
                                if all(row[key] == value for key, value in where.items()))

    def test_poles(self):
        for kind in ("slim", "full"):
            free, light, heavy = (self.mean("poles", "mean", set=kind, weight=weight) for weight in (0, 1, 4))
            self.says(f"| {kind} | {free:.2f} | {light:.2f} ({100 * light / free:.0f} %) | {heavy:.2f} ({100 * heavy / free:.0f} %) |")
        self.says(f"Means over {len(table('training-study/poles.csv')) // 6} trees")

    def test_vases(self):
        for at in (8, 9, 10):
            height, cut = (self.mean("vases", column, cut_at=at) for column in ("height", "height_cut"))
            share, share_cut = (self.mean("vases", column, cut_at=at) for column in ("share", "share_cut"))
            trees = sum(row["cut_at"] == at for row in table("training-study/vases.csv"))
            self.says(f"| {at} | {trees} | {height:.1f} → {cut:.1f} (−{100 * (1 - cut / height):.1f} %) | "
                      f"{share:.2f} → {share_cut:.2f} |")

    def test_buds(self):
        rows = table("training-study/buds.csv")
        stretch = [row["stretch"] - row["stretch_cut"] for row in rows]
        whole = [row["whole"] - row["whole_cut"] for row in rows]
        self.says(f"{len(rows)} branches",
                  f"| from the cut to the third metamer above it | about 20° | {statistics.fmean(stretch):.1f}° |",
                  f"| from the branch's base to the same metamer | about 8° | {statistics.fmean(whole):.1f}° |",
                  f"lower in {sum(fall > 0 for fall in stretch)} of {len(rows)} branches")

    def test_espaliers(self):
        arms = table("training-study/arms.csv")
        self.says(f"{sum(row['left'] == 3 and row['right'] == 3 for row in arms)} of {len(arms)} trees have two arms in each layer",
                  f"at most {max(row['inclination'] for row in arms):.1f}° from level",
                  f"at most {max(row['off_plane'] for row in arms):.1f}° from the plane of the wires")

    def test_upkeep(self):
        for words, name in (("spurs and limit", "spurs and limit"), ("each shoot cut to 2", "shoots cut to 2")):
            at = {row["iteration"]: row["metamers"] for row in table("training-study/upkeep.csv") if row["upkeep"] == name}
            self.says(f"| {words} | {at[10]:,.0f} | {at[15]:,.0f} | {at[20]:,.0f} | {at[25]:,.0f} |")
        at = {row["iteration"]: row["metamers"] for row in table("training-study/upkeep.csv") if row["upkeep"] == "none"}
        self.says(f"| none | {at[10]:,.0f} | {at[15]:,.0f} | | |")

    def test_adaptations(self):
        for row in table("training-study/adaptations.csv"):
            self.says(f"| {row['adaptation']} | {100 * row['two_arms']:.0f} % | {row['metamers']:,.0f} | {row['height']:.1f} m | "
                      f"{row['inclination']:.0f}° |")

    def test_cordons(self):
        for light in ("shade from above", "shade along the light", "markers"):
            branches, below, metamers, found = (self.mean("cordons", column, light=light)
                                                for column in ("branches", "below", "metamers", "gathered"))
            self.says(f"| {light} | {branches:.1f} | {below:.1f} | {metamers:.0f} | {found:.0f} |")

    def test_expectations(self):
        rows = table("training-study/expectations.csv")
        self.says(f"{sum(row['holds'] == 'True' for row in rows)} of the {len(rows)} expectations hold")



class ScanStudy(Page):
    PAGE = "scan-study.md"

    @staticmethod
    def rows(instrument, stations):
        return [row for row in table("scan-study/classes.csv")
                if (row["instrument"], row["stations"]) == (instrument, stations)]

    def share(self, stations, member):
        rows = self.rows("terrestrial", stations)
        return 100 * sum(row[member] * row["length"] for row in rows) / sum(row["length"] for row in rows)

    def test_what_is_seen(self):
        for member, count in (("fitted", 1), ("fitted", 2), ("fitted", 6), ("seen", 6)):
            cells = " | ".join(f"{100 * row[member]:.0f} %" for row in self.rows("terrestrial", count))
            self.says(f"| {member}, {count} station{'s' if count > 1 else ''} | {cells} |")
        whole = self.rows("terrestrial", 6)
        self.says(f"{100 * whole[0]['seen']:.0f} % of the wood thinner than 4 mm has at least 5 points. "
                  f"One station sees {100 * self.rows('terrestrial', 1)[0]['seen']:.0f} % of it.",
                  f"{self.share(1, 'fitted'):.0f} % can be fitted from one station, {self.share(2, 'fitted'):.0f} % from two, "
                  f"and {self.share(6, 'fitted'):.0f} % from six",
                  f"gets {sum(int(row['points']) for row in whole):,} points",
                  f"{sum(row['length'] for row in whole):.0f} m of wood")

    def test_how_thick_it_looks(self):
        for instrument, name in (("terrestrial", "`terrestrial`"), ("phase", "`phase`"), ("ray", "ray")):
            cells = " | ".join(f"{row['thickness']:.2f}" for row in self.rows(instrument, 6))
            self.says(f"| {name} | {cells} |")
        whole = self.rows("terrestrial", 6)
        thin = sum(row["length"] for row in whole if row["high"] <= 0.01)
        self.says(f"Wood thinner than 10 mm is {100 * thin / sum(row['length'] for row in whole):.0f} % of the length")

    def test_expectations(self):
        self.assertEqual({row["holds"] for row in table("scan-study/expectations.csv")}, {"True"})


if __name__ == "__main__":
    unittest.main()
