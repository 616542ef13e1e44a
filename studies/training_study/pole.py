# SPDX-License-Identifier: Apache-2.0
"""How straight a pole keeps a stem.

Based on: J. Stevens, Automatische generatie van gesnoeide boom modellen, Universiteit Hasselt 2023, figures 4.11 and
5.1: one tree after 18 iterations, with a pole and without.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray

from .trees import LENGTH, SETS, grow_skeleton

ITERATIONS = 18
WEIGHTS = (0.0, 1.0, 4.0)  #: 0: no pole


@dataclass(frozen=True)
class Stem:
    """The distances of one stem from the vertical through its root."""

    set: str
    weight: float
    seed: int
    metamers: int
    mean: float  #: metamers
    largest: float  #: metamers


def pole_of(weight: float) -> list[dict[str, Any]]:
    return [] if weight == 0 else [{"do": "support", "shoots": "leader", "line": [[0, 0, 0], [0, 9, 0]], "weight": weight}]


def distances(name: str, weight: float, seed: int) -> NDArray[np.float64]:
    """Returns the distance of each metamer's end from this vertical, from the stem's base up, in metamers."""
    skeleton = grow_skeleton(SETS[name], ITERATIONS, seed, pole_of(weight))
    stem = np.flatnonzero(skeleton.axis == skeleton.axis[0])[1:]
    position = skeleton.position[stem].astype(float) - skeleton.position[0]
    return np.asarray(np.hypot(position[:, 0], position[:, 2]) / LENGTH)


def study_poles(seeds: Sequence[int]) -> list[Stem]:
    stems = []
    for name in SETS:
        for weight in WEIGHTS:
            for seed in seeds:
                away = distances(name, weight, seed)
                stems.append(Stem(name, weight, seed, len(away), float(away.mean()), float(away.max())))
    return stems


def mean_distance(stems: Sequence[Stem], name: str, weight: float) -> float:
    return float(np.mean([stem.mean for stem in stems if stem.set == name and stem.weight == weight]))
