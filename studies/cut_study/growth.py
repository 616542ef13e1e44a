# SPDX-License-Identifier: Apache-2.0
"""The growth of trees without cuts: over the iterations, and for different strengths of apical control."""

from __future__ import annotations

from dataclasses import astuple, dataclass
from typing import Mapping, NamedTuple, Sequence

import numpy as np
from numpy.typing import NDArray

from .trees import FULL, LENGTH, MARKERS, SLIM, Settings, Tree, change, grow_tree

Floats = NDArray[np.float64]

SETS: Mapping[str, Settings] = {"slim": SLIM, "full": FULL, "markers": MARKERS}
ITERATIONS = 25
LAMBDA_ITERATIONS = 18
LAMBDAS = tuple(round(0.01 * k, 2) for k in range(50, 59))


class Trial(NamedTuple):
    """Measures of the trial after some iterations, when the parameter sets were fixed."""

    iteration: int
    metamers: int
    height: float | None = None  #: metamers


#: Growth in the trial that fixed the sets. Heights are known for the slim set only.
TRIAL: Mapping[str, Sequence[Trial]] = {
    "slim": (Trial(9, 32, 12), Trial(18, 288, 30), Trial(25, 1080, 43)),
    "full": (Trial(9, 146), Trial(18, 1640), Trial(25, 6270)),
}


def count_metamers(tree: Tree, iterations: int) -> Floats:
    """Returns the number of metamers after each iteration from 0, (iterations + 1,), for a tree that loses none."""
    return np.array([np.count_nonzero(tree.skeleton.birth <= k) - 1 for k in range(iterations + 1)], float)


def follow_height(tree: Tree, iterations: int) -> Floats:
    """Returns the height after each iteration, in metamers."""
    births, heights = tree.skeleton.birth, tree.skeleton.position[:, 1] / LENGTH
    return np.array([heights[births <= k].max() for k in range(iterations + 1)], float)


@dataclass(frozen=True)
class Curve:
    """Means and spreads over seeds after each iteration from 0, each (iterations + 1,)."""

    metamers: Floats
    metamers_spread: Floats
    height: Floats  #: metamers
    height_spread: Floats


def follow_growth(settings: Settings, seeds: Sequence[int], iterations: int = ITERATIONS) -> Curve:
    trees = [grow_tree(settings, iterations, seed) for seed in seeds]
    metamers = np.array([count_metamers(tree, iterations) for tree in trees])
    heights = np.array([follow_height(tree, iterations) for tree in trees])
    return Curve(metamers.mean(0), metamers.std(0), heights.mean(0), heights.std(0))


@dataclass(frozen=True)
class Habit:
    """The habit of a tree, or its mean over trees."""

    metamers: float
    height: float  #: metamers
    spread: float  #: metamers; the largest distance from the vertical through the root
    order: float  #: mean over all metamers; 0 on the stem
    stem_share: float  #: share of all metamers

    @property
    def slenderness(self) -> float:
        return self.height / self.spread


def measure_habit(tree: Tree) -> Habit:
    skeleton = tree.skeleton
    aside = np.hypot(skeleton.position[:, 0], skeleton.position[:, 2])
    return Habit(
        metamers=len(skeleton) - 1.0,
        height=float(skeleton.position[:, 1].max()) / LENGTH,
        spread=float(aside.max()) / LENGTH,
        order=float(skeleton.order[1:].mean()),
        stem_share=tree.last / (len(skeleton) - 1),
    )


def vary_lambda(settings: Settings, lambdas: Sequence[float], seeds: Sequence[int]) -> dict[float, Habit]:
    """Returns mean habits after LAMBDA_ITERATIONS."""
    habits = {}
    for value in lambdas:
        varied = change(settings, resource={"lambda": value})
        found = [measure_habit(grow_tree(varied, LAMBDA_ITERATIONS, seed)) for seed in seeds]
        habits[value] = Habit(*np.mean([astuple(habit) for habit in found], axis=0).tolist())
    return habits
