# SPDX-License-Identifier: Apache-2.0
"""The espalier over the years: whether it has its arms, whether it is stable, and the effect of upkeep.

Based on: J. Stevens, Automatische generatie van gesnoeide boom modellen, Universiteit Hasselt 2023, section 4.3 and
figure 4.13, whose tree "stabilises after some iterations".
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Sequence

import meristem
import numpy as np

from cut_study.trees import change

from .trees import LENGTH, SLIM, count_metamers, grow_skeleton

LAYERS = 3
ESPALIER = change(SLIM, resource={"alpha": 2.3})
#: At 2.3, the arms of the third layer are complete at iteration 17 only; at 2.45, most are complete at 16.
VIGOROUS = change(SLIM, resource={"alpha": 2.45})
YEARS = tuple(range(1, 26))
SEEN = 15
SHORTEST = 6  #: smallest number of metamers of an arm that is counted and measured


@dataclass(frozen=True)
class Arms:
    """The arms of one espalier."""

    seed: int
    left: int
    right: int
    inclination: float  #: degrees; largest angle of an arm, from first metamer to tip, to the horizontal
    off_plane: float  #: degrees; largest angle of an arm to the plane of the wires


def arms_of(skeleton: meristem.Skeleton, seed: int) -> Arms:
    """Measures the arms: the shoots on the leader, with their successors."""
    rank, parent = skeleton["rank"], skeleton.parent.astype(np.int64)
    arm = np.zeros(len(skeleton), np.int64)  # the first node of the arm of each node
    for node in range(1, len(skeleton)):
        if rank[node] == 1:
            arm[node] = node if rank[parent[node]] == 0 else arm[parent[node]]
    left = right = 0
    inclination = off_plane = 0.0
    for first in np.unique(arm[arm > 0]):
        nodes = np.flatnonzero(arm == first)
        if len(nodes) < SHORTEST:
            continue
        way = skeleton.position[nodes[-1]].astype(float) - skeleton.position[nodes[0]]
        left, right = left + (way[0] < 0), right + (way[0] > 0)
        inclination = max(inclination, abs(float(np.degrees(np.arctan2(way[1], abs(way[0]))))))
        off_plane = max(off_plane, abs(float(np.degrees(np.arctan2(way[2], abs(way[0]))))))
    return Arms(seed, left, right, inclination, off_plane)


@dataclass(frozen=True)
class Upkeep:
    """One way of upkeep after one iteration; means over trees."""

    upkeep: str
    iteration: int
    metamers: float
    spread: float
    width: float  #: metres


def layers() -> list[dict[str, Any]]:
    top = LAYERS * 6 * LENGTH
    return [
        {"do": "support", "shoots": "leader", "line": [[0, 0, 0], [0, top, 0]]},
        {"do": "layers", "count": LAYERS, "metamers": 6},
    ]


#: Spurs with at most 2 metamers in all; single shoots cut back, as another reading of the source's text; no upkeep.
UPKEEP: Mapping[str, list[dict[str, Any]]] = {
    "spurs and limit": [{"do": "limit", "shoots": "rank == 1", "metamers": 12}, {"do": "spur", "metamers": 2}],
    "shoots cut to 2": [{"do": "cut", "shoots": "rank >= 2", "above": 2}],
    "none": [],
}
#: The first of these ways for the more vigorous tree.
VIGOROUS_UPKEEP = "spurs and limit, alpha 2.45"
LAST_OF_NONE = 16  #: without upkeep, the tree becomes too large to follow


def grow_espalier(seed: int, iterations: int, upkeep: str = "spurs and limit", settings: Any = ESPALIER) -> meristem.Skeleton:
    return grow_skeleton(settings, iterations, seed, [*layers(), *UPKEEP[upkeep]])


def study_arms(seeds: Sequence[int], settings: Any = ESPALIER) -> list[Arms]:
    return [arms_of(grow_espalier(seed, SEEN, settings=settings), seed) for seed in seeds]


def study_upkeep(seeds: Sequence[int]) -> list[Upkeep]:
    found = []
    ways = [*((name, name, ESPALIER) for name in UPKEEP), (VIGOROUS_UPKEEP, "spurs and limit", VIGOROUS)]
    for upkeep, operations, settings in ways:
        for iteration in YEARS:
            if upkeep == "none" and iteration > LAST_OF_NONE:
                continue
            trees = [grow_espalier(seed, iteration, operations, settings) for seed in seeds]
            metamers = [count_metamers(tree) for tree in trees]
            width = [float(np.ptp(tree.position[:, 0])) for tree in trees]
            found.append(Upkeep(upkeep, iteration, float(np.mean(metamers)), float(np.std(metamers)), float(np.mean(width))))
    return found


@dataclass(frozen=True)
class Held:
    """The size of one vigorous espalier over the years from SEEN on."""

    seed: int
    at_15: int  #: metamers
    at_25: int
    longest_arm: int  #: largest number of metamers of an arm at any of HELD_YEARS


HELD_YEARS = (SEEN, 17, 20, 25)
ARM = 12  #: largest number of metamers of an arm, by the limit of UPKEEP


def longest_arm(skeleton: meristem.Skeleton) -> int:
    rank, parent = skeleton["rank"], skeleton.parent.astype(np.int64)
    arm = np.zeros(len(skeleton), np.int64)
    for node in range(1, len(skeleton)):
        if rank[node] == 1:
            arm[node] = node if rank[parent[node]] == 0 else arm[parent[node]]
    return int(np.bincount(arm[arm > 0]).max())


def study_held(seeds: Sequence[int]) -> list[Held]:
    found = []
    for seed in seeds:
        trees = [grow_espalier(seed, year, settings=VIGOROUS) for year in HELD_YEARS]
        longest = max(longest_arm(tree) for tree in trees)
        found.append(Held(seed, count_metamers(trees[0]), count_metamers(trees[-1]), longest))
    return found


def metamers_at(upkeep: Sequence[Upkeep], name: str, iteration: int) -> float:
    return next(row.metamers for row in upkeep if row.upkeep == name and row.iteration == iteration)


#: The espalier without one of the model's adaptations to pruning.
ADAPTATIONS: Mapping[str, Any] = {
    "all on": ESPALIER,
    "cut buds grow again": change(ESPALIER, damage=False),
    "laterals open as terminals": change(ESPALIER, lateral_threshold=1, laterals_wait=False),
    "nothing passed back": change(ESPALIER, resource={"pass_back": 0}),
    "no turn to the leader": change(ESPALIER, takeover=0),
}


@dataclass(frozen=True)
class Broken:
    """The effect of an adaptation on the espalier; means over trees after SEEN iterations."""

    adaptation: str
    trees: int
    two_arms: float  #: share of trees with two arms in each layer
    metamers: float
    height: float  #: metres
    inclination: float  #: mean over trees of the largest inclination of an arm, degrees


def study_adaptations(seeds: Sequence[int]) -> list[Broken]:
    found = []
    for name, settings in ADAPTATIONS.items():
        trees = [grow_espalier(seed, SEEN, settings=settings) for seed in seeds]
        arms = [arms_of(tree, seed) for tree, seed in zip(trees, seeds)]
        found.append(
            Broken(
                name,
                len(trees),
                float(np.mean([a.left == LAYERS and a.right == LAYERS for a in arms])),
                float(np.mean([count_metamers(tree) for tree in trees])),
                float(np.mean([tree.position[:, 1].max() for tree in trees])),
                float(np.mean([a.inclination for a in arms])),
            )
        )
    return found
