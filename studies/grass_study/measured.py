# SPDX-License-Identifier: Apache-2.0
"""The measured leaves: 450 wheat midribs with widths by rank, wheat midribs by age, 13 maize blades.

They are from openalea-incubator/adel (CeCILL-C) and not part of the project. They are read from a folder beside it.
"""

from __future__ import annotations

import base64
import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple, Sequence

import numpy as np
from meristem import grass
from numpy.typing import NDArray

Floats = NDArray[np.float64]

BESIDE_THE_PROJECT = Path(__file__).resolve().parents[3] / "shared" / "data"
FOLDER = Path(os.environ.get("MERISTEM_SHARED_DATA", BESIDE_THE_PROJECT)) / "grass"
WHEAT_MIDRIBS = "So99.csv"
WHEAT_WIDTHS = "SRSo.csv"
WHEAT_AGES = "median_leaf_trajectories_Soissons_Grignon2010_byleafclass.csv"
MAIZE = "simpleleavesdb.json"
SMOOTHING = 0.0025  #: of midribs; the default of the library
SOURCES = (WHEAT_MIDRIBS, WHEAT_WIDTHS, WHEAT_AGES, MAIZE)


@dataclass(frozen=True)
class MeasuredLeaf:
    """A digitised midrib and the widths along its blade, in the unit of its file."""

    plant: str  #: "wheat" or "maize"
    rank: int
    x: Floats
    y: Floats
    s: Floats
    r: Floats

    def fit(self, pieces: int = 48, smoothing: float = SMOOTHING) -> grass.FittedLeaf:
        return grass.fit_leaf(self.x, self.y, self.s, self.r, pieces=pieces, smoothing=smoothing)


class AgedMidrib(NamedTuple):
    """The median midrib of a class of leaves at an age."""

    age: float
    points: Floats  #: (n, 2)


def missing_files(folder: Path) -> list[str]:
    return [name for name in SOURCES if not (folder / name).is_file()]


def read_wheat(folder: Path) -> list[MeasuredLeaf]:
    """Returns the midribs with the widths of their rank."""
    widths = {curve.rank: curve.points.T for curve in grass.read_widths(folder / WHEAT_WIDTHS)}
    leaves = []
    for midrib in grass.read_midribs(folder / WHEAT_MIDRIBS):
        assert midrib.rank is not None
        leaves.append(MeasuredLeaf("wheat", midrib.rank, *midrib.points.T, *widths[midrib.rank]))
    return leaves


def read_array(stored: dict[str, Any]) -> Floats:
    """Returns an array of the file: the bytes of doubles, little-endian, in base 64."""
    numbers = np.frombuffer(base64.b64decode(stored["__ndarray__"]), dtype="<f8")
    return numbers.reshape(stored["shape"]).astype(np.float64)


def read_maize(folder: Path) -> list[MeasuredLeaf]:
    """Returns the blades in the order of their ranks."""
    by_rank: dict[str, Sequence[Sequence[dict[str, Any]]]] = json.loads((folder / MAIZE).read_text(encoding="utf-8"))
    leaves = [MeasuredLeaf("maize", int(rank), *map(read_array, leaf)) for rank, of in by_rank.items() for leaf in of]
    return sorted(leaves, key=lambda leaf: leaf.rank)


def read_ages(folder: Path) -> dict[int, list[AgedMidrib]]:
    """Returns the midribs by class of leaves, in the order of their ages."""
    classes: dict[int, list[AgedMidrib]] = {}
    for midrib in grass.read_midribs(folder / WHEAT_AGES):
        assert midrib.lindex is not None and midrib.age is not None
        classes.setdefault(midrib.lindex, []).append(AgedMidrib(midrib.age, midrib.points))
    return {name: sorted(midribs, key=lambda midrib: midrib.age) for name, midribs in sorted(classes.items())}
