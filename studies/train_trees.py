# SPDX-License-Identifier: Apache-2.0
"""Repeats published results on trained trees: poles, open vases, cuts to buds, espaliers, cordons.

    PYTHONPATH=build/release/python /usr/bin/python3 studies/train_trees.py -o out/training-study

Writes a table for each question, `expectations.csv` and the figures into a folder.
Based on: J. Stevens, Automatische generatie van gesnoeide boom modellen, Universiteit Hasselt 2023, sections 4.1 to
5.3.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import astuple, fields
from pathlib import Path
from typing import Any, Sequence

from common.needs import need_modules

need_modules("studies/train_trees.py")

from common.tables import positive_number, print_findings, write_findings, write_table
from training_study.bud import study_buds
from training_study.cordon import study_cordons
from training_study.espalier import VIGOROUS, study_adaptations, study_arms, study_held, study_upkeep
from training_study.expectations import check_buds, check_cordons, check_espaliers, check_poles, check_vases
from training_study.pole import study_poles
from training_study.vase import study_vases

SEEDS = 40
QUICK_SEEDS = 20
UPKEEP_SEEDS = 20  #: number of espaliers that are followed over the years


def write_rows(path: Path, rows: Sequence[Any]) -> None:
    """Writes one row for each dataclass."""
    write_table(path, (field.name for field in fields(rows[0])), (astuple(row) for row in rows))


def run_study(folder: Path, count: int) -> None:
    from training_study.figures import draw_buds, draw_pictures, draw_poles, draw_upkeep  # slow to import

    folder.mkdir(parents=True, exist_ok=True)
    seeds = range(count)
    stems, vases, branches = study_poles(seeds), study_vases(seeds), study_buds(seeds)
    arms, cordons = study_arms(seeds), study_cordons(seeds)
    vigorous = study_arms(seeds, VIGOROUS)
    upkeep, broken = study_upkeep(seeds[:UPKEEP_SEEDS]), study_adaptations(seeds)
    held = study_held(seeds[:UPKEEP_SEEDS])
    findings = [
        *check_poles(stems),
        *check_vases(vases),
        *check_buds(branches),
        *check_espaliers(arms, vigorous, upkeep, held),
        *check_cordons(cordons),
    ]
    tables: dict[str, Sequence[Any]] = {
        "poles": stems, "vases": vases, "buds": branches, "arms": arms, "cordons": cordons, "upkeep": upkeep,
        "held": held, "adaptations": broken,
    }  # fmt: skip
    for name, rows in tables.items():
        write_rows(folder / f"{name}.csv", rows)
    write_findings(folder / "expectations.csv", findings)
    draw_poles(folder / "poles.png", seeds)
    draw_upkeep(folder / "upkeep_curves.png", upkeep)
    draw_buds(folder / "buds.png", branches)
    draw_pictures(folder, seed=1)
    print_findings(findings)


def main() -> int:
    parser = argparse.ArgumentParser(description="Trains trees as published, compares what comes of it, draws it.")
    parser.add_argument("-o", "--output", type=Path, default=Path("out/training-study"), metavar="DIR", help="for files")
    parser.add_argument("--seeds", type=positive_number, default=SEEDS, metavar="N", help=f"trees for each mean ({SEEDS})")
    parser.add_argument("--quick", action="store_true", help=f"{QUICK_SEEDS} trees: to try it")
    options = parser.parse_args()
    try:
        run_study(options.output, QUICK_SEEDS if options.quick else options.seeds)
    except KeyboardInterrupt:
        print("\nstopped", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
