# SPDX-License-Identifier: Apache-2.0
"""Figures of panels: trees as dots over the strength of a response, their mean as a line, its spread as a band."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from common.style import new_figure, save_figure

from .trees import AZIMUTHS, LIT_SHARES, Mean, Tree, Treatment

Floats = NDArray[np.float64]
Means = Mapping[Treatment, Mean]

FIRST_AZIMUTH = -45.0  #: axes of azimuths begin here, like the published ones, so that north is not divided
WIDEST_SPREAD = 90.0  #: degrees; azimuths with a larger spread have no meaningful mean

STRENGTH_NAMES = {
    "shift": "shift of the cloud, m per step",
    "shift_scaled": "shift of the cloud, m per step",
    "shift_held": "shift of the cloud, m per step",
    "limit": "share of points left out",
    "drift": "drift of the points, steps per step",
}


@dataclass(frozen=True)
class Panel:
    """One response in one scene, and the drawn measure."""

    title: str
    response: str
    scene: str
    measure: str

    @property
    def factor(self) -> float:
        """The factor from the measure's unit to the drawn unit; shares are drawn as percent."""
        return 100.0 if self.measure in LIT_SHARES else 1.0


AXIS_NAMES = {
    "inclination_azimuth": "azimuth of the lean",
    "inclination_altitude": "altitude of the lean, °",
    "centroid_azimuth": "azimuth of the centroid",
    "centroid_radius": "centroid to the axis, m",
    "lit_share_still": "hull lit by the still sun, %",
    "lit_share_day": "hull lit over the day, %",
}


def wrap_azimuths(azimuths: Floats) -> Floats:
    """Wraps azimuths to a full turn from FIRST_AZIMUTH."""
    return (azimuths - FIRST_AZIMUTH) % 360 + FIRST_AZIMUTH


def series_of(panel: Panel, means: Means) -> tuple[Floats, Floats, Floats]:
    """Returns strengths in rising order, means and spreads, each (n,)."""
    chosen = [mean for mean in means.values() if mean.treatment[:2] == (panel.response, panel.scene)]
    chosen.sort(key=lambda mean: mean.treatment.strength)
    strengths = np.array([mean.treatment.strength for mean in chosen])
    values = panel.factor * np.array([mean.measures[panel.measure] for mean in chosen])
    spreads = panel.factor * np.array([mean.spreads[panel.measure] for mean in chosen])
    return strengths, values, spreads


def points_of(panel: Panel, trees: Sequence[Tree]) -> tuple[Floats, Floats]:
    """Returns strength and value of each tree, each (n,)."""
    chosen = [tree for tree in trees if tree.plan.treatment[:2] == (panel.response, panel.scene)]
    strengths = np.array([tree.plan.treatment.strength for tree in chosen])
    return strengths, panel.factor * np.array([tree.measures[panel.measure] for tree in chosen])


def label_azimuths(axes: Axes) -> None:
    axes.set_ylim(FIRST_AZIMUTH, FIRST_AZIMUTH + 360)
    axes.set_yticks([0, 90, 180, 270], ["0° N", "90° E", "180° S", "270° W"])


def draw_panel(axes: Axes, panel: Panel, trees: Sequence[Tree], means: Means, colour: str) -> None:
    """Draws trees as dots, their mean as a line, and its spread as a band."""
    band: dict[str, Any] = {"color": colour, "alpha": 0.16, "lw": 0}
    strengths, values, spreads = series_of(panel, means)
    places, dots = points_of(panel, trees)
    if panel.measure in AZIMUTHS:
        values = np.where(spreads < WIDEST_SPREAD, wrap_azimuths(values), np.nan)
        dots = wrap_azimuths(dots)
        label_azimuths(axes)
        for turn in (-360, 360):
            axes.fill_between(strengths, values + turn - spreads, values + turn + spreads, **band)
    axes.fill_between(strengths, values - spreads, values + spreads, label="spread", **band)
    axes.plot(places, dots, ".", color=colour, ms=6, alpha=0.5, mew=0, label="a tree")
    axes.plot(strengths, values, "-", color=colour, lw=2, label="mean")
    axes.set_title(panel.title, loc="left")
    axes.set_xlabel(STRENGTH_NAMES[panel.response])
    axes.set_ylabel(AXIS_NAMES[panel.measure])
    axes.margins(x=0.05)


def share_scales(grid: Sequence[Sequence[Axes]], panels: Sequence[Sequence[Panel]]) -> None:
    """Sets equal scales for all panels of a measure."""
    flat = [(axes, panel) for row, of_row in zip(grid, panels) for axes, panel in zip(row, of_row)]
    for measure in {panel.measure for _, panel in flat}:
        same = [axes for axes, panel in flat if panel.measure == measure]
        low = min(axes.get_ylim()[0] for axes in same)
        high = max(axes.get_ylim()[1] for axes in same)
        for axes in same:
            axes.set_ylim(low, high)


def draw_grid(
    path: Path, panels: Sequence[Sequence[Panel]], trees: Sequence[Tree], means: Means, colours: Sequence[str]
) -> None:
    """Draws a figure of panels, with one colour per row."""
    figure, grid = new_figure(len(panels), len(panels[0]), 3.1 * len(panels) + 0.3)
    for row, of_row, colour in zip(grid, panels, colours):
        for axes, panel in zip(row, of_row):
            draw_panel(axes, panel, trees, means, colour)
    share_scales(grid, panels)
    save_figure(figure, grid[0][0].get_legend_handles_labels()[0], 3, path)


def name_columns(columns: Sequence[tuple[str, str, str]], measures: Sequence[str]) -> list[list[Panel]]:
    """Returns panels with one row per measure and one column per response in a scene."""
    return [[Panel(title, response, scene, measure) for title, response, scene in columns] for measure in measures]
