# SPDX-License-Identifier: Apache-2.0
"""Pictures: one leaf with several numbers of triangles, and plants with curved and with straight leaves."""

from __future__ import annotations

from pathlib import Path
from typing import Sequence

import matplotlib
import meristem
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from meristem import grass

from common.style import DOTS_PER_INCH, STYLE

from .measured import Floats
from .plants import FORMS, ONE, Plant, make_document

DRAWN_PIECES = (1, 2, 4, 8, 16)
FINE = 100  #: number of triangles from which edges are thin
LOOK = (50.0, 25.0)  #: degrees, from the side and from above
LIGHT = np.array([0.35, 0.8, 0.5])
LEAF_COLOUR = np.array([0.36, 0.55, 0.25])
SIZE = (300, 420)  #: pixels


def look(points: Floats) -> Floats:
    """Returns points in view coordinates: right, up, and toward the eye."""
    turn, rise = np.radians(LOOK)
    side = np.array([np.sin(turn), 0, np.cos(turn)])  # the leaf points to -z, which is then to the right
    right = np.array([np.cos(turn), 0, -np.sin(turn)])
    eye = np.cos(rise) * right + np.array([0, np.sin(rise), 0])
    up = np.cross(eye, -side)
    return np.asarray(points @ np.column_stack([-side, up, eye]))


def draw_mesh(axes: Axes, mesh: meristem.Mesh) -> None:
    """Draws triangles with their edges, farthest first."""
    corners = mesh.positions.astype(np.float64)[mesh.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    shade = 0.55 + 0.45 * np.abs(normals @ (LIGHT / np.linalg.norm(LIGHT)))
    seen = look(corners.reshape(-1, 3)).reshape(-1, 3, 3)
    order = np.argsort(seen[:, :, 2].mean(1))
    colours = np.clip(shade[:, None] * LEAF_COLOUR * 1.35, 0, 1)
    width = 0.5 if len(corners) < FINE else 0.2
    axes.add_collection(
        PolyCollection(seen[order][:, :, :2], facecolors=colours[order], edgecolors="#22331a", linewidths=width)
    )
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.axis("off")


def draw_triangles(path: Path, leaves: Sequence[tuple[str, grass.GrassLeaf]]) -> None:
    """Draws one row per leaf: reduced leaves, and the whole leaf last."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(9, 2.3 * len(leaves)), layout="constrained")
        rows = figure.subplots(len(leaves), len(DRAWN_PIECES) + 1, squeeze=False, sharex="row", sharey="row")
        for row, (name, leaf) in zip(rows, leaves):
            forms = [grass.reduced(leaf, pieces=pieces) for pieces in DRAWN_PIECES] + [leaf]
            for axes, form in zip(row, forms):
                mesh = grass.make_grass_blade(form)
                draw_mesh(axes, mesh)
                axes.set_title(f"{len(mesh.triangles)}", fontsize=10)
            row[0].set_title(f"{name}\n{len(grass.make_grass_blade(forms[0]).triangles)} triangles", fontsize=10)
        figure.savefig(path, dpi=DOTS_PER_INCH)


def draw_plants(path: Path, plant: Plant) -> None:
    """Draws the plant with each form of its leaves."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(9, 4.6), layout="constrained")
        for axes, form in zip(figure.subplots(1, len(FORMS)), FORMS):
            grown = make_document(plant, form, ONE).grow()
            axes.imshow(grown.render(size=SIZE, samples=64, view=(35, 14), transparent=True))
            axes.set_title(form, fontsize=10)
            axes.axis("off")
        figure.savefig(path, dpi=DOTS_PER_INCH)
