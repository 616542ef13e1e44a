# SPDX-License-Identifier: Apache-2.0
"""A cordon at 45 degrees in both models of light.

Based on: J. Stevens, Automatische generatie van gesnoeide boom modellen, Universiteit Hasselt 2023, figure 4.5. With
shade from vertically above, an inclined stem shades itself, branches poorly, and has no downward branches.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Sequence

import numpy as np

from cut_study.trees import MARKERS, change

from .trees import FULL, LENGTH, grow_skeleton

ITERATIONS = 12
REACH = 24  #: metamers of the stem
ANGLE = 45.0
LIGHTS: Mapping[str, tuple[Any, Any]] = {
    "shade from above": (change(FULL, light={"lean": 0}), None),
    "shade along the light": (FULL, {"sun": {"azimuth": 270, "altitude": 45}}),
    "markers": (MARKERS, None),
}
# The stem leans to the east. The light comes from the west, at a right angle to the stem.


@dataclass(frozen=True)
class Cordon:
    """One cordon before its spurs are cut."""

    light: str
    seed: int
    stem: int  #: metamers
    branches: int  #: on the stem
    below: int  #: branches on the lower side of the stem
    metamers: int  #: on branches
    gathered: float  #: light of all buds


def operations() -> list[dict[str, Any]]:
    along = REACH * LENGTH * np.sqrt(0.5)
    return [
        {"do": "support", "shoots": "leader", "line": [[0, 0, 0], [along, along, 0]]},
        {"do": "limit", "shoots": "rank == 0", "metamers": REACH},
    ]


def study_cordons(seeds: Sequence[int]) -> list[Cordon]:
    found = []
    under = np.array([1.0, -1.0, 0.0]) / np.sqrt(2)
    for light, (settings, scene) in LIGHTS.items():
        for seed in seeds:
            tree = grow_skeleton(settings, ITERATIONS, seed, operations(), scene=scene)
            rank, parent = tree["rank"], tree.parent.astype(np.int64)
            first = [node for node in range(1, len(tree)) if rank[node] == 1 and rank[parent[node]] == 0]
            tips = {node: node for node in first}
            for node in range(1, len(tree)):  # to the end of each branch
                if parent[node] in tips.values() and rank[node] == 1:
                    key = next(k for k, tip in tips.items() if tip == parent[node])
                    tips[key] = node
            ways = [tree.position[tip] - tree.position[parent[node]] for node, tip in tips.items()]
            below = sum(bool(way @ under > 0) for way in ways)
            found.append(Cordon(light, seed, int((rank[1:] == 0).sum()), len(first), below,
                                int((rank > 0).sum()), float(tree["light"][0])))  # fmt: skip
    return found


def mean_of(cordons: Sequence[Cordon], light: str, column: str) -> float:
    return float(np.mean([getattr(cordon, column) for cordon in cordons if cordon.light == light]))
