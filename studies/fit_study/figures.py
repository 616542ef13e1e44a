# SPDX-License-Identifier: Apache-2.0
"""Draws found values over planted values, and the errors of all plantings."""

from __future__ import annotations

from pathlib import Path
from typing import Mapping, Sequence

import matplotlib
import numpy as np
from matplotlib.lines import Line2D

from common.style import BLUE, GREEN, ORANGE, RED, STYLE, new_figure, save_figure

from .problems import Found

COLOURS = {"colonize": BLUE, "organize": RED, "lsystem": GREEN, "p-graph": ORANGE, "grassleaf": "#555555"}


def draw_found(path: Path, found: Sequence[Found], ends: Mapping[tuple[str, str], tuple[float, float]]) -> None:
    """Left: planted and found values as shares of their range. Right: the errors of each planting."""
    with matplotlib.rc_context(STYLE):
        figure, [[left, right]] = new_figure(1, 2, 4.3)
        left.plot([0, 1], [0, 1], color="#bbbbbb", lw=1, zorder=0)
        for one in found:
            low, high = ends[one.model, one.variable]
            place = [(value - low) / (high - low) for value in (one.true, one.found)]
            left.plot(*place, "o", color=COLOURS[one.system], ms=4.5, alpha=0.75, mec="none")
        left.set_xlabel("planted, share of the range")
        left.set_ylabel("found, share of the range")
        left.set_aspect("equal")
        names = list(dict.fromkeys((one.model, one.planting) for one in found))
        for row, name in enumerate(reversed(names)):
            errors = [one for one in found if (one.model, one.planting) == name]
            values = [max(100 * one.error, 0.001) for one in errors]
            right.plot(values, [row] * len(values), "o", color=COLOURS[errors[0].system], ms=4.5, alpha=0.75, mec="none")
            right.plot(np.median(values), row, "|", color="black", ms=9)
        right.set_yticks(range(len(names)), [f"{model} {planting + 1}" for model, planting in reversed(names)])
        right.set_xscale("log")
        right.set_xlim(0.0008, 120)
        right.axvline(5, color="#bbbbbb", lw=1, zorder=0)
        right.set_xlabel("error, % of the range")
        handles = [Line2D([], [], marker="o", ls="", color=colour, label=name) for name, colour in COLOURS.items()]
        save_figure(figure, handles, len(handles), path)
