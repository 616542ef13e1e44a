# SPDX-License-Identifier: Apache-2.0
"""The effect of a cut if one of the model's three adaptations to pruning is disabled.

Two cuts are made after iteration 8, each in a separate tree. One is just above the topmost lateral branch and shows how
the tree divides resource. The other is just above the topmost dormant bud and shows what replaces the leader.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Mapping, Sequence

import numpy as np

from .cuts import READING, Summary, compare_cuts, summarize
from .trees import SLIM, Cut, Settings, Tree, change, grow_tree

ADAPTATIONS: Mapping[str, Settings] = {
    "all on": SLIM,
    "nothing passed back": change(SLIM, resource={"pass_back": 0}),
    "cut buds grow again": change(SLIM, damage=False),
    "laterals open as terminals": change(SLIM, lateral_threshold=1, laterals_wait=False),
    "no turn to the leader": change(SLIM, takeover=0),
}
REGROWTH = 6  #: iterations after the cut until regrowth is counted


@dataclass(frozen=True)
class Regrowth:
    """The regrowth after the leader is cut just above a dormant bud."""

    seed: int
    grows: bool  #: true if anything has regrown
    turn: float  #: degrees from the leader's direction to the first metamer of its successor; NaN without one
    metamers: int  #: metamers of the succeeding shoot, with everything that it bears
    whole: int  #: metamers of the whole tree
    uncut: int  #: metamers of the whole tree without the cut


@dataclass(frozen=True)
class Effect:
    """Means over trees."""

    cut: Summary  #: just above the topmost branch
    trees: int  #: number of trees that were cut above a bud
    grows: float  #: share of these trees with regrowth
    turn: float  #: degrees
    metamers: float
    whole: float
    uncut: float


def find_bud_cut(settings: Settings, seed: int) -> Cut | None:
    """Returns the cut just above the topmost dormant bud below the leader's tip, or None without such a bud."""
    tree = grow_tree(settings, READING.cut_at, seed)
    branched = set(tree.branched())
    dormant = [number for number in range(1, tree.last) if number not in branched]
    return Cut(READING.cut_at, dormant[-1]) if dormant else None


def measure_turn(tree: Tree, cut: Cut, leads_on: int) -> float:
    """Returns the angle in degrees from the metamer below the cut, the leader's direction, to the succeeding
    metamer."""
    cosine = float(tree.heading(int(tree.stem[cut.above])) @ tree.heading(leads_on))
    return float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))


def regrow(settings: Settings, seed: int) -> Regrowth | None:
    """Cuts the leader above a bud and measures the regrowth. Returns None without such a bud."""
    cut = find_bud_cut(settings, seed)
    if cut is None:
        return None
    tree = grow_tree(settings, cut.at + REGROWTH, seed, cut)
    uncut = grow_tree(settings, cut.at + REGROWTH, seed)
    leads_on = tree.successor(cut.above)
    whole = len(tree.skeleton) - 1  # without the root
    if leads_on is None:
        return Regrowth(seed, False, float("nan"), 0, whole, len(uncut.skeleton) - 1)
    turn = measure_turn(tree, cut, leads_on)
    return Regrowth(seed, True, turn, tree.beyond(leads_on), whole, len(uncut.skeleton) - 1)


def study_adaptation(settings: Settings, seeds: Sequence[int]) -> Effect:
    found = [regrowth for seed in seeds if (regrowth := regrow(settings, seed)) is not None]
    grown = [regrowth for regrowth in found if regrowth.grows]
    return Effect(
        summarize(compare_cuts(settings, seeds)),
        len(found),
        len(grown) / len(found),
        float(np.mean([regrowth.turn for regrowth in grown])),
        float(np.mean([regrowth.metamers for regrowth in found])),
        float(np.mean([regrowth.whole for regrowth in found])),
        float(np.mean([regrowth.uncut for regrowth in found])),
    )
