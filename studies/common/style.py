# SPDX-License-Identifier: Apache-2.0
"""The style of figures."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Sequence

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

# Colours that people with any kind of colour vision can distinguish (Okabe and Ito).
BLUE = "#0072B2"
RED = "#D55E00"
GREEN = "#009E73"
ORANGE = "#E69F00"
DOTS_PER_INCH = 110
STYLE = {
    "font.family": "DejaVu Sans",
    "font.size": 10,
    "axes.titlesize": 11,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e4e4e4",
    "grid.linewidth": 0.8,
    "axes.axisbelow": True,
    "legend.frameon": False,
    "legend.fontsize": 9.5,
}


def new_figure(rows: int, columns: int, height: float) -> tuple[Figure, list[list[Axes]]]:
    figure = Figure(figsize=(9, height), layout="constrained")
    return figure, [list(row) for row in figure.subplots(rows, columns, squeeze=False)]


def save_figure(figure: Figure, handles: Sequence[Artist], columns: int, path: Path) -> None:
    """Writes a PNG with a legend below all of its axes."""
    inches = 0.1 + 0.23 * math.ceil(len(handles) / columns)
    bottom = inches / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, bottom, 1, 1 - bottom))
    figure.legend(handles=handles, loc="lower center", ncol=columns)
    figure.savefig(path, dpi=DOTS_PER_INCH)
