# SPDX-License-Identifier: Apache-2.0
"""The growth of a tree whose leader is cut above its third branch.

Based on: J. Stevens, Automatische generatie van gesnoeide boom modellen, Universiteit Hasselt 2023, figure 4.12: one
tree cut after about 10 iterations and shown after 25, beside an equal tree without the cut.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

import meristem
import numpy as np

from .trees import LENGTH, SLIM, count_beyond, find_children, grow_skeleton

CUT_AT = (8, 9, 10)
SEEN = 25
BRANCH = 3  #: the cut is made above this branch


@dataclass(frozen=True)
class Vase:
    """A tree with the cut and without it."""

    cut_at: int
    seed: int
    height: float  #: metamers, without the cut
    height_cut: float
    share: float  #: share of the largest arm in all metamers; the leader above the cut counts as an arm
    share_cut: float

    @property
    def fall(self) -> float:
        return 1 - self.height_cut / self.height


def operations(cut_at: int) -> list[dict[str, Any]]:
    return [{"do": "cut", "at": cut_at, "shoots": "leader", "above_lateral": BRANCH, "leader": False}]


def find_stump(skeleton: meristem.Skeleton) -> int | None:
    """Returns the number of metamers of the stem left by the cut. None if no cut was made."""
    stem = np.flatnonzero(skeleton.axis == skeleton.axis[0])
    cut = skeleton["cut_at"][stem]
    return len(stem) - 1 if cut[-1] > 0 else None


def largest_share(skeleton: meristem.Skeleton, stump: int) -> float:
    """Returns the share of the largest arm in all arms on the stem up to the cut, including the leader above it."""
    stem = np.flatnonzero(skeleton.axis == skeleton.axis[0])
    beyond, children = count_beyond(skeleton), find_children(skeleton)
    below = set(stem[: stump + 1].tolist())
    arms = [beyond[child] for node in below for child in children.get(node, []) if child not in below]
    return float(max(arms) / sum(arms))


def study_vases(seeds: Sequence[int]) -> list[Vase]:
    """Returns all trees that have a third branch when they are cut."""
    vases = []
    for cut_at in CUT_AT:
        for seed in seeds:
            cut = grow_skeleton(SLIM, SEEN, seed, operations(cut_at))
            stump = find_stump(cut)
            if stump is None:
                continue
            uncut = grow_skeleton(SLIM, SEEN, seed)
            height, height_cut = (float(tree.position[:, 1].max()) / LENGTH for tree in (uncut, cut))
            shares = largest_share(uncut, stump), largest_share(cut, stump)
            vases.append(Vase(cut_at, seed, height, height_cut, shares[0], shares[1]))
    return vases
