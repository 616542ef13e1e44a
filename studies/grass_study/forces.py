# SPDX-License-Identifier: Apache-2.0
"""Plasticity: leaves in rising wind, and the load that gives a wanted turn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Sequence

import numpy as np
from meristem import grass

WINDS = (0.0, 0.2, 0.5, 1.0, 2.0, 4.0)  #: in weights of the leaf, toward its stem or away from it
STIFFNESSES = (0.1, 0.3, 1.0)
TURNS = (5.0, 10.0, 15.0, 20.0)  #: degrees down at PLACE
PLACE = 0.75  #: of the midrib
AGREES = 0.01


@dataclass(frozen=True)
class Turn:
    """A wanted turn, the load that gives it, and what the loaded leaf then does."""

    leaf: int
    wanted: float  #: degrees
    load: float  #: pull downward, in weights of the leaf; NaN where none gives it
    found: float  #: degrees; NaN likewise

    @property
    def error(self) -> float:
        return abs(self.found / self.wanted - 1)


def direction_at(leaf: grass.GrassLeaf, place: float) -> float:
    """Degrees, between those of the pieces about it."""
    middles = 0.5 * (leaf.s[1:] + leaf.s[:-1])
    return float(np.interp(place, middles, leaf.angles))


def tip_turns(leaf: grass.GrassLeaf, sign: int) -> dict[float, list[float]]:
    """The turns of the tip in each wind, in degrees, by stiffness."""
    last = leaf.angles[-1]
    return {
        stiffness: [
            float(grass.loaded(leaf, wind=(sign * wind, 0), stiffness=stiffness).angles[-1] - last) for wind in WINDS
        ]
        for stiffness in STIFFNESSES
    }


def find_turns(leaves: Sequence[grass.GrassLeaf]) -> list[Turn]:
    """The load for each of TURNS and each leaf, and the turn under that load."""
    turns = []
    for k, leaf in enumerate(leaves):
        for wanted in TURNS:
            try:
                load = grass.load_for_turn(leaf, PLACE, wanted, pull=(0, -1))
            except ValueError:
                turns.append(Turn(k, wanted, float("nan"), float("nan")))
                continue
            bent = grass.loaded(leaf, pull=(0, -load))
            turns.append(Turn(k, wanted, load, direction_at(bent, PLACE) - direction_at(leaf, PLACE)))
    return turns
