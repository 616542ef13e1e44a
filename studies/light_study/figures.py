# SPDX-License-Identifier: Apache-2.0
"""Draws the results as the published figures 5.4 to 5.6 do, the same for response B, and what was expected."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Mapping, Sequence

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from .expectations import ANY, BANDS, Band
from .trees import AZIMUTHS, HELD_HEIGHT, LIT_SHARES, Mean, Tree, Treatment

Floats = NDArray[np.float64]
Means = Mapping[Treatment, Mean]

# Colours that stay apart for all kinds of sight (Okabe and Ito).
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
FIRST_AZIMUTH = -45.0  #: axes of azimuths begin here, as the published ones, so that north is not torn apart

STRENGTH_NAMES = {
    "shift": "shift of the cloud, m a step",
    "shift_held": "shift of the cloud, m a step",
    "limit": "share of points left out",
    "drift": "drift of the points, steps a step",
}


@dataclass(frozen=True)
class Panel:
    """One response in one scene, and what is drawn of it."""

    title: str
    response: str
    scene: str
    measure: str

    @property
    def factor(self) -> float:
        """From the measure's unit to the one drawn: shares are drawn as percent."""
        return 100.0 if self.measure in LIT_SHARES else 1.0


AXIS_NAMES = {
    "inclination_azimuth": "azimuth of the lean",
    "inclination_altitude": "altitude of the lean, °",
    "centroid_azimuth": "azimuth of the centroid",
    "centroid_radius": "centroid to the axis, m",
    "height": "height, m",
    "lit_share_still": "hull lit by the still sun, %",
    "lit_share_day": "hull lit over the day, %",
}


def wrap_azimuths(azimuths: Floats) -> Floats:
    """From FIRST_AZIMUTH on, within a turn."""
    return (azimuths - FIRST_AZIMUTH) % 360 + FIRST_AZIMUTH


def series_of(panel: Panel, means: Means) -> tuple[Floats, Floats, Floats]:
    """Strengths in rising order, means and spreads, each (n,)."""
    chosen = [mean for mean in means.values() if mean.treatment[:2] == (panel.response, panel.scene)]
    chosen.sort(key=lambda mean: mean.treatment.strength)
    strengths = np.array([mean.treatment.strength for mean in chosen])
    values = panel.factor * np.array([mean.measures[panel.measure] for mean in chosen])
    spreads = panel.factor * np.array([mean.spreads[panel.measure] for mean in chosen])
    return strengths, values, spreads


def points_of(panel: Panel, trees: Sequence[Tree]) -> tuple[Floats, Floats]:
    """Strength and value of each tree, each (n,)."""
    chosen = [tree for tree in trees if tree.plan.treatment[:2] == (panel.response, panel.scene)]
    strengths = np.array([tree.plan.treatment.strength for tree in chosen])
    return strengths, panel.factor * np.array([tree.measures[panel.measure] for tree in chosen])


def label_azimuths(axes: Axes) -> None:
    axes.set_ylim(FIRST_AZIMUTH, FIRST_AZIMUTH + 360)
    axes.set_yticks([0, 90, 180, 270], ["0° N", "90° E", "180° S", "270° W"])


def draw_panel(axes: Axes, panel: Panel, trees: Sequence[Tree], means: Means, colour: str) -> None:
    """Trees as dots, their mean as a line, its spread as a band."""
    strengths, values, spreads = series_of(panel, means)
    places, dots = points_of(panel, trees)
    if panel.measure in AZIMUTHS:
        values, dots = wrap_azimuths(values), wrap_azimuths(dots)
        label_azimuths(axes)
    axes.fill_between(strengths, values - spreads, values + spreads, color=colour, alpha=0.16, lw=0, label="spread")
    axes.plot(places, dots, ".", color=colour, ms=5, alpha=0.5, mew=0, label="a tree")
    axes.plot(strengths, values, "-", color=colour, lw=2, label="mean")
    axes.set_title(panel.title, loc="left")
    axes.set_xlabel(STRENGTH_NAMES[panel.response])
    axes.set_ylabel(AXIS_NAMES[panel.measure])
    axes.margins(x=0.03)


def share_scales(grid: Sequence[Sequence[Axes]], panels: Sequence[Sequence[Panel]]) -> None:
    """One scale for all panels of a measure."""
    flat = [(axes, panel) for row, of_row in zip(grid, panels) for axes, panel in zip(row, of_row)]
    for measure in {panel.measure for _, panel in flat}:
        same = [axes for axes, panel in flat if panel.measure == measure]
        low = min(axes.get_ylim()[0] for axes in same)
        high = max(axes.get_ylim()[1] for axes in same)
        for axes in same:
            axes.set_ylim(low, high)


