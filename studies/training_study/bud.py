# SPDX-License-Identifier: Apache-2.0
"""The direction of a branch that is cut back to a bud that faces down.

Based on: J. Stevens, Automatische generatie van gesnoeide boom modellen, Universiteit Hasselt 2023, figure 5.3: one
branch cut above its fourth metamer. From there to the seventh metamer it was about 20 degrees lower than without the
cut, and from its base about 8 degrees.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Sequence

import meristem
import numpy as np
from numpy.typing import NDArray

from cut_study.trees import change

from .trees import SETS, find_children, grow_skeleton, incline

CUT_AT = 10
MOST_LATER = 6  #: iterations until the branch has grown again
REGROWN = 3  #: metamers above the cut
TAKEOVER = 0.4
SHORTEST, LONGEST = 6, 9  #: metamers of a branch that is cut, so that the cut is near the fourth, as in the source


@dataclass(frozen=True)
class Branch:
    """One branch with the cut and without it; angles are in degrees above the horizontal."""

    set: str
    seed: int
    shoot: str
    above: int  #: metamers left by the cut
    stretch: float  #: from the cut to the third metamer above it, without the cut
    stretch_cut: float
    whole: float  #: from the branch's base to that metamer, without the cut
    whole_cut: float


def fitting_branches(skeleton: meristem.Skeleton) -> list[str]:
    """Returns the labels of branches on the stem with about the length of the source's, from the base."""
    found = []
    metamer, labels = skeleton["metamer"], skeleton.labels
    for axis in np.unique(skeleton.axis[skeleton.order == 1]):
        nodes = np.flatnonzero(skeleton.axis == axis)
        if SHORTEST <= metamer[nodes].max() <= LONGEST:
            found.append(labels[axis])
    return found


def follow(skeleton: meristem.Skeleton, node: int, count: int) -> list[int] | None:
    """Returns the nodes that continue from one: along its axis, or along the lateral if the axis is cut."""
    children, way = find_children(skeleton), []
    for _ in range(count):
        ahead = children.get(node, [])
        own = [child for child in ahead if skeleton.axis[child] == skeleton.axis[node]]
        if not ahead:
            return None
        node = own[0] if own else ahead[0]
        way.append(node)
    return way


def nodes_of(skeleton: meristem.Skeleton, label: str) -> NDArray[np.int64]:
    axis = list(skeleton.labels).index(label)
    return np.flatnonzero(skeleton.axis == axis)


def study_branch(name: str, seed: int, label: str) -> Branch | None:
    settings = change(SETS[name], takeover=TAKEOVER)
    cut = [{"do": "cut", "at": CUT_AT, "shoots": label, "to_bud": "down"}]
    try:
        after = grow_skeleton(settings, CUT_AT, seed, cut)
    except meristem.InputError:
        return None  # none of its buds faces down
    above = len(nodes_of(after, label))
    for later in range(1, MOST_LATER + 1):
        tree = grow_skeleton(settings, CUT_AT + later, seed, cut)
        way = follow(tree, int(nodes_of(tree, label)[above - 1]), REGROWN)
        if way is None or tree.axis[way[0]] == tree.axis[nodes_of(tree, label)[0]]:
            continue
        uncut = grow_skeleton(settings, CUT_AT + later, seed)
        own = nodes_of(uncut, label)
        if len(own) < above + REGROWN:
            return None
        base = uncut.position[uncut.parent[own[0]]]
        here, there = uncut.position[own[above - 1]], uncut.position[own[above - 1 + REGROWN]]
        end = tree.position[way[-1]]
        stump = tree.position[nodes_of(tree, label)[above - 1]]
        return Branch(
            name, seed, label, above, incline(there - here), incline(end - stump), incline(there - base), incline(end - base)
        )
    return None


def study_buds(seeds: Sequence[int]) -> list[Branch]:
    """Returns all branches of such a length that grow again."""
    found = []
    for name in SETS:
        for seed in seeds:
            tree = grow_skeleton(SETS[name], CUT_AT, seed)
            for label in fitting_branches(tree):
                branch = study_branch(name, seed, label)
                if branch is not None:
                    found.append(branch)
    return found
