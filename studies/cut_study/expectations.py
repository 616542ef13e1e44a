# SPDX-License-Identifier: Apache-2.0
"""The expectations of the study, and whether they hold."""

from __future__ import annotations

from typing import Mapping, Sequence

import numpy as np

from common.tables import Finding

from .adaptations import Effect
from .cuts import FALL, LEADER_SHARE, PUBLISHED, CutTree, Summary, is_within, summarize
from .growth import TRIAL, Curve, Habit

NEAR_PUBLISHED = 0.35  #: largest difference from the published total and leader, as a share
FALL_IN = 0.95  #: share of trees
ALL_RISE_IN = 0.90  #: share of trees
NEAR_TRIAL = 0.25  #: largest difference from the trial's number of metamers, as a share


def check_near(what: str, found: float, published: float, limit: float) -> Finding:
    return Finding(
        what,
        f"{published:g} ± {100 * limit:.0f} %",
        f"{found:.2f} ({100 * (found / published - 1):+.0f} %)",
        abs(found / published - 1) <= limit,
    )


def check_share(what: str, found: float, least: float) -> Finding:
    return Finding(what, f"in at least {100 * least:.0f} %", f"in {100 * found:.1f} %", found >= least)


def check_fall(trees: Summary, which: str) -> Finding:
    what = f"{which}: total falls by {100 * FALL[0]:.0f} to {100 * FALL[1]:.0f} %"
    return check_share(what, trees.fall_holds, FALL_IN)


def check_cuts(trees: Sequence[CutTree]) -> list[Finding]:
    every = summarize(trees)
    findings = [
        check_near("mean total without the cut", every.total.uncut, PUBLISHED.total.uncut, NEAR_PUBLISHED),
        check_near("mean total with the cut", every.total.cut, PUBLISHED.total.cut, NEAR_PUBLISHED),
        check_near("mean of the leader", every.leader, PUBLISHED.leader, NEAR_PUBLISHED),
        Finding(
            "mean share of the leader",
            f"{100 * LEADER_SHARE[0]:.0f} to {100 * LEADER_SHARE[1]:.0f} %",
            f"{100 * every.leader_share:.1f} %",
            is_within(every.leader_share, LEADER_SHARE),
        ),
        check_fall(every, "all trees"),
        check_share("all trees: all laterals rise", every.all_rise, ALL_RISE_IN),
    ]
    alike = [tree for tree in trees if tree.is_alike]
    if alike:
        findings.append(check_fall(summarize(alike), "trees branched as the published one"))
    return findings


def check_adaptations(effects: Mapping[str, Effect]) -> list[Finding]:
    """Disabling an adaptation must worsen the property that it serves."""
    on = effects["all on"]
    passed, damage = effects["nothing passed back"], effects["cut buds grow again"]
    open_laterals, turn = effects["laterals open as terminals"], effects["no turn to the leader"]
    comparisons = (
        ("trees in which a cut shoot grows on: nothing passed back", passed.grows, on.grows, False),
        ("trees in which all laterals rise: cut buds grow again", damage.cut.all_rise, on.cut.all_rise, False),
        ("fall of the total: cut buds grow again", damage.cut.fall, on.cut.fall, False),
        ("metamers: laterals open as terminals", open_laterals.uncut, on.uncut, True),
        ("turn of what leads on: no turn to the leader", turn.turn, on.turn, True),
    )
    return [
        Finding(
            what,
            f"{'above' if rises else 'below'} {value_on:.3g}",
            f"{value_off:.3g}",
            value_off > value_on if rises else value_off < value_on,
        )
        for what, value_off, value_on, rises in comparisons
    ]


def check_growth(curves: Mapping[str, Curve]) -> list[Finding]:
    """Metamers and heights must agree with the trial."""
    findings = []
    for name, trials in TRIAL.items():
        for trial in trials:
            curve, at = curves[name], f"{name} set after {trial.iteration}"
            findings.append(
                check_near(f"{at}: metamers", float(curve.metamers[trial.iteration]), trial.metamers, NEAR_TRIAL)
            )
            if trial.height is not None:
                height = float(curve.height[trial.iteration])
                findings.append(check_near(f"{at}: height", height, trial.height, NEAR_TRIAL))
    return findings


def check_lambda(habits: Mapping[str, Mapping[float, Habit]]) -> list[Finding]:
    """A larger lambda must make trees taller."""
    findings = []
    for name, of_set in habits.items():
        heights = [of_set[value].height for value in sorted(of_set)]
        rises = bool(np.all(np.diff(heights) > 0))
        found = f"{heights[0]:.1f} to {heights[-1]:.1f} metamers, {'always' if rises else 'not always'} rising"
        findings.append(Finding(f"{name} set: height over lambda", "rises", found, rises))
    return findings
