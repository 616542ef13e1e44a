# SPDX-License-Identifier: Apache-2.0
"""Repeats a published evaluation of trees that respond to light, and adds response B.

    PYTHONPATH=build/release/python /usr/bin/python3 studies/space_colonization_light.py -o out/light-study

Writes `trees.csv` (one row per tree), `means.csv` (one row per treatment), `hours.csv` (one row per hour of a day in
the open), `expectations.csv` and the figures into a folder.
Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund 2020,
chapter 5.
"""

from __future__ import annotations

import argparse
import os
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import astuple, fields
from pathlib import Path
from typing import Iterable, Sequence

from common.needs import need_modules

need_modules("studies/space_colonization_light.py")

from common.tables import positive_number, print_findings, write_findings, write_table
from light_study.expectations import SHIFTS, check_expectations
from light_study.hours import Hour, study_hours
from light_study.trees import (
    MEASURES,
    Mean,
    Plan,
    Tree,
    Treatment,
    count_growths,
    group_by_treatment,
    grow_treatments,
    take_mean,
)

CLOUDS = 10
STRENGTHS: dict[str, Sequence[float]] = {
    "shift": SHIFTS,
    "shift_scaled": SHIFTS,
    "shift_held": SHIFTS[::2],
    "limit": (0, 0.12, 0.24, 0.36, 0.48, 0.6),
    "drift": tuple(round(0.1 * k, 1) for k in range(11)),
}
QUICK_CLOUDS = 2
QUICK_STRENGTHS: dict[str, Sequence[float]] = {
    "shift": (0, 0.005, 0.010),
    "shift_scaled": (0, 0.005, 0.010),
    "shift_held": (0, 0.005, 0.010),
    "limit": (0, 0.36, 0.6),
    "drift": (0, 0.5, 0.9),
}
KEYS = ("response", "scene", "strength")


class Counter:
    """Prints the number of grown trees in one line of a terminal. Prints nothing if the output is no terminal."""

    def __init__(self, total: int) -> None:
        self._total = total
        self._done = 0
        self._shown = sys.stderr.isatty()

    def __call__(self) -> None:
        self._done += 1
        if self._shown:
            end = "\n" if self._done == self._total else ""
            print(f"\r{self._done} of {self._total} trees", end=end, file=sys.stderr, flush=True)


def list_treatments(strengths: dict[str, Sequence[float]]) -> list[Treatment]:
    """Returns all responses in both scenes."""
    return [
        Treatment(response, scene, strength)
        for response, values in strengths.items()
        for scene in ("A", "B")
        for strength in values
    ]


def grow_on_threads(treatments: Sequence[Treatment], clouds: int, threads: int) -> list[Tree]:
    """Grows all trees. After an interrupt, only the current trees are completed."""
    pool = ThreadPoolExecutor(threads)
    try:
        return grow_treatments(treatments, clouds, pool, Counter(count_growths(treatments, clouds)))
    finally:
        pool.shutdown(cancel_futures=True)


def write_trees(path: Path, trees: Sequence[Tree]) -> None:
    head = (*KEYS, *Plan._fields[1:], *MEASURES)
    rows = ((*tree.plan.treatment, *tree.plan[1:], *(tree.measures[name] for name in MEASURES)) for tree in trees)
    write_table(path, head, rows)


def write_means(path: Path, means: Iterable[Mean]) -> None:
    head = [*KEYS, "trees", "scale", *MEASURES, *(f"{name}_spread" for name in MEASURES)]
    rows = (
        [
            *mean.treatment,
            mean.trees,
            mean.scale,
            *(mean.measures[name] for name in MEASURES),
            *(mean.spreads[name] for name in MEASURES),
        ]
        for mean in means
    )
    write_table(path, head, rows)


def print_means(means: Iterable[Mean]) -> None:
    """Prints one line per treatment."""
    print("response     scene strength  height  azimuth spread altitude  centroid at   sun %  day %")
    for mean in means:
        response, scene, strength = mean.treatment
        m = mean.measures
        print(
            f"{response:<12} {scene:<5} {strength:8.3f} {m['height']:6.2f} m {m['inclination_azimuth']:7.1f} "
            f"{mean.spreads['inclination_azimuth']:6.1f} {m['inclination_altitude']:8.1f} "
            f"{m['centroid_radius']:6.2f} m {m['centroid_azimuth']:5.0f} "
            f"{100 * m['lit_share_still']:6.1f} {100 * m['lit_share_day']:6.1f}"
        )


def run_study(folder: Path, quick: bool, threads: int) -> None:
    """Grows all trees, writes all files and prints the means."""
    from light_study.figures import draw_figures  # slow to import, so not needed for --help

    folder.mkdir(parents=True, exist_ok=True)
    clouds = QUICK_CLOUDS if quick else CLOUDS
    trees = grow_on_threads(list_treatments(QUICK_STRENGTHS if quick else STRENGTHS), clouds, threads)
    means = {treatment: take_mean(group) for treatment, group in group_by_treatment(trees).items()}
    findings = check_expectations(means)
    write_trees(folder / "trees.csv", trees)
    write_means(folder / "means.csv", means.values())
    write_findings(folder / "expectations.csv", findings)
    hours = study_hours(range(clouds))
    write_table(folder / "hours.csv", (field.name for field in fields(Hour)), (astuple(row) for row in hours))
    draw_figures(folder, trees, means)
    print_means(means.values())
    print(f"\nexpected of means over {CLOUDS} clouds; these are over {clouds}:")
    print_findings(findings)


def main() -> int:
    parser = argparse.ArgumentParser(description="Grows trees in the light, measures them and draws the results.")
    parser.add_argument("-o", "--output", type=Path, default=Path("out/light-study"), metavar="DIR", help="for files")
    parser.add_argument("--quick", action="store_true", help="2 clouds and 3 strengths: to try it")
    parser.add_argument(
        "--threads", type=positive_number, default=os.cpu_count() or 1, metavar="N", help="that grow trees (all cores)"
    )
    options = parser.parse_args()
    try:
        run_study(options.output, options.quick, options.threads)
    except KeyboardInterrupt:
        print("\nstopped", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
