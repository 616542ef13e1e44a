# SPDX-License-Identifier: Apache-2.0
"""Repeats a published evaluation of trees with a cut leader, and measures the effect of each part of the model.

    PYTHONPATH=build/release/python /usr/bin/python3 studies/cut_leader.py -o out/cut-study

Writes `cuts.csv` (one row per tree), `readings.csv`, `adaptations.csv`, `growth.csv`, `lambda.csv`, `trials.csv`,
`expectations.csv` and the figures into a folder.
Based on: J. Stevens, Automatische generatie van gesnoeide boom modellen, Universiteit Hasselt 2023, section 5.2.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import astuple, fields
from pathlib import Path
from typing import Mapping, Sequence

from common.needs import need_modules

need_modules("studies/cut_leader.py")

from common.tables import positive_number, print_findings, write_findings, write_table
from cut_study.adaptations import ADAPTATIONS, Effect, study_adaptation
from cut_study.cuts import LATERALS, PUBLISHED, READINGS, CutTree, Reading, Summary, compare_cuts, summarize
from cut_study.expectations import check_adaptations, check_cuts, check_growth, check_lambda
from cut_study.growth import LAMBDAS, SETS, Curve, Habit, follow_growth, vary_lambda
from cut_study.trees import SLIM
from cut_study.trials import Trial, study_trials

SEEDS = 100
QUICK_SEEDS = 20
GROWTH_SEEDS = 20  #: growth curves and habits differ little between trees
LAMBDA_SETS = ("slim", "full")

def lateral_names() -> list[str]:
    return [f"lateral_{k + 1}{end}" for k in range(LATERALS) for end in ("", "_cut")]


def write_cuts(path: Path, trees: Sequence[CutTree]) -> None:
    """Writes one row per tree. Cells of missing laterals are empty."""
    rows = []
    for tree in trees:
        row: list[object] = [tree.seed, tree.above, tree.branches, *tree.total, tree.leader]
        row += [resource for pair in tree.laterals for resource in pair]
        rows.append(row + [""] * (2 * (LATERALS - len(tree.laterals))))
    write_table(path, ("seed", "above", "branches", "total", "total_cut", "leader", *lateral_names()), rows)


def summary_head() -> list[str]:
    whole = ("trees", "alike", "total", "total_cut", "fall", "fall_holds")
    return [*whole, "leader", "leader_share", "leader_holds", "all_rise", *lateral_names()]


def list_summary(trees: Summary) -> list[object]:
    """Returns the cells for summary_head()."""
    whole: list[object] = [trees.trees, trees.alike, *trees.total, trees.fall, trees.fall_holds]
    laterals = [resource for pair in trees.laterals for resource in pair]
    return [*whole, trees.leader, trees.leader_share, trees.leader_holds, trees.all_rise, *laterals]


def write_readings(path: Path, readings: Mapping[Reading, Sequence[CutTree]]) -> None:
    rows = [[reading.name, *list_summary(summarize(trees))] for reading, trees in readings.items()]
    write_table(path, ("reading", *summary_head()), rows)


def write_adaptations(path: Path, effects: Mapping[str, Effect]) -> None:
    rows = [
        [name, *list_summary(e.cut), e.trees, e.grows, e.turn, e.metamers, e.whole, e.uncut]
        for name, e in effects.items()
    ]
    regrowth = ("cut_above_bud", "grows_on", "turn", "regrown_metamers", "whole_metamers", "uncut_metamers")
    write_table(path, ("adaptation", *summary_head(), *regrowth), rows)


def write_growth(path: Path, curves: Mapping[str, Curve]) -> None:
    """Writes one row per set and iteration."""
    columns = [field.name for field in fields(Curve)]
    rows = [
        [name, iteration, *(float(getattr(curve, column)[iteration]) for column in columns)]
        for name, curve in curves.items()
        for iteration in range(len(curve.metamers))
    ]
    write_table(path, ("set", "iteration", *columns), rows)


def write_lambda(path: Path, habits: Mapping[str, Mapping[float, Habit]]) -> None:
    columns = [field.name for field in fields(Habit)]
    rows = [
        [name, value, *(float(getattr(habit, column)) for column in columns)]
        for name, of_set in habits.items()
        for value, habit in of_set.items()
    ]
    write_table(path, ("set", "lambda", *columns), rows)


def print_summary(name: str, trees: Summary) -> None:
    """Prints one line."""
    laterals = "  ".join(f"{pair.uncut:.2f}→{pair.cut:.2f}" for pair in trees.laterals)
    print(
        f"{name:<38} {trees.trees:4}  {trees.total.uncut:6.2f}→{trees.total.cut:6.2f} {100 * trees.fall:5.1f} %  "
        f"{trees.leader:5.2f} {100 * trees.leader_share:5.1f} %  {100 * trees.all_rise:3.0f} %   {laterals}"
    )


def print_effect(name: str, effect: Effect) -> None:
    """Prints one line."""
    print(
        f"{name:<38} {100 * effect.grows:5.0f} %  {effect.turn:5.1f}°  {effect.metamers:6.1f}  "
        f"{effect.whole:6.1f} of {effect.uncut:.1f}"
    )


def run_study(folder: Path, seeds: int) -> None:
    """Grows all trees, writes all files and prints the means."""
    from cut_study.figures import draw_figures  # slow to import, so not needed for --help
    from cut_study.pictures import draw_trees

    folder.mkdir(parents=True, exist_ok=True)
    readings = {reading: compare_cuts(SLIM, range(seeds), reading) for reading in READINGS}
    effects = {name: study_adaptation(settings, range(seeds)) for name, settings in ADAPTATIONS.items()}
    grown = range(min(seeds, GROWTH_SEEDS))
    curves = {name: follow_growth(settings, grown) for name, settings in SETS.items()}
    habits = {name: vary_lambda(SETS[name], LAMBDAS, grown) for name in LAMBDA_SETS}
    trees = readings[READINGS[0]]
    findings = [*check_cuts(trees), *check_adaptations(effects), *check_growth(curves), *check_lambda(habits)]

    write_cuts(folder / "cuts.csv", trees)
    write_readings(folder / "readings.csv", readings)
    write_adaptations(folder / "adaptations.csv", effects)
    write_growth(folder / "growth.csv", curves)
    write_lambda(folder / "lambda.csv", habits)
    trials = study_trials(range(seeds))
    write_table(folder / "trials.csv", (field.name for field in fields(Trial)), (astuple(trial) for trial in trials))
    write_findings(folder / "expectations.csv", findings)
    draw_figures(folder, trees, effects, curves, habits)
    draw_trees(folder / "trees.png")

    print("                                      trees  total           fall     leader         all rise  laterals")
    print_summary("published", summarize([PUBLISHED]))
    for reading, of_reading in readings.items():
        print_summary(reading.name, summarize(of_reading))
    print_summary("  of these branched as published", summarize([tree for tree in trees if tree.is_alike]))
    print("\nadaptations")
    for name, effect in effects.items():
        print_summary(name, effect.cut)
    print("\ncut above a bud                         grows on  turn  regrown  metamers of the tree")
    for name, effect in effects.items():
        print_effect(name, effect)
    print(f"\nexpected of means over {SEEDS} seeds; these are over {seeds}:")
    print_findings(findings)


def main() -> int:
    parser = argparse.ArgumentParser(description="Cuts the leaders of trees, compares what they divide, draws it.")
    parser.add_argument("-o", "--output", type=Path, default=Path("out/cut-study"), metavar="DIR", help="for files")
    parser.add_argument(
        "--seeds", type=positive_number, default=SEEDS, metavar="N", help=f"trees for each mean ({SEEDS})"
    )
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
