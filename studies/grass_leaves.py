# SPDX-License-Identifier: Apache-2.0
"""Fits, ages, reduces, bends and lights measured grass leaves, and measures the cost of each stage.

    PYTHONPATH=build/release/python /usr/bin/python3 studies/grass_leaves.py -o out/grass-study

Writes `fits.csv` (one row per leaf), `ranks.csv`, `smoothings.csv`, `ages.csv`, `levels.csv`, `times.csv`, `turns.csv`,
`light.csv`, `leaf_light.csv`, `expectations.csv` and the figures into a folder.
Based on: C. Fournier, C. Pradal: A plastic, dynamic and reducible 3D geometric model for simulating gramineous leaves
(PMA 2012), with the leaves of openalea-incubator/adel (CeCILL-C), which are not part of the project.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import astuple, fields
from pathlib import Path
from typing import Any, Mapping, NamedTuple, Sequence

from common.needs import need_modules

need_modules("studies/grass_leaves.py")

from common.tables import Finding, print_findings, write_findings, write_table
from grass_study import ages, expectations, fits, forces, levels, light, measured, plants

QUICK_EVERY = 15  #: every n-th wheat leaf is reduced
QUICK_RAYS = 6  #: every n-th direction of the light is used
FORCED_EVERY = 10  #: every n-th wheat leaf is bent


class Data(NamedTuple):
    wheat: Sequence[measured.MeasuredLeaf]
    maize: Sequence[measured.MeasuredLeaf]
    classes: Mapping[int, Sequence[measured.AgedMidrib]]


def write_rows(path: Path, rows: Sequence[Any]) -> None:
    """Writes a table of dataclasses."""
    write_table(path, [field.name for field in fields(rows[0])], map(astuple, rows))


def light_all(data: Data, is_quick: bool) -> tuple[list[plants.Plant], dict[light.Case, light.Lit]]:
    """Measures every plant, form and stand under each light."""
    grown = [plants.full_grown(), plants.young(data.maize)]
    lit = {}
    for name, make_rays in light.LIGHTS.items():
        rays = light.thin_out(make_rays(), QUICK_RAYS if is_quick else 1)
        for plant in grown[:1] if is_quick else grown:
            for form in plants.FORMS:
                for stand in (plants.ALONE, plants.FIELD):
                    case = light.Case(plant.name, form, stand.name, name)
                    lit[case] = light.measure_light(plant, form, stand, rays)
    return grown, lit


def write_light(folder: Path, lit: Mapping[light.Case, light.Lit]) -> None:
    """Writes one row per stand, and one row per leaf."""
    whole = [[*case, of.plants, of.area, of.total, of.total / of.area] for case, of in lit.items()]
    write_table(folder / "light.csv", (*light.Case._fields, "plants", "leaf_area", "taken", "efficiency"), whole)
    leaves = [
        [*case, rank + 1, *map(float, row)]
        for case, of in lit.items()
        for rank, row in enumerate(zip(of.areas, of.taken, of.shares, of.efficiency))
    ]
    head = (*light.Case._fields, "leaf", "area", "taken", "share", "efficiency")
    write_table(folder / "leaf_light.csv", head, leaves)


def print_ranks(ranks: Sequence[fits.FitSummary]) -> None:
    print("plant  rank  leaves   distance  at most   length  smooth  off by    area  at most  all bounds")
    for row in ranks:
        print(
            f"{row.plant:<6} {row.rank:>4} {row.leaves:7}   {100 * row.distance:6.2f} %"
            f"  {100 * row.distance_most:5.2f} %  {100 * row.length:5.2f} %  {row.smooth:5}"
            f"  {100 * row.length_most:5.2f} %  {100 * row.area:4.2f} %"
            f"   {100 * row.area_most:4.2f} %      {100 * row.all_hold:5.1f} %"
        )


def print_light(lit: Mapping[light.Case, light.Lit]) -> None:
    print("light taken, of what falls on the plant's ground in a field, or on as much ground as its leaves have area")
    for case, of in lit.items():
        whole = plants.FIELD.ground if case.stand == plants.FIELD.name else of.area
        upper = float(of.shares[len(of.shares) // 2 :].sum())
        print(
            f"{case.plant:<19} {case.light:<19} {case.stand:<11} {case.form:<31} {of.total / whole:.3f}"
            f"  upper half {100 * upper:5.1f} %"
        )


def run_study(folder: Path, data_folder: Path, is_quick: bool) -> None:
    """Runs all measurements, writes all files and prints the main results."""
    # Slow to import, so not needed for --help
    from grass_study.figures import draw_ages, draw_errors, draw_fits, draw_forces, draw_levels
    from grass_study.light_figures import draw_light
    from grass_study.pictures import draw_plants, draw_triangles

    folder.mkdir(parents=True, exist_ok=True)
    data = Data(measured.read_wheat(data_folder), measured.read_maize(data_folder), measured.read_ages(data_folder))
    of_fits = {
        "wheat": [fits.measure_fit(leaf) for leaf in data.wheat],
        "maize": [fits.measure_fit(leaf) for leaf in data.maize],
    }
    ranks = [row for of_plant in of_fits.values() for row in fits.summarize_ranks(of_plant)]
    smoothed = [*fits.vary_smoothing(data.wheat), *fits.vary_smoothing(data.maize)]
    of_ages = ages.leave_each_out(data.classes)
    some = data.wheat[:: QUICK_EVERY if is_quick else 1]
    full = [leaf.fit(pieces=levels.FULL_PIECES).leaf for leaf in some]
    of_levels = levels.measure_levels(full)
    times = levels.measure_times(some)
    turns = forces.find_turns([leaf.fit().leaf for leaf in data.wheat[::FORCED_EVERY]])
    grown, lit = light_all(data, is_quick)
    findings: list[Finding] = [
        *expectations.check_fits("wheat", of_fits["wheat"]),
        *expectations.check_fits("maize", of_fits["maize"]),
        expectations.check_lengths("wheat by age: length", fits.length_errors(data.classes)),
        *expectations.check_ages(of_ages),
        *expectations.check_levels(of_levels, levels.ten_of_a_hundred(data.wheat), levels.points_are_nested(full)),
        *expectations.check_forces(turns),
        *expectations.check_light(lit),
    ]

    write_rows(folder / "fits.csv", [*of_fits["wheat"], *of_fits["maize"]])
    write_rows(folder / "ranks.csv", ranks)
    write_rows(folder / "smoothings.csv", smoothed)
    write_rows(folder / "ages.csv", [error for of_class in of_ages.values() for error in of_class])
    write_rows(folder / "levels.csv", of_levels)
    write_table(folder / "times.csv", levels.Time._fields, times)
    write_rows(folder / "turns.csv", turns)
    write_light(folder, lit)
    write_findings(folder / "expectations.csv", findings)
    draw_fits(folder / "fits.png", data.wheat, data.maize)
    draw_errors(folder / "errors.png", of_fits, smoothed[: len(fits.SMOOTHINGS)])
    draw_ages(folder / "ages.png", data.classes, of_ages)
    draw_levels(folder / "levels.png", of_levels, times)
    draw_forces(folder / "forces.png", data.wheat[len(data.wheat) // 2].fit().leaf, turns)
    draw_triangles(
        folder / "triangles.png",
        [("wheat", data.wheat[0].fit().leaf), ("maize", data.maize[8].fit().leaf)],
    )
    draw_light(folder / "light.png", grown[0].name, lit)
    draw_plants(folder / "plants.png", grown[0])

    print_ranks(ranks)
    print("\ntriangles  Hausdorff   of a tenth   area    microseconds: reduce and mesh, with fit")
    for level, one in zip(of_levels, times):
        print(
            f"{level.triangles:9} {100 * level.distance:9.2f} % {100 * level.distance_tenth:9.2f} %"
            f" {100 * level.area:9.2f} %  {one.mesh:12.1f} {one.all:12.1f}"
        )
    print()
    print_light(lit)
    print()
    print_findings(findings)


def main() -> int:
    parser = argparse.ArgumentParser(description="Fits measured grass leaves, and says what each stage costs.")
    parser.add_argument("-o", "--output", type=Path, default=Path("out/grass-study"), metavar="DIR", help="for files")
    parser.add_argument(
        "--data", type=Path, default=measured.FOLDER, metavar="DIR", help=f"measured leaves ({measured.FOLDER})"
    )
    parser.add_argument("--quick", action="store_true", help="few leaves and little light: to try it")
    options = parser.parse_args()
    missing = measured.missing_files(options.data)
    if missing:
        print(
            f"{options.data} has not {', '.join(missing)}.\n"
            "The measured leaves are those of https://github.com/openalea-incubator/adel (CeCILL-C) and no part of\n"
            "the project. --data or MERISTEM_SHARED_DATA may name their folder, or the one above it.",
            file=sys.stderr,
        )
        return 1
    try:
        run_study(options.output, options.data, options.quick)
    except KeyboardInterrupt:
        print("\nstopped", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
