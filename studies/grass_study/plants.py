# SPDX-License-Identifier: Apache-2.0
"""Maize plants, alone or in rows, with curved or straight leaves.

One plant is full grown, with invented lengths, widths and bends by rank. Each of its leaves is a straight leaf to which
the stages `inclined` and `turned` are applied. The other plant is young and has the measured blades. Stems, heights and
positions of both are invented.
"""

from __future__ import annotations

from typing import Any, Callable, Mapping, NamedTuple, Sequence

import meristem
import numpy as np
from meristem import grass

from .measured import MeasuredLeaf

CENTIMETRE = 0.01
STEM_RADIUS = 0.009  #: metres
PIECES = 16  #: number per blade
DEVIATION = 10  #: degrees, of azimuths from two opposite rows
LEAVES = 12  #: number on the full-grown plant


class Plant(NamedTuple):
    """A maize plant: its blades from the lowest up, in metres, and the heights of the collars."""

    name: str
    blades: Sequence[grass.GrassLeaf]
    lowest: float
    topmost: float

    def collar(self, rank: int) -> float:
        return self.lowest + (self.topmost - self.lowest) * rank / (len(self.blades) - 1)


class Stand(NamedTuple):
    """The arrangement of plants."""

    name: str
    rows: int
    plants: int
    row_spacing: float  #: metres
    spacing: float
    edge: float  #: metres from the outermost positions, within which plants only shade others

    @property
    def ground(self) -> float:
        """Square metres per plant."""
        return self.row_spacing * self.spacing


ONE = Stand("one", 1, 1, 1, 1, 0)
ALONE = Stand("alone", 4, 4, 40, 40, 0)
FIELD = Stand("in a field", 13, 51, 0.75, 0.18, 3.2)

Form = Callable[[grass.GrassLeaf], grass.GrassLeaf]


def turn_straight(leaf: grass.GrassLeaf, angle: float) -> grass.GrassLeaf:
    """Returns the leaf with a straight midrib, `angle` degrees away from the stem."""
    sine, cosine = np.sin(np.radians(angle)), np.cos(np.radians(angle))
    return grass.GrassLeaf(leaf.length, leaf.width, leaf.s, sine * leaf.s, cosine * leaf.s, leaf.r)


def chord_angle(leaf: grass.GrassLeaf) -> float:
    """Returns the angle in degrees between the stem and the line from collar to tip."""
    return float(np.degrees(np.arctan2(leaf.x[-1], leaf.y[-1])))


CURVED, ERECT, CHORD = "curved", "straight as it leaves the stem", "straight from collar to tip"
FORMS: Mapping[str, Form] = {
    CURVED: lambda leaf: leaf,
    ERECT: lambda leaf: turn_straight(leaf, leaf.inclination),
    CHORD: lambda leaf: turn_straight(leaf, chord_angle(leaf)),
}


def make_blade(share: float) -> grass.GrassLeaf:
    """Returns a blade of the full-grown plant. `share` is its rank: 0 for the lowest and 1 for the topmost."""
    size = 1 - 0.6 * (abs(share - 0.6) / 0.6) ** 1.8
    s = np.linspace(0, 1, 49)
    r = np.interp(s, [0, 0.1, 0.35, 0.65, 0.85, 1], [0.75, 0.9, 1, 0.82, 0.47, 0])
    straight = grass.GrassLeaf(0.85 * size, 0.09 * size**0.8, s, 0 * s, s, r)
    inclination = 32 - 14 * share
    bend = 115 - 45 * share
    return grass.turned(grass.inclined(straight, inclination), [(0.08, 0.95, bend)])


def full_grown() -> Plant:
    blades = [make_blade(rank / (LEAVES - 1)) for rank in range(LEAVES)]
    return Plant("full grown", blades, 0.12, 1.75)


def young(maize: Sequence[MeasuredLeaf]) -> Plant:
    """Returns a young plant with the measured blades."""
    blades = []
    for leaf in (measured.fit().leaf for measured in maize):
        blades.append(
            grass.GrassLeaf(CENTIMETRE * leaf.length, CENTIMETRE * leaf.width, leaf.s, leaf.x, leaf.y, leaf.r)
        )
    return Plant("young, as measured", blades, 0.05, 0.6)


def make_leaf(leaf: grass.GrassLeaf, rank: int, height: float) -> dict[str, Any]:
    """Returns the component of an unchanged leaf at its place on the stem."""
    return {
        "type": "grassleaf",
        "midrib_points": [[x, y] for x, y in zip(leaf.x.tolist(), leaf.y.tolist())],
        "profile": {"curve": [[s, r] for s, r in zip(leaf.s.tolist(), leaf.r.tolist())], "kind": "linear"},
        "length": leaf.length,
        "width": leaf.width,
        "polygons": PIECES,
        "exact": True,
        "stages": {"fit": False},
        "place": {"rotate": [0, f"{180 * (rank % 2)} + {DEVIATION}*gauss(0, 1)", 0], "translate": [0, height, 0]},
        "colour": "#5d8c40",
    }


def make_document(plant: Plant, form: str, stand: Stand) -> meristem.Document:
    """Returns the document of a stand. Its plants differ in their azimuths and in the deviations of their leaves."""
    leaves = {
        f"leaf{rank}": make_leaf(FORMS[form](leaf), rank, plant.collar(rank)) for rank, leaf in enumerate(plant.blades)
    }
    stem = {
        "type": "simple",
        "shape": "cylinder",
        "size": [2 * STEM_RADIUS, plant.topmost, 2 * STEM_RADIUS],
        "segments": 8,
        "colour": "#7d9a55",
    }
    field = {
        "type": "field",
        "rows": stand.rows,
        "plants": stand.plants,
        "row_spacing": stand.row_spacing,
        "spacing": stand.spacing,
        "turned": stand is not ONE,
    }
    links = [["field", name] for name in ("stem", *leaves)]
    return meristem.Document(
        {"meristem": 1, "components": {"field": field, "stem": stem, **leaves}, "links": links}, seed=1
    )
