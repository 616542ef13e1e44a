# SPDX-License-Identifier: Apache-2.0
"""The digitised walnut as a plant, its segments with their true sizes, and scans of it.

The walnut is `noylum2.mtg` of openalea/mtg (CeCILL-C) and not part of the project. It is in `shared/data/trees` beside
the project, or below the folder that MERISTEM_SHARED_DATA names.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Mapping

import meristem
import numpy as np
from numpy.typing import NDArray

BESIDE_THE_PROJECT = Path(__file__).resolve().parents[3] / "shared" / "data"
FILE = Path(os.environ.get("MERISTEM_SHARED_DATA", BESIDE_THE_PROJECT)) / "trees" / "noylum2.mtg"

STATIONS = 6
DISTANCE = 8.0  #: metres from the stem to the scanner
HEIGHT = 1.6  #: metres above ground

#: Instruments by name. A ray has no width, so it shows the effect of the width of the others.
INSTRUMENTS: Mapping[str, Mapping[str, Any]] = {
    "terrestrial": {"kind": "terrestrial"},
    "phase": {"kind": "phase"},
    "ray": {"kind": "terrestrial", "rays": 1, "noise": 0},
}


@dataclass(frozen=True)
class Segments:
    """The segments of the walnut, one row each; metres."""

    begin: NDArray[np.float32]
    end: NDArray[np.float32]
    radius: NDArray[np.float32]  #: mean of both ends
    axis: NDArray[np.uint32]
    order: NDArray[np.uint16]

    @property
    def length(self) -> NDArray[np.float32]:
        length: NDArray[np.float32] = np.linalg.norm(self.end - self.begin, axis=1)
        return length

    def __len__(self) -> int:
        return len(self.radius)


def grow_walnut() -> meristem.Plant:
    """Returns the bare walnut with its root at the origin. Its tubes are round down to the thinnest twigs."""
    surface = {"sides": 64, "error": 0.005}
    tree = {"type": "skeleton", "file": str(FILE), "unit": 0.01, "diameter_unit": 0.001, "surface": surface}
    return meristem.Document({"meristem": 1, "name": "Walnut", "components": {"tree": tree}}).grow()


def segments_of(plant: meristem.Plant) -> Segments:
    """Returns segments of non-zero length. The first segment of a lateral has the radius of its first node, like its
    tube."""
    skeleton = plant.stems[0].skeleton
    parent = skeleton.parent.astype(int)
    nodes = np.flatnonzero(parent >= 0)
    begin = skeleton.position[parent[nodes]]
    end = skeleton.position[nodes]
    nodes = nodes[np.linalg.norm(end - begin, axis=1) > 1e-6]
    before = parent[nodes]
    begins = skeleton.axis[before] != skeleton.axis[nodes]
    own = skeleton.radius[nodes]
    other = np.where(begins, own, skeleton.radius[before])
    return Segments(
        skeleton.position[before], skeleton.position[nodes], (own + other) / 2, skeleton.axis[nodes],
        skeleton.order[nodes],
    )  # fmt: skip


def stations() -> NDArray[np.float64]:
    """Returns positions of the scanner in the order of use: each is far from the earlier ones."""
    azimuths = 2 * np.pi * np.array([0, 3, 1, 4, 2, 5]) / STATIONS
    return np.stack(
        [DISTANCE * np.sin(azimuths), np.full(STATIONS, HEIGHT), -DISTANCE * np.cos(azimuths)], axis=1
    )


def scan_walnut(plant: meristem.Plant, instrument: str, step: float) -> dict[str, NDArray[Any]]:
    """Returns all points of an instrument from the six stations; `step` is in degrees."""
    wanted = {**INSTRUMENTS[instrument], "step": step}
    return plant.scan(instrument=wanted, stations=stations())
