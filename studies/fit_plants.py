# SPDX-License-Identifier: Apache-2.0
"""Plants known values into shipped models of all growth systems, and recovers them from measures of the plants.

    PYTHONPATH=build/release/python /usr/bin/python3 studies/fit_plants.py -o out/fit-study

Writes `fits.csv` (one row per variable), `table.md` (one row per planting), `expectations.csv` and `found.png` into a
folder.
"""

from __future__ import annotations

import argparse
import csv
import sys
from dataclasses import astuple, fields
from pathlib import Path
from statistics import median
from typing import Sequence

from common.needs import need_modules

need_modules("studies/fit_plants.py")

from common.tables import Finding, print_findings, write_findings, write_table
from fit_study.problems import PLANTINGS, PROBLEMS, QUICK, Found, ends_of, solve
from fit_study.report import table_lines

GROWTHS = 400
QUICK_GROWTHS = 150
MOST_ERROR = 0.05  #: median over all variables, as a share of their range


def check(found: Sequence[Found], growths: int) -> list[Finding]:
    every = median(one.error for one in found)
    plantings = {(one.model, one.planting): one.growths for one in found}
    share = sum(one.error <= MOST_ERROR for one in found) / len(found)
    return [
        Finding(
            f"median error of {len(found)} variables",
            f"at most {100 * MOST_ERROR:g} % of the range",
            f"{100 * every:.2f} %",
            every <= MOST_ERROR,
        ),
        Finding(
            "variables within that", "at least half of them", f"{100 * share:.0f} %", share >= 0.5
        ),
        Finding(
            f"growths of {len(plantings)} plantings",
            f"at most {growths}",
            f"median {median(plantings.values()):g}, most {max(plantings.values())}",
            max(plantings.values()) <= growths,
        ),
    ]


def read_found(path: Path) -> list[Found]:
    """Returns the rows of a stopped study."""
    types = {field.name: {"str": str, "int": int, "float": float}[str(field.type)] for field in fields(Found)}
    with open(path, newline="", encoding="utf-8") as file:
        return [Found(**{name: types[name](cell) for name, cell in row.items()}) for row in csv.DictReader(file)]


def run_study(folder: Path, quick: bool, resume: bool) -> None:
    """Solves all problems, saves each planting when it is found, and then writes the results."""
    from fit_study.figures import draw_found  # slow to import, so not needed for --help

    folder.mkdir(parents=True, exist_ok=True)
    table = folder / "fits.csv"
    problems = [problem for problem in PROBLEMS if not quick or problem.model in QUICK]
    growths = QUICK_GROWTHS if quick else GROWTHS
    found = read_found(table) if resume and table.exists() else []
    known = {(one.model, one.planting) for one in found}
    for problem in problems:
        for planting in range(1 if quick else PLANTINGS):
            if (problem.model, planting) in known:
                continue
            solved = solve(problem, planting, growths)
            found += solved
            write_table(table, [field.name for field in fields(Found)], map(astuple, found))
            errors = "  ".join(f"{one.variable} {one.true:.4g}→{one.found:.4g}" for one in solved)
            middle = 100 * median(one.error for one in solved)
            print(f"{problem.model:<13}{planting + 1}  {solved[0].growths:4} growths  {middle:6.2f} %  {errors}", flush=True)
    ends = {(problem.model, name): pair for problem in problems for name, pair in ends_of(problem).items()}
    findings = check(found, growths)
    write_findings(folder / "expectations.csv", findings)
    (folder / "table.md").write_text("\n".join(table_lines(found)) + "\n", encoding="utf-8")
    draw_found(folder / "found.png", found, ends)
    print_findings(findings)


def main() -> int:
    parser = argparse.ArgumentParser(description="Plants values, fits them by the measures of their plants, draws it.")
    parser.add_argument("-o", "--output", type=Path, default=Path("out/fit-study"), metavar="DIR", help="for files")
    parser.add_argument("--quick", action="store_true", help=f"{len(QUICK)} plantings of few growths: to try it")
    parser.add_argument("--resume", action="store_true", help="keep the plantings that the folder's fits.csv has")
    options = parser.parse_args()
    try:
        run_study(options.output, options.quick, options.resume)
    except KeyboardInterrupt:
        print("\nstopped", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
