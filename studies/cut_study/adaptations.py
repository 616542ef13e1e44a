# SPDX-License-Identifier: Apache-2.0
"""What a cut does where one of the model's three adaptations to pruning is off.

Two cuts are made after iteration 8, each in a tree of its own: just above the topmost lateral branch, for what the tree
divides; and just above the topmost dormant bud, for what grows in the leader's place.
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
REGROWTH = 6  #: iterations after the cut until what has grown again is counted


@dataclass(frozen=True)
class Regrowth:
    """What grows in the place of a leader cut just above a dormant bud."""

    seed: int
    grows: bool  #: whether anything does
    turn: float  #: degrees from the leader's direction to the first metamer that leads on; NaN if none does
    metamers: int  #: of the shoot that leads on, with all that it bears
    whole: int  #: metamers of the whole tree
    uncut: int  #: the same without the cut


@dataclass(frozen=True)
class Effect:
    """Means over trees."""

    cut: Summary  #: just above the topmost branch
    trees: int  #: that were cut above a bud
    grows: float  #: share of them
    turn: float  #: degrees
    metamers: float
    whole: float
    uncut: float


def find_bud_cut(settings: Settings, seed: int) -> Cut | None:
    """Just above the topmost dormant bud beside which the leader has grown on; nothing where there is none."""
    tree = grow_tree(settings, READING.cut_at, seed)
    branched = set(tree.branched())
    dormant = [number for number in range(1, tree.last) if number not in branched]
    return Cut(READING.cut_at, dormant[-1]) if dormant else None


def measure_turn(tree: Tree, cut: Cut, leads_on: int) -> float:
    """Degrees from the metamer below the cut, which is where the leader was going, to the one that leads on."""
    cosine = float(tree.heading(int(tree.stem[cut.above])) @ tree.heading(leads_on))
    return float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))


def regrow(settings: Settings, seed: int) -> Regrowth | None:
    """Cuts the leader above a bud and sees what grows in its place; nothing where there is no such bud."""
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
