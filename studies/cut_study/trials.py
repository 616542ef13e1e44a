# SPDX-License-Identifier: Apache-2.0
"""Other settings of the tree of table 5.1, to find why its laterals 3 and 5 have more resource in the source."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Mapping, Sequence

import numpy as np

from .cuts import compare_cuts
from .trees import FULL, SLIM, Settings, change

TRIALS: Mapping[str, Settings] = {
    "as on this page": SLIM,
    "less shade: a 0.1": change(SLIM, light={"a": 0.1}),
    "shade that fades sooner: b 3": change(SLIM, light={"b": 3}),
    "less shade below: depth 2": change(SLIM, light={"depth": 2}),
    "wider branches: branching_angle 70": change(SLIM, branching_angle=70),
    "more for the terminal side: lambda 0.53": change(SLIM, resource={"lambda": 0.53}),
    "longer shoots: stretch": change(SLIM, stretch=True),
    "more resource: alpha 2.0": FULL,
}


@dataclass(frozen=True)
class Trial:
    """Means over the trees that branch as the published tree does, without the cut."""

    settings: str
    trees: int  #: that branch as the published tree does
    total: float
    lateral_1: float
    lateral_3: float
    lateral_5: float
    largest_3: float  #: largest lateral 3 of a single tree


def study_trials(seeds: Sequence[int]) -> list[Trial]:
    found = []
    for name, settings in TRIALS.items():
        trees = [tree for tree in compare_cuts(settings, seeds) if tree.is_alike]
        laterals = np.array([[pair.uncut for pair in tree.laterals] for tree in trees])
        means = laterals.mean(axis=0)
        total = float(np.mean([tree.total.uncut for tree in trees]))
        lateral_1, lateral_3, lateral_5 = (float(means[k]) for k in (0, 2, 4))
        found.append(Trial(name, len(trees), total, lateral_1, lateral_3, lateral_5, float(laterals[:, 2].max())))
    return found
