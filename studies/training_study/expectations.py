# SPDX-License-Identifier: Apache-2.0
"""The expectations of the study, and whether they hold."""

from __future__ import annotations

from typing import Sequence

import numpy as np

from common.tables import Finding

from .bud import Branch
from .cordon import Cordon, mean_of
from .espalier import ARM, LAYERS, VIGOROUS_UPKEEP, Arms, Held, Upkeep, metamers_at
from .pole import Stem, mean_distance
from .trees import SETS
from .vase import CUT_AT, Vase


def check_range(what: str, found: float, low: float, high: float, unit: str = "") -> Finding:
    return Finding(what, f"{low:g} to {high:g}{unit}", f"{found:.3g}{unit}", low <= found <= high)


def check_most(what: str, found: float, most: float, unit: str = "") -> Finding:
    return Finding(what, f"at most {most:g}{unit}", f"{found:.3g}{unit}", found <= most)


def check_least(what: str, found: float, least: float, unit: str = "") -> Finding:
    return Finding(what, f"at least {least:g}{unit}", f"{found:.3g}{unit}", found >= least)


def check_poles(stems: Sequence[Stem]) -> list[Finding]:
    findings = []
    for name in SETS:
        free = mean_distance(stems, name, 0)
        for weight, share in ((1, 0.5), (4, 0.25)):
            what = f"{name} set: mean distance at weight {weight} over that without a pole"
            findings.append(check_most(what, mean_distance(stems, name, weight) / free, share))
    return findings


def check_vases(vases: Sequence[Vase]) -> list[Finding]:
    findings = []
    for at in CUT_AT:
        own = [vase for vase in vases if vase.cut_at == at]
        fall = 100 * float(1 - np.mean([v.height_cut for v in own]) / np.mean([v.height for v in own]))
        findings.append(check_range(f"cut at {at}: the mean height is less by", fall, 5, 15, " %"))
        share, share_cut = (float(np.mean([getattr(v, c) for v in own])) for c in ("share", "share_cut"))
        findings.append(check_least(f"cut at {at}: share of the largest arm without the cut", share, 0.8))
        findings.append(check_most(f"cut at {at}: share of the largest arm", share_cut, 0.7))
    return findings


def check_buds(branches: Sequence[Branch]) -> list[Finding]:
    stretch = [b.stretch - b.stretch_cut for b in branches]
    whole = [b.whole - b.whole_cut for b in branches]
    lower = 100 * float(np.mean([fall > 0 for fall in stretch]))
    return [
        check_range("cut to a bud: the regrown stretch is lower by", float(np.mean(stretch)), 12, 28, "°"),
        check_range("cut to a bud: the branch is lower by", float(np.mean(whole)), 4, 11, "°"),
        check_least("cut to a bud: branches whose regrown stretch is lower", lower, 95, " %"),
    ]


def check_espaliers(
    arms: Sequence[Arms], vigorous: Sequence[Arms], upkeep: Sequence[Upkeep], held: Sequence[Held]
) -> list[Finding]:
    two = 100 * float(np.mean([a.left == LAYERS and a.right == LAYERS for a in arms]))
    both = 100 * float(np.mean([a.left == LAYERS and a.right == LAYERS for a in vigorous]))
    at_15, at_17, at_25 = (metamers_at(upkeep, "spurs and limit", k) for k in (15, 17, 25))
    grown_15, grown_25 = (metamers_at(upkeep, VIGOROUS_UPKEEP, k) for k in (15, 25))
    return [
        check_least("espalier: trees with two arms in each layer at 15", two, 100, " %"),
        check_most("espalier: the largest inclination of an arm", max(a.inclination for a in arms), 7, "°"),
        check_most("espalier: the farthest turn of an arm from the wires' plane", max(a.off_plane for a in arms), 3, "°"),
        check_most("espalier: change of the metamers from 15 to 25", 100 * abs(at_25 / at_15 - 1), 10, " %"),
        check_most("espalier: change of the metamers from 17 to 25", 100 * abs(at_25 / at_17 - 1), 10, " %"),
        check_least("espalier with alpha 2.45: trees with two arms in each layer at 15", both, 100, " %"),
        check_most("espalier with alpha 2.45: the largest inclination of an arm", max(a.inclination for a in vigorous), 7, "°"),
        check_most("espalier with alpha 2.45: the farthest turn of an arm from the wires' plane",
                   max(a.off_plane for a in vigorous), 3, "°"),
        check_most("espalier with alpha 2.45: change of the metamers from 15 to 25",
                   100 * abs(grown_25 / grown_15 - 1), 10, " %"),
        check_most("espalier with alpha 2.45: largest change of the metamers of a tree from 15 to 25",
                   max(100 * abs(tree.at_25 / tree.at_15 - 1) for tree in held), 10, " %"),
        check_most("espalier with alpha 2.45: metamers of the longest arm from 15 to 25",
                   max(tree.longest_arm for tree in held), ARM),
        check_least("cutting each shoot alone: metamers at 25 over those at 15",
                    metamers_at(upkeep, "shoots cut to 2", 25) / metamers_at(upkeep, "shoots cut to 2", 15), 2),
    ]  # fmt: skip


def check_cordons(cordons: Sequence[Cordon]) -> list[Finding]:
    above, along = (mean_of(cordons, light, "metamers") for light in ("shade from above", "shade along the light"))
    branches, among_markers = (mean_of(cordons, light, "branches") for light in ("shade from above", "markers"))
    below = mean_of(cordons, "markers", "below") / among_markers
    return [
        check_least("cordon: metamers on branches with shade along the light, over shade from above", along / above, 1.3),
        check_least("cordon: branches with markers, over shade from above", among_markers / branches, 1.3),
        check_least("cordon: share of the branches with markers that stand below", below, 0.4),
    ]
