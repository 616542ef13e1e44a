# SPDX-License-Identifier: Apache-2.0
"""Draws the results like the published figures 5.4 to 5.6, the equivalent for response B, and the expectations."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Sequence

import matplotlib
from matplotlib.axes import Axes
from matplotlib.patches import Patch

from common.style import BLUE, DOTS_PER_INCH, GREEN, ORANGE, RED, STYLE, new_figure, save_figure

from .expectations import ANY, BANDS, Band, change_of
from .panels import (
    STRENGTH_NAMES,
    Floats,
    Means,
    Panel,
    draw_grid,
    label_azimuths,
    name_columns,
    series_of,
    wrap_azimuths,
)
from .trees import AZIMUTHS, HELD_HEIGHT, LIT_SHARES, Tree, Treatment


@dataclass(frozen=True)
class Line:
    """Means of a response in a scene, drawn with others in one picture."""

    name: str
    response: str
    scene: str
    measure: str
    colour: str
    change: bool = False  #: true: the difference from strength 0 is drawn

    @property
    def panel(self) -> Panel:
        return Panel(self.name, self.response, self.scene, self.measure)


def values_of(line: Line, means: Means) -> tuple[Floats, Floats]:
    """Returns strengths and the drawn values, each (n,)."""
    strengths, values, _ = series_of(line.panel, means)
    if line.change:
        values = values - values[0]
    return strengths, wrap_azimuths(values) if line.measure in AZIMUTHS else values


def draw_band(axes: Axes, band: Band, line: Line, width: float) -> None:
    """Draws a box at the band's strengths, `width` wider at each end. Without an upper bound, it reaches the top of the
    axes."""
    top = axes.get_ylim()[1] if band.high == ANY else line.panel.factor * band.high
    low = line.panel.factor * band.low
    ends = [min(band.strengths) - width, max(band.strengths) + width]
    axes.fill_between(ends, low, top, color=line.colour, alpha=0.22, lw=0)


def matches(band: Band, line: Line) -> bool:
    same = (band.response, band.scene, band.measure) == (line.response, line.scene, line.measure)
    return same and band.change == line.change and not band.spread and not band.relative


def draw_lines(axes: Axes, title: str, ordinate: str, lines: Sequence[Line], means: Means) -> None:
    """Draws lines over the boxes in which they are expected, with the legend below."""
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
    """Draws means of responses A and B over the boxes that the specification expects."""
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
    """Draws bars for the change of the lit share by each response in each scene, with the height of the trees."""
    bars = (
        ("Response A, 0.010 m", "shift", 0.010, RED),
        ("Response A, 0.005 m, cloud scaled", "shift_scaled", 0.005, RED),
        ("Response A, 0.010 m, cloud scaled", "shift_scaled", 0.010, RED),
        ("Response A, 0.010 m, top held", "shift_held", 0.010, RED),
        ("Response B, 0.36 left out", "limit", 0.36, BLUE),
        ("Response B, 0.6 left out", "limit", 0.6, BLUE),
        ("Response B, drift 0.9, top held", "drift", 0.9, BLUE),
    )
    figure, grid = new_figure(1, 2, 3.5)
    titles = ("Scene A, still sun", "Scene B, a day's sun")
    for axes, scene, measure, title in zip(grid[0], ("A", "B"), LIT_SHARES, titles):
        for place, (_, response, strength, colour) in enumerate(bars):
            mean = means[Treatment(response, scene, strength)]
            points = 100 * change_of(means, mean, measure)
            axes.barh(place, points, color=colour, height=0.62)
            says = f"{points:+.1f} at {mean.measures['height']:.1f} m".replace("-", "\N{MINUS SIGN}")
            axes.annotate(says, (max(points, 0), place), (4, 0), textcoords="offset points", va="center", fontsize=9)
        axes.axvline(0, color="black", lw=0.8)
        axes.set_xlim(-8, 15)
        axes.set_yticks(range(len(bars)), [name for name, *_ in bars] if scene == "A" else [""] * len(bars))
        axes.grid(axis="y", visible=False)
        axes.invert_yaxis()
        axes.set_title(title, loc="left")
        axes.set_xlabel("change of lit share, points")
    figure.savefig(path, dpi=DOTS_PER_INCH)


def draw_figures(folder: Path, trees: Sequence[Tree], means: Means) -> None:
    """Draws all figures, as PNG files in `folder`."""
    still, day = LIT_SHARES
    shifts = (("Scene A: still sun", "shift", "A"), ("Scene B: building, a day's sun", "shift", "B"))
    answers = (("Limited space, scene A", "limit", "A"), ("Drift at held height, scene B", "drift", "B"))
    shares = [
        [Panel("Scene A, still sun", "shift", "A", still), Panel("Scene A, a day's sun", "shift", "A", day)],
        [
            Panel("Scene B, a day's sun", "shift", "B", day),
            Panel(f"Scene B, all {HELD_HEIGHT} m high", "shift_scaled", "B", day),
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
