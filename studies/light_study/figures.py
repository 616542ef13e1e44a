# SPDX-License-Identifier: Apache-2.0
"""Draws the results as the published figures 5.4 to 5.6 do, the same for response B, and what was expected."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Sequence

import matplotlib
from matplotlib.axes import Axes
from matplotlib.patches import Patch

from .expectations import ANY, BANDS, Band
from .panels import (
    AXIS_NAMES,
    BLUE,
    GREEN,
    ORANGE,
    PURPLE,
    RED,
    STRENGTH_NAMES,
    STYLE,
    Floats,
    Means,
    Panel,
    draw_grid,
    label_azimuths,
    name_columns,
    new_figure,
    save_figure,
    series_of,
    wrap_azimuths,
)
from .trees import AZIMUTHS, HELD_HEIGHT, LIT_SHARES, Tree


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


def draw_lines(axes: Axes, title: str, ordinate: str, lines: Sequence[Line], means: Means) -> None:
    """Lines over the boxes in which they are expected, the legend below."""
    for line in lines:
        axes.plot(*values_of(line, means), ".-", color=line.colour, lw=1.8, ms=6, label=line.name)
    if lines[0].measure in AZIMUTHS:
        label_azimuths(axes)
    else:
        low, high = axes.get_ylim()
        axes.set_ylim(low, high + 0.1 * (high - low))
    axes.locator_params(axis="x", nbins=3)
    axes.margins(x=0.06)
    left, right = axes.get_xlim()
    for line in lines:
        for band in BANDS:
            if matches(band, line):
                draw_band(axes, band, line, 0.02 * (right - left))
    axes.set_title(title, loc="left")
    axes.set_xlabel(STRENGTH_NAMES[lines[0].response])
    axes.set_ylabel(ordinate)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2), ncol=2, handlelength=1.4, columnspacing=1.2)


def draw_expected(path: Path, means: Means) -> None:
    """Means of responses A and B over boxes: what the specification expects."""
    still, day = LIT_SHARES
    change = "change of lit share, points"
    both = (("scene A", "A", RED), ("scene B", "B", BLUE))
    pictures = (
        ("Azimuth of the lean", "azimuth", [Line(n, "shift", s, "inclination_azimuth", c) for n, s, c in both]),
        ("Altitude of the lean", "altitude, °", [Line(n, "shift", s, "inclination_altitude", c) for n, s, c in both]),
        ("Height", "height, m", [Line(n, "shift", s, "height", c) for n, s, c in both]),
        (
            "Response A: lit share",
            change,
            [
                Line("A, still sun", "shift", "A", still, ORANGE, True),
                Line("A, day", "shift", "A", day, RED, True),
                Line("B, day", "shift", "B", day, BLUE, True),
                Line("B, day, 3.7 m", "shift_scaled", "B", day, GREEN, True),
            ],
        ),
        ("Response B: limited space", change, [Line("A, still sun", "limit", "A", still, ORANGE, True)]),
        ("Response B: drift", change, [Line("B, day", "drift", "B", day, BLUE, True)]),
    )
    figure, grid = new_figure(2, 3, 7.4)
    for axes, (title, ordinate, lines) in zip((axes for row in grid for axes in row), pictures):
        draw_lines(axes, title, ordinate, lines, means)
    save_figure(figure, [Patch(color="black", alpha=0.2, lw=0, label="expected")], 1, path)


def draw_gain(path: Path, means: Means) -> None:
    """Lit share over height: what each response gains in each scene, and what it costs in height."""
    figure, grid = new_figure(1, 2, 4.1)
    looks = (
        ("shift", RED, "o", "response A: shift"),
        ("shift_scaled", ORANGE, "s", f"response A, cloud scaled for {HELD_HEIGHT} m"),
        ("shift_held", PURPLE, "v", "response A, height held"),
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
    save_figure(figure, grid[0][0].get_legend_handles_labels()[0], 3, path)


def draw_figures(folder: Path, trees: Sequence[Tree], means: Means) -> None:
    """All figures, as PNG files in `folder`."""
    still, day = LIT_SHARES
    shifts = (("Scene A: still sun", "shift", "A"), ("Scene B: building, a day's sun", "shift", "B"))
    answers = (("Limited space, scene A", "limit", "A"), ("Drift at held height, scene B", "drift", "B"))
    shares = [
        [Panel("Scene A, still sun", "shift", "A", still), Panel("Scene A, a day's sun", "shift", "A", day)],
        [
            Panel("Scene B, a day's sun", "shift", "B", day),
            Panel(f"The same, all {HELD_HEIGHT} m high", "shift_scaled", "B", day),
        ],
    ]
    shares_b = [
        [Panel("Limited space, scene A", "limit", "A", still), Panel("Limited space, scene B", "limit", "B", day)],
        [Panel("Drift, scene A", "drift", "A", still), Panel("Drift, scene B", "drift", "B", day)],
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
