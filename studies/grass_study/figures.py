# SPDX-License-Identifier: Apache-2.0
"""Draws fits, ages, errors and times over triangles, and leaves in the wind."""

from __future__ import annotations

from pathlib import Path
from typing import Callable, Mapping, Sequence, TypeVar, cast

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from meristem import grass

from common.style import BLUE, GREEN, ORANGE, RED, STYLE, new_figure, save_figure

from . import ages, fits, forces, levels
from .ages import AgeError, make_form
from .fits import Fit, Smoothed
from .forces import Turn
from .levels import Level, Time
from .measured import SMOOTHING, AgedMidrib, MeasuredLeaf

COLOURS = (BLUE, RED, GREEN, ORANGE)
DRAWN_FITS = 4  #: number per plant

Draw = TypeVar("Draw", bound=Callable[..., None])


def styled(draw: Draw) -> Draw:
    """Wraps a function so that it draws in the style of all figures."""
    return cast(Draw, matplotlib.rc_context(STYLE)(draw))


def draw_side(axes: Axes, leaf: grass.GrassLeaf, scale: float = 1, **style: object) -> None:
    """Draws the side view of a midrib."""
    axes.plot(scale * leaf.x, scale * leaf.y, **style)


def frame_side(axes: Axes) -> None:
    axes.margins(0.12)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xticklabels([])
    axes.set_yticklabels([])
    axes.tick_params(length=0)


