# SPDX-License-Identifier: Apache-2.0
"""Grows trees with operations and trainings, and measures them by their nodes."""

from __future__ import annotations

from typing import Any, Mapping, Sequence

import meristem
import numpy as np
from numpy.typing import NDArray

from cut_study.trees import FULL, LENGTH, SLIM, Settings

SETS: Mapping[str, Settings] = {"slim": SLIM, "full": FULL}
Operations = Sequence[Mapping[str, Any]]


def make_document(
    settings: Settings,
    iterations: int,
    seed: int,
    operations: Operations = (),
    training: Mapping[str, Any] | None = None,
    scene: Mapping[str, Any] | None = None,
) -> meristem.Document:
    tree = {"type": "organize", **settings, "iterations": iterations, "operations": [dict(o) for o in operations]}
    if training is not None:
        tree["training"] = dict(training)
    document: dict[str, Any] = {"meristem": 1, "components": {"tree": tree}}
    if scene is not None:
        document["scene"] = dict(scene)
    return meristem.Document(document, seed=seed)


def grow_skeleton(settings: Settings, iterations: int, seed: int, operations: Operations = (), **more: Any) -> meristem.Skeleton:
    """Grows a single tree without obstacles. Equal arguments give equal trees."""
    return make_document(settings, iterations, seed, operations, **more).grow(threads=1).stems[0].skeleton


def count_metamers(skeleton: meristem.Skeleton) -> int:
    return len(skeleton) - 1


def count_beyond(skeleton: meristem.Skeleton) -> NDArray[np.int64]:
    """Returns the number of metamers that each node bears, including the node itself."""
    beyond = np.ones(len(skeleton), np.int64)
    parent = skeleton.parent.astype(np.int64)
    for node in range(len(skeleton) - 1, 0, -1):  # parents come first
        beyond[parent[node]] += beyond[node]
    return beyond


def find_children(skeleton: meristem.Skeleton) -> dict[int, list[int]]:
    children: dict[int, list[int]] = {}
    for node, parent in enumerate(skeleton.parent[1:].astype(np.int64), start=1):
        children.setdefault(int(parent), []).append(node)
    return children


def incline(way: NDArray[Any]) -> float:
    """Returns the degrees of a vector above the horizontal."""
    return float(np.degrees(np.arcsin(way[1] / np.linalg.norm(way))))


__all__ = [
    "FULL", "LENGTH", "SETS", "SLIM", "Operations", "Settings", "count_beyond", "count_metamers", "find_children",
    "grow_skeleton", "incline", "make_document",
]  # fmt: skip
