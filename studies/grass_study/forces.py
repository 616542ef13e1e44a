# SPDX-License-Identifier: Apache-2.0
"""Plasticity: leaves in rising wind, and the load that causes a given turn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Sequence

import numpy as np
from meristem import grass

WINDS = (0.0, 0.2, 0.5, 1.0, 2.0, 4.0)  #: in weights of the leaf, toward its stem or away from it
STIFFNESSES = (0.1, 0.3, 1.0)
TURNS = (5.0, 10.0, 15.0, 20.0)  #: degrees down at PLACE
PLACE = 0.75  #: position on the midrib
AGREES = 0.01


@dataclass(frozen=True)
class Turn:
    """A wanted turn, the load for it, and the resulting turn of the loaded leaf."""

    leaf: int
    wanted: float  #: degrees
    load: float  #: pull downward, in weights of the leaf; NaN if no load gives the turn
    found: float  #: degrees; NaN if no load gives the turn

    @property
    def error(self) -> float:
        return abs(self.found / self.wanted - 1)


def direction_at(leaf: grass.GrassLeaf, place: float) -> float:
    """Returns the direction in degrees, interpolated between the neighbouring pieces."""
    middles = 0.5 * (leaf.s[1:] + leaf.s[:-1])
    return float(np.interp(place, middles, leaf.angles))


def tip_turns(leaf: grass.GrassLeaf, sign: int) -> dict[float, list[float]]:
    """Returns the turns of the tip in each wind, in degrees, by stiffness."""
    last = leaf.angles[-1]
    return {
        stiffness: [
            float(grass.loaded(leaf, wind=(sign * wind, 0), stiffness=stiffness).angles[-1] - last) for wind in WINDS
        ]
        for stiffness in STIFFNESSES
    }


def find_turns(leaves: Sequence[grass.GrassLeaf]) -> list[Turn]:
    """Returns the load for each of TURNS and each leaf, and the turn under that load."""
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