@styled
def draw_fits(path: Path, wheat: Sequence[MeasuredLeaf], maize: Sequence[MeasuredLeaf]) -> None:
    """Draws digitised points with their fits: midribs above, widths below."""
    some = [wheat[k] for k in np.linspace(0, len(wheat) - 1, DRAWN_FITS).astype(int)]
    some += [maize[k] for k in np.linspace(0, len(maize) - 1, DRAWN_FITS + 1).astype(int)[1:]]
    figure, [above, below] = new_figure(2, len(some), 4.2)
    for midrib, widths, measured in zip(above, below, some):
        fitted = measured.fit()
        scale = 1 / fitted.midrib_length
        x, y = scale * (measured.x - measured.x[0]), scale * (measured.y - measured.y[0])
        midrib.plot(x, y, "o", color=RED, ms=3, mew=0, alpha=0.8)
        draw_side(midrib, fitted.leaf, color=BLUE, lw=1.5)
        midrib.set_title(f"{measured.plant}, {measured.rank}", fontsize=9)
        frame_side(midrib)
        step = max(1, len(measured.s) // 30)
        places, shares = measured.s[::step] / measured.s[-1], measured.r[::step] / measured.r.max()
        widths.plot(places, shares, "o", color=RED, ms=3, mew=0, alpha=0.8)
        widths.plot(fitted.leaf.s, fitted.leaf.r * fitted.leaf.width / measured.r.max(), color=BLUE, lw=1.5)
        widths.set_ylim(-0.03, 1.1)
        widths.set_xticks([0, 1])
        if measured is not some[0]:
            widths.set_yticklabels([])
    above[0].set_ylabel("midrib")
    below[0].set_ylabel("width")
    handles = [
        Line2D([], [], marker="o", ls="", color=RED, ms=4, mew=0, label="measured"),
        Line2D([], [], color=BLUE, lw=1.5, label="fitted"),
    ]
    save_figure(figure, handles, 2, path)


@styled
def draw_errors(path: Path, of_fits: Mapping[str, Sequence[Fit]], smoothed: Sequence[Smoothed]) -> None:
    """Draws errors over the smoothing, and the errors of all fits with their bounds."""
    figure, [[near, long, area]] = new_figure(1, 3, 3.9)
    at = [100 * row.smoothing for row in smoothed]
    near.plot(at, [100 * row.distance_most for row in smoothed], ".-", color=BLUE, lw=1.8, ms=7)
    near.plot(at, [100 * row.length for row in smoothed], ".-", color=GREEN, lw=1.8, ms=7)
    near.axhline(100 * fits.DISTANCE, color="black", lw=1, ls="--")
    near.axvline(100 * SMOOTHING, color="black", lw=0.8, ls=":")
    near.set_xlabel("smoothing, % of length")
    near.set_ylabel("%, wheat")
    for measured, colour in zip(of_fits.values(), (BLUE, RED)):
        long.plot(
            [max(1, fit.to_and_fro) for fit in measured],
            [100 * fit.length for fit in measured],
            ".",
            color=colour,
            ms=5,
            mew=0,
            alpha=0.6,
        )
        for rank in sorted({fit.rank for fit in measured}):
            errors = [100 * abs(fit.area) for fit in measured if fit.rank == rank]
            area.plot(rank, max(errors), "o", color=colour, ms=5, mew=0)
    long.plot([1, fits.SMOOTH, fits.SMOOTH, 1], [-1, -1, 1, 1], color="black", lw=1, ls="--")
    long.set_xscale("log")
    long.set_xticks([1, 10, 100], ["1", "10", "100"])
    long.set_xlabel("turns to and fro, degrees")
    long.set_ylabel("length over the polyline's, less 1, %")
    area.axhline(100 * fits.AREA, color="black", lw=1, ls="--")
    area.set_xlabel("rank")
    area.set_ylabel("area off, largest of a rank, %")
    area.set_ylim(0)
    handles = [
        Line2D([], [], marker="o", ls="", color=colour, ms=5, mew=0, label=f"{plant}, {len(measured)} leaves")
        for (plant, measured), colour in zip(of_fits.items(), (BLUE, RED))
    ]
    handles += [
        Line2D([], [], color="black", lw=1, ls="--", label="bound"),
        Line2D([], [], color=BLUE, lw=1.8, label="distance, largest"),
        Line2D([], [], color=GREEN, lw=1.8, label="length, median"),
        Line2D([], [], color="black", lw=0.8, ls=":", label="as set"),
    ]
    save_figure(figure, handles, 3, path)


@styled
def draw_ages(
    path: Path, classes: Mapping[int, Sequence[AgedMidrib]], errors: Mapping[int, Sequence[AgeError]]
) -> None:
    """Draws midribs by age, and the error of the tip by age."""
    figure, [row] = new_figure(1, len(classes) + 1, 3.8)
    colours = matplotlib.colormaps["viridis"]
    last = max(midribs[-1].age for midribs in classes.values())
    for axes, (name, midribs) in zip(row, classes.items()):
        for midrib in midribs[::2]:
            draw_side(axes, make_form(midrib).leaf, color=colours(0.92 * midrib.age / last), lw=1.6)
        axes.set_title(f"class {name}", loc="left", fontsize=10)
        axes.set_aspect("equal", adjustable="datalim")
        axes.set_xlabel("away from the stem, lengths")
    row[0].set_ylabel("along the stem, lengths")
    seen = (0, last / 2, last)
    keys = [Line2D([], [], color=colours(0.92 * age / last), lw=1.6, label=f"age {age:g}") for age in seen]
    error = row[-1]
    for (name, of_class), colour in zip(errors.items(), COLOURS):
        at = [one.age for one in of_class]
        error.plot(at, [100 * one.tip for one in of_class], ".-", color=colour, lw=1.6, label=f"class {name}, left out")
        nearest = [100 * one.nearest for one in of_class]
        error.plot(at, nearest, ":", color=colour, lw=1.2, label=f"class {name}, age before as it is")
    error.axhline(100 * ages.TIP, color="black", lw=1, ls="--", label="bound on the median")
    error.set_xlabel("age")
    error.set_ylabel("error of the tip, % of length")
    error.set_ylim(0)
    save_figure(figure, keys + error.get_legend_handles_labels()[0], 4, path)


@styled
def draw_levels(path: Path, of_wheat: Sequence[Level], times: Sequence[Time]) -> None:
    """Draws errors and time over triangles."""
    figure, [[form, area, clock]] = new_figure(1, 3, 3.6)
    triangles = [level.triangles for level in of_wheat]
    pairs = (
        (form, [level.distance for level in of_wheat], [level.distance_tenth for level in of_wheat]),
        (area, [level.area for level in of_wheat], [level.area_tenth for level in of_wheat]),
    )
    for axes, median, tenth in pairs:
        axes.plot(triangles, 100 * np.array(median), ".-", color=BLUE, lw=1.8, ms=7, label="median leaf")
        axes.plot(triangles, 100 * np.array(tenth), ".-", color=ORANGE, lw=1.4, ms=6, label="one leaf of ten is worse")
        axes.set_xscale("log", base=2)
        axes.set_yscale("log")
        axes.set_yticks([0.1, 1, 10], ["0.1", "1", "10"])
        axes.minorticks_off()
    form.set_ylabel("Hausdorff distance, %")
    area.set_ylabel("area off before scaling, %")
    at = [one.triangles for one in times]
    clock.plot(at, [one.mesh / 1000 for one in times], ".-", color=GREEN, lw=1.8, ms=7, label="reduce and mesh")
    clock.plot(at, [one.all / 1000 for one in times], ".-", color=RED, lw=1.8, ms=7, label="fit, reduce and mesh")
    clock.plot(*zip(*levels.AUTHORS), "x", color="black", ms=7, mew=2, label="fit and mesh, authors' program")
    clock.set_ylabel("milliseconds a leaf")
    clock.set_yscale("log")
    clock.set_yticks([0.01, 0.1, 1], ["0.01", "0.1", "1"])
    clock.minorticks_off()
    clock.set_ylim(0.008, 2.5)
    for axes in (form, area, clock):
        axes.set_xlabel("triangles")
        axes.set_xticks([2, 4, 8, 16, 32, 64, 128], ["2", "4", "8", "16", "32", "64", "128"])
    clock.set_xticks([0, 32, 64, 96, 128], ["0", "32", "64", "96", "128"])
    save_figure(figure, form.get_legend_handles_labels()[0] + clock.get_legend_handles_labels()[0], 3, path)


def wind_colour(k: int) -> object:
    return matplotlib.colormaps["viridis"](0.9 * k / (len(forces.WINDS) - 1)) if k > 0 else "black"


@styled
def draw_forces(path: Path, leaf: grass.GrassLeaf, turns: Sequence[Turn]) -> None:
    """Draws one leaf in rising wind in both directions, the turn of its tip, and loads for turns of many leaves."""
    figure, [[side, tip, load]] = new_figure(1, 3, 3.8)
    for sign in (-1, 1):
        for k, wind in enumerate(forces.WINDS):
            draw_side(side, grass.loaded(leaf, wind=(sign * wind, 0)), color=wind_colour(k), lw=1.8)
    side.set_aspect("equal", adjustable="datalim")
    side.set_xlabel("away from the stem, lengths")
    side.set_ylabel("along the stem, lengths")
    both = np.array([-wind for wind in forces.WINDS[:0:-1]] + list(forces.WINDS))
    to_stem, away = forces.tip_turns(leaf, -1), forces.tip_turns(leaf, 1)
    for stiffness, colour in zip(forces.STIFFNESSES, COLOURS):
        turned = to_stem[stiffness][:0:-1] + away[stiffness]
        tip.plot(both, turned, ".-", color=colour, lw=1.6, label=f"stiffness {stiffness:g}")
    tip.set_xlabel("wind, weights; left: to the stem")
    tip.set_ylabel("turn of the tip, degrees down")
    for k in sorted({turn.leaf for turn in turns}):
        of_leaf = [turn for turn in turns if turn.leaf == k]
        load.plot([turn.wanted for turn in of_leaf], [turn.load for turn in of_leaf], color=BLUE, lw=0.7, alpha=0.35)
    load.set_xlabel("wanted turn, degrees down")
    load.set_ylabel("load that gives it, weights")
    load.set_yscale("log")
    load.set_xticks(forces.TURNS)
    keys = [
        Line2D([], [], color=wind_colour(k), lw=1.8, label=f"wind {wind:g}") for k, wind in enumerate(forces.WINDS)
    ]
    save_figure(figure, keys + tip.get_legend_handles_labels()[0], 6, path)
