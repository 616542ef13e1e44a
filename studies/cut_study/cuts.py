# SPDX-License-Identifier: Apache-2.0
"""The division of resource with and without a cut of the leader.

Based on: J. Stevens, Automatische generatie van gesnoeide boom modellen, Universiteit Hasselt 2023, section 5.2 with
table 5.1. The source does not specify when resources are read, which lateral is the topmost, and whether dormant buds
count among the five below the cut. A Reading defines these choices.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, NamedTuple, Sequence

import numpy as np

from .trees import Cut, Settings, Tree, grow_tree

LATERALS = 5  #: number of laterals below the cut that are compared


class Pair(NamedTuple):
    """A resource without the cut and with it."""

    uncut: float
    cut: float

    @property
    def gain(self) -> float:
        return self.cut - self.uncut


@dataclass(frozen=True)
class Reading:
    """One interpretation of the source."""

    name: str
    cut_at: int  #: iteration after whose growth the cut is made
    seen_after: int  #: iteration after whose growth resources of the next iteration are read
    branched_before: int  #: number of iterations before the cut in which the topmost lateral must already have branched
    counts_buds: bool  #: true: dormant buds count among the laterals below the cut; false: only branches do


READING = Reading("as in the text", 8, 9, 0, True)
READINGS = (
    READING,
    Reading("five branches", 8, 9, 0, False),
    Reading("lateral an iteration older", 8, 9, 1, True),
    Reading("read before growth 9", 8, 8, 0, True),
    Reading("cut at 9", 9, 9, 0, True),
    Reading("cut at 9, lateral an iteration older", 9, 9, 1, True),
)


@dataclass(frozen=True)
class CutTree:
    """A tree with the cut and without it."""

    seed: int
    above: int  #: number of the metamer above which the leader was cut
    branches: str  #: laterals below the cut at that time, from the top: 1 for a branch, 0 for a dormant bud
    total: Pair
    leader: float  #: resource of the removed part
    laterals: tuple[Pair, ...]  #: laterals below the cut, from the top; LATERALS of them, or fewer if there are fewer
    opens: tuple[bool, ...]  #: for each lateral, true if it grows only because of the cut

    @property
    def fall(self) -> float:
        """The fall of the total as a share of the total."""
        return -self.total.gain / self.total.uncut

    @property
    def leader_share(self) -> float:
        return self.leader / self.total.uncut

    @property
    def all_rise(self) -> bool:
        return all(pair.gain > 0 for pair in self.laterals)

    @property
    def is_alike(self) -> bool:
        """True if branches and buds alternate, as in the published tree."""
        return self.branches == "10101"


#: Table 5.1 of the source.
PUBLISHED = CutTree(
    seed=0,
    above=0,
    branches="10101",
    total=Pair(41.620, 35.590),
    leader=11.708,
    laterals=(Pair(5.176, 7.431), Pair(1.284, 2.152), Pair(8.234, 9.556), Pair(0.791, 1.088), Pair(7.935, 8.719)),
    opens=(False, True, False, False, False),
)


def branched_by(tree: Tree, iteration: int) -> list[int]:
    """Returns the metamers of the stem whose lateral buds had grown after that iteration, from the base."""
    skeleton = tree.skeleton
    lateral = (skeleton.axis != skeleton.axis[0]) & (skeleton.order == 1) & (skeleton.birth <= iteration)
    parents = set(skeleton.parent[lateral].tolist())
    return [number for number in tree.branched() if int(tree.stem[number]) in parents]


def find_cut(settings: Settings, seed: int, reading: Reading = READING) -> Cut | None:
    """Returns the cut just above the topmost lateral branch. None if there is no branch or nothing above it."""
    tree = grow_tree(settings, reading.cut_at, seed)
    branched = branched_by(tree, reading.cut_at - reading.branched_before)
    if not branched or branched[-1] >= tree.last:
        return None
    return Cut(reading.cut_at, branched[-1])


def compare_cut(settings: Settings, seed: int, reading: Reading = READING) -> CutTree | None:
    """Returns a tree with and without the cut of its leader, or None if no cut is possible."""
    cut = find_cut(settings, seed, reading)
    if cut is None:
        return None
    before = set(grow_tree(settings, cut.at, seed).branched())
    uncut = grow_tree(settings, reading.seen_after, seed)
    tree = grow_tree(settings, reading.seen_after, seed, cut)
    numbers = [number for number in range(cut.above, 0, -1) if reading.counts_buds or number in before][:LATERALS]
    grown_by_cut = set(tree.branched()) - set(uncut.branched())
    return CutTree(
        seed,
        cut.above,
        "".join("1" if number in before else "0" for number in numbers),
        Pair(uncut.total, tree.total),
        uncut.leader_resource(cut.above),
        tuple(Pair(uncut.side_resource(number), tree.side_resource(number)) for number in numbers),
        tuple(number in grown_by_cut for number in numbers),
    )


def compare_cuts(settings: Settings, seeds: Sequence[int], reading: Reading = READING) -> list[CutTree]:
    """Returns all trees whose leader can be cut."""
    trees = (compare_cut(settings, seed, reading) for seed in seeds)
    return [tree for tree in trees if tree is not None]


@dataclass(frozen=True)
class Summary:
    """Means over trees, and the share of trees with the expected trends."""

    trees: int
    alike: float  #: share of trees with branches and buds as in the published tree
    total: Pair
    fall: float
    fall_holds: float  #: share of trees whose total falls by FALL
    leader: float
    leader_share: float
    leader_holds: float  #: share of trees whose leader has LEADER_SHARE
    laterals: tuple[Pair, ...]
    all_rise: float  #: share of trees
    second_opens: float  #: share of trees in which the second lateral from the top grows only because of the cut


FALL = (0.08, 0.25)
LEADER_SHARE = (0.20, 0.35)


def is_within(value: float, limits: tuple[float, float]) -> bool:
    return limits[0] <= value <= limits[1]


def mean_pair(pairs: Sequence[Pair]) -> Pair:
    return Pair(float(np.mean([pair.uncut for pair in pairs])), float(np.mean([pair.cut for pair in pairs])))


def summarize(trees: Sequence[CutTree]) -> Summary:
    """Summarizes at least one tree. Means of laterals are over the trees that have them."""
    places = range(max(len(tree.laterals) for tree in trees))

    def share(holds: Callable[[CutTree], bool]) -> float:
        return float(np.mean([holds(tree) for tree in trees]))

    return Summary(
        trees=len(trees),
        alike=share(lambda tree: tree.is_alike),
        total=mean_pair([tree.total for tree in trees]),
        fall=float(np.mean([tree.fall for tree in trees])),
        fall_holds=share(lambda tree: is_within(tree.fall, FALL)),
        leader=float(np.mean([tree.leader for tree in trees])),
        leader_share=float(np.mean([tree.leader_share for tree in trees])),
        leader_holds=share(lambda tree: is_within(tree.leader_share, LEADER_SHARE)),
        laterals=tuple(mean_pair([tree.laterals[k] for tree in trees if len(tree.laterals) > k]) for k in places),
        all_rise=share(lambda tree: tree.all_rise),
        second_opens=share(lambda tree: len(tree.opens) > 1 and tree.opens[1]),
    )
