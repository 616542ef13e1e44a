# SPDX-License-Identifier: Apache-2.0
"""The published values.

Based on: F. Heuer, Algorithmische Erzeugung von 3D-Low-Poly-Bäumen, Hamburg 2022, tables 4.3 and 6.1, figures B.3 to
B.5.
"""

from __future__ import annotations

from typing import NamedTuple


class Row(NamedTuple):
    """A resolution with the triangles of both bodies."""

    resolution: int
    trunk: int
    crown: int

    @property
    def ratio(self) -> float:
        return self.crown / self.trunk


SERIES = (
    Row(25, 942, 3848),
    Row(50, 6452, 15992),
    Row(75, 14196, 36268),
    Row(100, 27100, 64476),
    Row(125, 40738, 101668),
    Row(150, 60472, 146604),
    Row(200, 111026, 259556),
)


class Parameter(NamedTuple):
    """A parameter of table 4.3: its name there, our key, and a value that replaces the spruce's."""

    name: str
    key: str
    value: float


PARAMETERS = (
    Parameter("Tres", "surface.resolution", 50),
    Parameter("Cres", "surface.crown.resolution", 50),
    Parameter("Bl", "length", 0.15),
    Parameter("Bw", "width", 0.06),
    Parameter("r1", "width_decay.trunk", 0.9),
    Parameter("r2", "width_decay.branch", 0.7),
    Parameter("Sdia", "surface.crown.diameter", 0.12),
    Parameter("Soff", "surface.crown.offset", 0.12),
    Parameter("Cfus", "surface.crown.fuse", 0.05),
    Parameter("Tgen", "steps", 5),
    Parameter("alpha", "angles.elevation", 24),
    Parameter("beta", "angles.azimuth", 30),
)

#: The trees of section 6.1 with the resolutions of their trunks and crowns.
TREES = {"fir": (35, 20), "palm": (50, 25), "oak": (25, 15)}
