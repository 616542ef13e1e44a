# SPDX-License-Identifier: Apache-2.0
"""Grows self-organizing trees with or without a cut, with access to the metamers of their stems."""

from __future__ import annotations

from typing import Any, Mapping, NamedTuple

import meristem
import numpy as np
from numpy.typing import NDArray

Settings = Mapping[str, Any]  #: parameters of the component `organize`

LENGTH = 0.1  #: of a metamer, metres
SLIM: Settings = {"length": LENGTH, "resource": {"alpha": 1.8, "lambda": 0.52}}
FULL: Settings = {"length": LENGTH, "resource": {"alpha": 2.0, "lambda": 0.52}}
MARKERS: Settings = {
    "length": LENGTH,
    "resource": {"alpha": 1.8, "lambda": 0.52},
    "light": {"model": "markers"},
    "direction": {"persistence": 0.55, "light": 0.3, "up": 0.15, "up_fade": 0.9},
}

GROWN, DAMAGED = 1, 2  #: states of buds


class Cut(NamedTuple):
    """A cut that removes the stem above a metamer."""

    at: int  #: iteration after whose growth it is made
    above: int  #: number of the metamer on the stem


class Tree:
    """A grown tree. Metamers of its stem are numbered from 1 at the base."""

    def __init__(self, skeleton: meristem.Skeleton) -> None:
        self.skeleton = skeleton
        self.resource: NDArray[np.float32] = skeleton["resource"]
        self.lateral_resource: NDArray[np.float32] = skeleton["lateral_resource"]
        #: The node of each metamer of the stem, by number; number 0 is the root.
        self.stem = np.flatnonzero(skeleton.axis == skeleton.axis[0])

    @property
    def total(self) -> float:
        """The resource that the whole tree divides in the next iteration."""
        return float(self.resource[0])

    @property
    def last(self) -> int:
        """The number of the stem's topmost metamer."""
        return len(self.stem) - 1

    def branched(self) -> list[int]:
        """Returns the metamers of the stem whose lateral buds have grown, from the base."""
        return [int(number) for number in np.flatnonzero(self.skeleton["lateral_bud"][self.stem] == GROWN)]

    def leader_resource(self, above: int) -> float:
        """Returns the resource of everything that a cut above the metamer would remove."""
        return float(self.resource[self.stem[above + 1]])

    def side_resource(self, number: int) -> float:
        """Returns the resource of the lateral bud or branch at a metamer of the stem."""
        return float(self.lateral_resource[self.stem[number]])

    def heading(self, node: int) -> NDArray[np.float64]:
        """Returns the unit vector along a metamer, to its tip."""
        way = self.skeleton.position[node].astype(float) - self.skeleton.position[self.skeleton.parent[node]]
        return np.asarray(way / np.linalg.norm(way))

    def successor(self, number: int) -> int | None:
        """Returns the node that continues from a metamer of the stem: from the terminal bud, else from the lateral
        one."""
        children = np.flatnonzero(self.skeleton.parent == self.stem[number])
        if len(children) == 0:
            return None
        on_stem = self.skeleton.axis[children] == self.skeleton.axis[0]
        return int(children[on_stem][0] if on_stem.any() else children[0])

    def beyond(self, node: int) -> int:
        """Returns the number of metamers of a node's shoot with everything that it bears, including the node."""
        marked = np.zeros(len(self.skeleton), bool)
        marked[node] = True
        for later in range(node + 1, len(self.skeleton)):  # parents come first
            marked[later] = marked[self.skeleton.parent[later]]
        return int(marked.sum())


def grow_tree(settings: Settings, iterations: int, seed: int, cut: Cut | None = None) -> Tree:
    """Grows a single tree without obstacles. Equal arguments give equal trees."""
    return Tree(make_document(settings, iterations, seed, cut).grow(threads=1).stems[0].skeleton)


def make_document(settings: Settings, iterations: int, seed: int, cut: Cut | None = None) -> meristem.Document:
    """Returns the document of such a tree, for drawing or saving."""
    operations = [] if cut is None else [{"at": cut.at, "do": "cut", "shoots": "main", "above": cut.above}]
    tree = {"type": "organize", **settings, "iterations": iterations, "operations": operations}
    return meristem.Document({"meristem": 1, "components": {"tree": tree}}, seed=seed)


def change(settings: Settings, **changes: Any) -> Settings:
    """Returns the settings with changed parameters. Groups such as `resource` are changed key by key."""
    changed = dict(settings)
    for name, value in changes.items():
        old = changed.get(name)
        changed[name] = {**old, **value} if isinstance(old, Mapping) and isinstance(value, Mapping) else value
    return changed
