# SPDX-License-Identifier: Apache-2.0
"""Draws the visible share by diameter, the apparent thickness, and the points."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any, Mapping, Sequence

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray
from PIL import Image

from common.style import BLUE, DOTS_PER_INCH, GREEN, ORANGE, RED, STYLE, new_figure, save_figure

from .coverage import FEW, MANY, Coverage
from .expectations import of
from .pictures import save_in_few_colours
from .walnut import STATIONS

COUNTS = ((1, ORANGE), (2, GREEN), (3, RED), (STATIONS, BLUE))  #: numbers of stations, with their colours
LOOKS = (("terrestrial", BLUE), ("phase", GREEN), ("ray", ORANGE))
DPI = 100


def names_of(rows: Sequence[Coverage]) -> list[str]:
    """Returns the names of classes in millimetres."""
    names = [f"{1000 * row.low:.0f}–{1000 * row.high:.0f}" for row in rows]
    return [*names[:-1], f"over {1000 * rows[-1].low:.0f}"]


def draw_shares(path: Path, rows: Sequence[Coverage]) -> None:
    figure, [[left, right]] = new_figure(1, 2, 3.8)
    for axes, member, title in (
        (left, "seen", f"at least {FEW} points per segment"),
        (right, "fitted", f"at least {MANY} points per segment"),
    ):
        for count, colour in COUNTS:
            shown = of(rows, "terrestrial", count)
            axes.plot([100 * getattr(row, member) for row in shown], "o-", color=colour, lw=1.6, ms=4)
        axes.set_xticks(range(len(shown)), names_of(shown), rotation=35, ha="right")
        axes.set_ylim(0, 102)
        axes.set_title(title)
        axes.set_xlabel("diameter, mm")
    left.set_ylabel("share of the length, %")
    handles = [
        Line2D([], [], color=colour, marker="o", ms=4, label=f"{count} station{'s' if count > 1 else ''}")
        for count, colour in COUNTS
    ]
    save_figure(figure, handles, 4, path)


def draw_thickness(path: Path, rows: Sequence[Coverage]) -> None:
    figure, [[axes]] = new_figure(1, 1, 3.6)
    for name, colour in LOOKS:
        shown = of(rows, name)
        axes.plot([row.thickness for row in shown], "o-", color=colour, lw=1.6, ms=4)
    axes.axhline(1, color="#555555", lw=1)
    axes.set_xticks(range(len(shown)), names_of(shown))
    axes.set_xlabel("diameter, mm")
    axes.set_ylabel("measured over true radius")
    labels = {"ray": "terrestrial, without width and noise"}
    handles = [Line2D([], [], color=colour, marker="o", ms=4, label=labels.get(name, name)) for name, colour in LOOKS]
    save_figure(figure, handles, 3, path)


def draw_points(path: Path, scan: Mapping[str, NDArray[Any]]) -> None:
    """Draws the points from the east, coloured by order, by station and by the error of their distance."""
    figure = Figure(figsize=(11, 5.2), layout="constrained")
    panels = figure.subplots(1, 3)
    position = scan["position"]
    behind = np.argsort(position[:, 0], kind="stable")
    error = 1000 * np.abs(scan["range"] - scan["true_range"])
    for axes, values, map_name, title, span in (
        (panels[0], scan["order"], "viridis", "branching order", (0, 7)),
        (panels[1], scan["station"], "tab10", "station", (0, 9)),
        (panels[2], error, "magma", "error of the distance, mm (to 20)", (0, 20)),
    ):
        axes.scatter(
            -position[behind, 2], position[behind, 1], c=values[behind], cmap=map_name, vmin=span[0], vmax=span[1],
            s=0.15, lw=0, rasterized=True,
        )  # fmt: skip
        axes.set_aspect("equal")
        axes.set_title(title)
        axes.set_axis_off()
    drawn = io.BytesIO()
    figure.savefig(drawn, format="png", dpi=DPI)
    save_in_few_colours(Image.open(drawn), path)


def draw_figures(folder: Path, rows: Sequence[Coverage], scan: Mapping[str, NDArray[Any]]) -> None:
    with matplotlib.rc_context(STYLE):
        draw_shares(folder / "shares.png", rows)
        draw_thickness(folder / "thickness.png", rows)
        draw_points(folder / "points.png", scan)
