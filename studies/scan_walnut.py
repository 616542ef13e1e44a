# SPDX-License-Identifier: Apache-2.0
"""Scans a digitised walnut from six positions, and compares the visible twigs with the true plant.

    PYTHONPATH=build/release/python /usr/bin/python3 studies/scan_walnut.py -o out/scan-study

Writes `classes.csv` (one row per instrument, number of stations and class of diameters), `orders.csv`,
`expectations.csv` and the figures into a folder.
Based on: the walnut of openalea/mtg (CeCILL-C), which is not part of the project.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import astuple, fields
from pathlib import Path
from typing import Any, Sequence

from common.needs import need_modules

need_modules("studies/scan_walnut.py")

from common.tables import print_findings, write_findings, write_table
from scan_study import coverage, expectations, walnut

SHOWN = "terrestrial"  #: the instrument whose points are drawn
STEP = 0.04  #: degrees between pulses
QUICK_STEP = 0.25


def write_rows(path: Path, rows: Sequence[Any]) -> None:
    """Writes a table of dataclasses."""
    write_table(path, [field.name for field in fields(rows[0])], map(astuple, rows))


def run_study(folder: Path, step: float) -> None:
    """Scans with each instrument, writes all files and prints the expectations."""
    from scan_study.figures import draw_figures  # slow to import, so not needed for --help
    from scan_study.pictures import draw_oak

    folder.mkdir(parents=True, exist_ok=True)
    plant = walnut.grow_walnut()
    segments = walnut.segments_of(plant)
    rows: list[coverage.Coverage] = []
    orders: list[coverage.OrderCoverage] = []
    for instrument in walnut.INSTRUMENTS:
        scan = walnut.scan_walnut(plant, instrument, step)
        located = coverage.locate(scan, segments)
        rows += coverage.cover_stations(instrument, located, segments)
        orders += coverage.cover_orders(instrument, located, segments)
        print(f"{instrument:<12} {len(scan['range']):>9} points")
        if instrument == SHOWN:
            shown = scan
    findings = expectations.check_scans(rows, orders)
    write_rows(folder / "classes.csv", rows)
    write_rows(folder / "orders.csv", orders)
    write_findings(folder / "expectations.csv", findings)
    draw_figures(folder, rows, shown)
    draw_oak(folder, 2 * step)
    for row in expectations.of(rows, "terrestrial"):
        print(
            f"{1000 * row.low:4.0f} to {1000 * row.high:4.0f} mm  {row.length:6.1f} m  seen {100 * row.seen:3.0f} %  "
            f"fitted {100 * row.fitted:3.0f} %  thickness {row.thickness:.2f}"
        )
    print_findings(findings)


def main() -> int:
    parser = argparse.ArgumentParser(description="Scans a digitised walnut, compares points and wood, draws it.")
    parser.add_argument("-o", "--output", type=Path, default=Path("out/scan-study"), metavar="DIR", help="for files")
    parser.add_argument("--quick", action="store_true", help=f"{QUICK_STEP}° between pulses: to try it")
    options = parser.parse_args()
    if not walnut.FILE.is_file():
        print(
            f"The walnut is not there: {walnut.FILE}. It is no part of the project; MERISTEM_SHARED_DATA names the folder "
            "that has 'trees/noylum2.mtg'.",
            file=sys.stderr,
        )
        return 0
    try:
        run_study(options.output, QUICK_STEP if options.quick else STEP)
    except KeyboardInterrupt:
        print("\nstopped", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