def new_figure(rows: int, columns: int, height: float) -> tuple[Figure, list[list[Axes]]]:
    figure = Figure(figsize=(9, height), layout="constrained")
    return figure, [list(row) for row in figure.subplots(rows, columns, squeeze=False)]


def save_figure(figure: Figure, named: Axes, columns: int, path: Path) -> None:
    """Writes a PNG, with the legend of one of its axes below all of them."""
    handles, labels = named.get_legend_handles_labels()
    inches = 0.1 + 0.23 * math.ceil(len(labels) / columns)
    bottom = inches / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, bottom, 1, 1 - bottom))
    figure.legend(handles, labels, loc="lower center", ncol=columns)
    figure.savefig(path, dpi=DOTS_PER_INCH)


def draw_grid(
    path: Path, panels: Sequence[Sequence[Panel]], trees: Sequence[Tree], means: Means, colours: Sequence[str]
) -> None:
    """A figure of panels, a colour a row."""
    figure, grid = new_figure(len(panels), len(panels[0]), 3.1 * len(panels) + 0.3)
    for row, of_row, colour in zip(grid, panels, colours):
        for axes, panel in zip(row, of_row):
            draw_panel(axes, panel, trees, means, colour)
    share_scales(grid, panels)
    save_figure(figure, grid[0][0], 3, path)


def name_columns(columns: Sequence[tuple[str, str, str]], measures: Sequence[str]) -> list[list[Panel]]:
    """A row a measure and a column a response in a scene."""
    return [[Panel(title, response, scene, measure) for title, response, scene in columns] for measure in measures]


@dataclass(frozen=True)
class Line:
    """Means of a response in a scene, in a picture with others."""

    name: str
    response: str
    scene: str
    measure: str
    colour: str
    change: bool = False  #: whether the difference from strength 0 is drawn

    @property
    def panel(self) -> Panel:
        return Panel(self.name, self.response, self.scene, self.measure)


def values_of(line: Line, means: Means) -> tuple[Floats, Floats]:
    """Strengths and what is drawn over them, each (n,)."""
    strengths, values, _ = series_of(line.panel, means)
    if line.change:
        values = values - values[0]
    return strengths, wrap_azimuths(values) if line.measure in AZIMUTHS else values


def draw_band(axes: Axes, band: Band, line: Line, width: float) -> None:
    """A box at the band's strengths, `width` wider at each end; without an upper bound, to the top of the axes."""
    top = axes.get_ylim()[1] if band.high == ANY else line.panel.factor * band.high
    low = line.panel.factor * band.low
    ends = [min(band.strengths) - width, max(band.strengths) + width]
    axes.fill_between(ends, low, top, color=line.colour, alpha=0.22, lw=0)


def matches(band: Band, line: Line) -> bool:
    same = (band.response, band.scene, band.measure) == (line.response, line.scene, line.measure)
    return same and band.change == line.change and not band.spread and not band.relative


def draw_lines(axes: Axes, title: str, unit: str, lines: Sequence[Line], means: Means) -> None:
    """Lines over the boxes in which they are expected, the legend below."""
    for line in lines:
        axes.plot(*values_of(line, means), ".-", color=line.colour, lw=1.8, ms=6, label=line.name)
    if lines[0].measure in AZIMUTHS:
        label_azimuths(axes)
    axes.margins(x=0.06)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.1 * (high - low) * (unit == "points"))
    left, right = axes.get_xlim()
    for line in lines:
        for band in BANDS:
            if matches(band, line):
                draw_band(axes, band, line, 0.02 * (right - left))
    axes.set_title(title, loc="left")
    axes.set_xlabel(STRENGTH_NAMES[lines[0].response])
    axes.set_ylabel(unit)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2), ncol=2, handlelength=1.4, columnspacing=1.2)


