# SPDX-License-Identifier: Apache-2.0
"""Trunk and crown of low-poly trees as meshes, and counts of their elements."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Mapping

import meristem
import numpy
from numpy.typing import NDArray

ROOT = Path(__file__).resolve().parents[2]
SPRUCE = ROOT / "docs" / "manual" / "figures" / "low-poly-study" / "spruce.json"


@dataclass(frozen=True)
class Body:
    """Triangles as rows of vertices, and their bounding box."""

    triangles: NDArray[numpy.int64]
    low: NDArray[numpy.float64]
    high: NDArray[numpy.float64]

    @property
    def count(self) -> int:
        return len(self.triangles)


NOTHING = Body(numpy.zeros((0, 3), numpy.int64), numpy.zeros(3), numpy.zeros(3))


def read(path: Path) -> str:
    """Returns a document's text."""
    return path.read_text(encoding="utf-8")


def grow_bodies(text: str, values: Mapping[str, object], component: str = "tree") -> dict[str, Body]:
    """Returns the `trunk` and the `crown` of a document's component, with values set by their keys."""
    paths = {f"{component}.{key}": value for key, value in values.items()}
    plant = meristem.Document(text, set=paths).grow(threads=1)
    bodies = {"trunk": NOTHING, "crown": NOTHING}
    for part in plant.meshes:
        if part.component != component:
            continue
        name = plant.materials[part.material].name
        if name not in (component, f"{component}_crown"):
            continue
        # Flat faces and texture seams repeat points.
        positions, number = numpy.unique(
            numpy.asarray(part.mesh.positions, numpy.float64), axis=0, return_inverse=True)
        triangles = number.reshape(-1)[numpy.asarray(part.mesh.triangles)]
        bodies["crown" if name.endswith("_crown") else "trunk"] = Body(
            triangles, positions.min(axis=0), positions.max(axis=0))
    return bodies


def count_open_edges(body: Body) -> int:
    """Returns the number of edges without exactly one triangle on either side; 0 for a closed mesh."""
    edges = numpy.concatenate([body.triangles[:, [0, 1]], body.triangles[:, [1, 2]], body.triangles[:, [2, 0]]])
    there = {(int(a), int(b)) for a, b in edges}
    repeated = len(edges) - len(there)
    return repeated + sum((b, a) not in there for a, b in there)
