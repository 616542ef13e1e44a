# SPDX-License-Identifier: Apache-2.0
"""Repeats a published evaluation of low-poly trees, and tells why its counts of triangles are others than ours.

    PYTHONPATH=build/release/python /usr/bin/python3 studies/low_poly_trees.py -o out/low-poly-study

Writes `trees.csv`, `parameters.csv`, `series.csv`, `readings.csv`, `tried.csv` and `expectations.csv` into a folder.
Based on: F. Heuer, Algorithmische Erzeugung von 3D-Low-Poly-Bäumen, Hamburg 2022, sections 6.1 to 6.3.
"""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path
from typing import Mapping, NamedTuple

from common.needs import need_modules

need_modules("studies/low_poly_trees.py")

from common.tables import Finding, print_findings, write_findings, write_table
from low_poly_study.bodies import ROOT, SPRUCE, count_open_edges, grow_bodies, read
from low_poly_study.published import PARAMETERS, SERIES, TREES, Row

#: Assumptions that reproduce the source's counts: the side of the cube that contains both bodies (metres), the width
#: over which the crown's balls blend (metres), and how often each triangle counts.
CUBE = 2.4
FUSE = 0.078
COUNTED = 2
#: The side of a smaller cube, whose counts agree without counting triangles twice.
SMALL_CUBE = 1.7
#: The printed width: k = 0.01 m², whose root is 0.1 m.
PRINTED_FUSE = 0.1
#: Other readings of the crown, in the cube and counted twice: a name, and the keys that they change.
TRIED: tuple[tuple[str, dict[str, object]], ...] = (
    ("k as a width of 0.01 m", {"surface.crown.fuse": 0.01}),
    ("balls that blend over 0.09 m", {"surface.crown.fuse": 0.09}),
    ("balls that blend over 0.07 m", {"surface.crown.fuse": 0.07}),
    ("balls that blend over 0.06 m", {"surface.crown.fuse": 0.06}),
    ("the diameter as 0.04 m", {"surface.crown.diameter": 0.04}),
    ("a polynomial blend over 0.1 m", {"surface.crown.blend": "poly"}),
    ("Pasko's blend over 0.1 m", {"surface.crown.blend": "pasko"}),
    ("five steps", {"steps": 5}),
)
LONGEST_ERROR = 0.08  #: relative error of a count of the series, except its first row
QUICK_ROWS = 4


class Tree(NamedTuple):
    """A tree of section 6.1."""

    name: str
    trunk: int
    crown: int
    open_edges: int


class Reading(NamedTuple):
    """The part of the source's setup that a series uses, and its counts at resolution 100."""

    name: str
    counts: Row


def own_sizes(text: str, values: Mapping[str, object]) -> tuple[float, float]:
    """Returns the longest sides of the bounding boxes of trunk (cones) and crown (balls) in metres."""
    bodies = grow_bodies(text, {"surface.resolution": 400, "surface.crown.resolution": 400, **values,
                                "surface.crown.fuse": 0})
    trunk, crown = bodies["trunk"], bodies["crown"]
    return float(max(trunk.high - trunk.low)), float(max(crown.high - crown.low))


def grow_trees() -> list[Tree]:
    """Returns the trees of section 6.1 at the source's resolutions, without simplification."""
    trees = []
    for name, (trunk, crown) in TREES.items():
        text = read(ROOT / "models" / f"low-poly-{name}.json")
        values: dict[str, object] = {}
        if '"style": "blend"' in text:  # our palm's trunk is a tube
            values |= {"surface.resolution": trunk, "surface.triangles": None}
        if '"crown"' in text:
            values |= {"surface.crown.resolution": crown, "surface.crown.triangles": None}
        bodies = grow_bodies(text, values)
        open_edges = sum(count_open_edges(body) for body in bodies.values())
        trees.append(Tree(name, bodies["trunk"].count, bodies["crown"].count, open_edges))
    return trees


def vary_parameters(text: str) -> list[list[object]]:
    """Returns, for each parameter of the source, its name, our key, the value, and the resulting measures of the
    spruce."""
    rows: list[list[object]] = []
    for name, key, value in (("as printed", "", ""), *PARAMETERS):
        bodies = grow_bodies(text, {key: value} if key else {})
        low = min(bodies["trunk"].low[1], bodies["crown"].low[1])
        high = max(bodies["trunk"].high[1], bodies["crown"].high[1])
        width = max(max(body.high[0] - body.low[0], body.high[2] - body.low[2]) for body in bodies.values())
        rows.append([name, key, value, bodies["trunk"].count, bodies["crown"].count, float(high - low), float(width)])
    return rows


def count_series(text: str, rows: tuple[Row, ...], cube: float | None, counted: int,
                 values: Mapping[str, object]) -> list[Row]:
    """Counts triangles at the source's resolutions, relative to one cube or to each body's own box."""
    sizes = own_sizes(text, values)
    series = []
    for row in rows:
        cells = [row.resolution if cube is None else round(row.resolution * size / cube) for size in sizes]
        bodies = grow_bodies(text, {"surface.resolution": cells[0], "surface.crown.resolution": cells[1], **values})
        series.append(Row(row.resolution, counted * bodies["trunk"].count, counted * bodies["crown"].count))
    return series