def draw_expected(path: Path, means: Means) -> None:
    """Means of responses A and B over boxes: what the specification expects."""
    still, day = LIT_SHARES
    both = (("scene A", "A", RED), ("scene B", "B", BLUE))
    pictures = (
        ("Azimuth of the lean", "azimuth", [Line(n, "shift", s, "inclination_azimuth", c) for n, s, c in both]),
        ("Altitude of the lean", "°", [Line(n, "shift", s, "inclination_altitude", c) for n, s, c in both]),
        ("Height", "m", [Line(n, "shift", s, "height", c) for n, s, c in both]),
        (
            "Response A: lit share",
            "points",
            [
                Line("A, still sun", "shift", "A", still, ORANGE, True),
                Line("A, day", "shift", "A", day, RED, True),
                Line("B, day", "shift", "B", day, BLUE, True),
                Line("B, day, 3.7 m", "shift_held", "B", day, GREEN, True),
            ],
        ),
        ("Response B: limited space", "points", [Line("A, still sun", "limit", "A", still, ORANGE, True)]),
        ("Response B: drift, height held", "points", [Line("B, day", "drift", "B", day, BLUE, True)]),
    )
    figure, grid = new_figure(2, 3, 7.4)
    for axes, (title, unit, lines) in zip((axes for row in grid for axes in row), pictures):
        draw_lines(axes, title, unit, lines, means)
    figure.savefig(path, dpi=DOTS_PER_INCH)


def draw_gain(path: Path, means: Means) -> None:
    """Lit share over height: what each response gains in each scene, and what it costs in height."""
    figure, grid = new_figure(1, 2, 4.1)
    looks = (
        ("shift", RED, "o", "response A: shift"),
        ("shift_held", ORANGE, "s", f"response A, cloud scaled to {HELD_HEIGHT} m"),
        ("limit", GREEN, "^", "response B: limited space"),
        ("drift", BLUE, "D", "response B: drift, height held"),
    )
    titles = {"A": "Scene A: still sun", "B": "Scene B: building, a day's sun"}
    for axes, scene, measure in zip(grid[0], ("A", "B"), LIT_SHARES):
        for response, colour, marker, name in looks:
            _, heights, _ = series_of(Panel("", response, scene, "height"), means)
            _, shares, _ = series_of(Panel("", response, scene, measure), means)
            axes.plot(heights, shares, "-", marker=marker, color=colour, ms=4.5, lw=1.4, alpha=0.9, label=name)
        _, heights, _ = series_of(Panel("", "limit", scene, "height"), means)
        _, shares, _ = series_of(Panel("", "limit", scene, measure), means)
        axes.plot(heights[0], shares[0], "o", mfc="none", mec="black", ms=11, mew=1.4, label="no response")
        axes.set_title(titles[scene], loc="left")
        axes.set_xlabel(AXIS_NAMES["height"])
        axes.set_ylabel(AXIS_NAMES[measure])
    save_figure(figure, grid[0][0], 3, path)


def draw_figures(folder: Path, trees: Sequence[Tree], means: Means) -> None:
    """All figures, as PNG files in `folder`."""
    still, day = LIT_SHARES
    shifts = (("Scene A: still sun", "shift", "A"), ("Scene B: building, a day's sun", "shift", "B"))
    answers = (("Limited space, scene A", "limit", "A"), ("Drift at held height, scene B", "drift", "B"))
    shares = [
        [Panel("Scene A, still sun", "shift", "A", still), Panel("Scene A, a day's sun", "shift", "A", day)],
        [
            Panel("Scene B, a day's sun", "shift", "B", day),
            Panel(f"The same, all {HELD_HEIGHT} m high", "shift_held", "B", day),
        ],
    ]
    shares_b = [
        [Panel("Limited space, scene A, still sun", "limit", "A", still), Panel("The same, day", "limit", "A", day)],
        [Panel("Drift, scene B, a day's sun", "drift", "B", day), Panel("The same, still sun", "drift", "B", still)],
    ]
    lean = ("inclination_azimuth", "inclination_altitude")
    centroid = ("centroid_azimuth", "centroid_radius")
    with matplotlib.rc_context(STYLE):
        draw_grid(folder / "inclination.png", name_columns(shifts, lean), trees, means, (BLUE, RED))
        draw_grid(folder / "centroid.png", name_columns(shifts, centroid), trees, means, (BLUE, RED))
        draw_grid(folder / "lit-share.png", shares, trees, means, (BLUE, BLUE))
        draw_grid(folder / "inclination-b.png", name_columns(answers, lean), trees, means, (BLUE, RED))
        draw_grid(folder / "centroid-b.png", name_columns(answers, centroid), trees, means, (BLUE, RED))
        draw_grid(folder / "lit-share-b.png", shares_b, trees, means, (BLUE, BLUE))
        draw_gain(folder / "gain.png", means)
        draw_expected(folder / "expected.png", means)