def compare_readings(text: str) -> list[Reading]:
    """Returns the counts at resolution 100 while the assumptions are added one by one, and with a smaller cube."""
    steps = [
        ("each body in its own box", None, PRINTED_FUSE, 1),
        ("both in one cube", CUBE, PRINTED_FUSE, 1),
        ("and balls that blend over less", CUBE, FUSE, 1),
        ("and each triangle counted twice", CUBE, FUSE, COUNTED),
        ("instead: a smaller cube, counted once", SMALL_CUBE, FUSE, 1),
    ]
    readings = [Reading("published", published_row())]
    for name, cube, fuse, counted in steps:
        [row] = count_series(text, (published_row(),), cube, counted, {"surface.crown.fuse": fuse})
        readings.append(Reading(name, row))
    return readings


def try_readings(text: str) -> list[Reading]:
    """Returns the counts at resolution 100 with other readings of the crown."""
    return [Reading(name, count_series(text, (published_row(),), CUBE, COUNTED, values)[0]) for name, values in TRIED]


def published_row() -> Row:
    [row] = [row for row in SERIES if row.resolution == 100]
    return row


def error_of(ours: float, published: float) -> float:
    return ours / published - 1


def check(trees: list[Tree], parameters: list[list[object]], series: list[Row]) -> list[Finding]:
    base, *others = parameters
    idle = [str(row[0]) for row in others if row[3:] == base[3:]]
    errors = [abs(error_of(ours, published)) for row, wanted in zip(series[1:], SERIES[1:])
              for ours, published in zip(row[1:], wanted[1:])]
    first = max(abs(error_of(ours, published)) for ours, published in zip(series[0][1:], SERIES[0][1:]))
    ratios = [abs(error_of(row.ratio, wanted.ratio)) for row, wanted in zip(series[1:], SERIES[1:])]
    return [
        Finding("fir, palm and oak are made (6.1)", "3 trees", str(sum(tree.trunk > 0 for tree in trees)),
                all(tree.trunk > 0 for tree in trees)),
        Finding("parameters of table 4.3 that change the tree (6.1)", str(len(others)), str(len(others) - len(idle)),
                not idle),
        Finding("edges with a hole beside them (6.3)", "0", str(sum(tree.open_edges for tree in trees)),
                all(tree.open_edges == 0 for tree in trees)),
        Finding("largest error of a count from resolution 50 on (6.2)", f"at most {100 * LONGEST_ERROR:.0f} %",
                f"{100 * max(errors):.1f} %", max(errors) <= LONGEST_ERROR),
        Finding("largest error of crown over trunk from resolution 50 on", f"at most {100 * LONGEST_ERROR:.0f} %",
                f"{100 * max(ratios):.1f} %", max(ratios) <= LONGEST_ERROR),
        Finding("largest error of a count at resolution 25", f"at most {100 * LONGEST_ERROR:.0f} %",
                f"{100 * first:.1f} %", first <= LONGEST_ERROR),
    ]


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", type=Path, required=True, help="folder for the tables")
    parser.add_argument("--quick", action="store_true", help=f"only the first {QUICK_ROWS} resolutions")
    options = parser.parse_args(arguments)
    options.output.mkdir(parents=True, exist_ok=True)
    text = read(SPRUCE)
    trees = grow_trees()
    write_table(options.output / "trees.csv", Tree._fields, trees)
    parameters = vary_parameters(text)
    write_table(options.output / "parameters.csv",
                ("parameter", "key", "value", "trunk", "crown", "height", "width"), parameters)
    rows = SERIES[:QUICK_ROWS] if options.quick else SERIES
    series = count_series(text, rows, CUBE, COUNTED, {"surface.crown.fuse": FUSE})
    write_table(options.output / "series.csv",
                ("resolution", "trunk_published", "trunk", "crown_published", "crown", "ratio_published", "ratio"),
                [(wanted.resolution, wanted.trunk, row.trunk, wanted.crown, row.crown, wanted.ratio, row.ratio)
                 for wanted, row in zip(SERIES, series)])
    for name, readings in (("readings", compare_readings(text)), ("tried", try_readings(text))):
        write_table(options.output / f"{name}.csv", ("reading", "trunk", "crown", "ratio"),
                    [(reading.name, reading.counts.trunk, reading.counts.crown, reading.counts.ratio)
                     for reading in readings])
    findings = check(trees, parameters, series)
    write_findings(options.output / "expectations.csv", findings)
    print_findings(findings)
    root_mean = math.sqrt(sum(error_of(ours, published) ** 2 for row, wanted in zip(series, SERIES)
                              for ours, published in zip(row[1:], wanted[1:])) / (2 * len(series)))
    print(f"root of the mean square of all errors: {100 * root_mean:.1f} %")
    return 0


if __name__ == "__main__":
    sys.exit(main())
