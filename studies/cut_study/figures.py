# SPDX-License-Identifier: Apache-2.0
"""Draws the table beside the published one, trends of single trees, adaptations, growth and apical control."""

from __future__ import annotations

from pathlib import Path
from typing import Mapping, Sequence

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Patch, Rectangle

from common.style import BLUE, DOTS_PER_INCH, GREEN, ORANGE, RED, STYLE, new_figure, save_figure

from .adaptations import Effect
from .cuts import FALL, LATERALS, LEADER_SHARE, PUBLISHED, CutTree, Pair
from .growth import TRIAL, Curve, Habit

GREY = "#9a9a9a"
BARS = ((GREY, 0.35), (GREY, 0.9), (BLUE, 0.35), (BLUE, 0.9))  #: colour and opacity, in the order of draw_pairs()
SET_COLOURS = {"slim": BLUE, "full": RED, "markers": GREEN}


def draw_pairs(axes: Axes, names: Sequence[str], published: Sequence[Pair], ours: Sequence[Sequence[Pair]]) -> None:
    """Draws four bars for each name: published values without and with the cut, then our means with deciles."""
    places = np.arange(len(names))
    for k, (colour, alpha) in enumerate(BARS):
        at = places + 0.2 * (k - 1.5)
        if k < 2:
            axes.bar(at, [pair[k] for pair in published], width=0.18, color=colour, alpha=alpha)
            continue
        found = [np.array([pair[k - 2] for pair in pairs]) for pairs in ours]
        means = np.array([column.mean() for column in found])
        deciles = np.array([np.percentile(column, (10, 90)) for column in found]).T
        errors = np.maximum([means - deciles[0], deciles[1] - means], 0)
        axes.bar(at, means, width=0.18, color=colour, alpha=alpha, yerr=errors, error_kw={"lw": 1})
    axes.set_xticks(places, names)
    axes.grid(axis="x", visible=False)


def draw_table(path: Path, trees: Sequence[CutTree]) -> None:
    """Draws the published table, and our values with the deciles of the trees."""
    figure, [[left, right]] = new_figure(1, 2, 3.8)
    left.set_ylabel("resource")
    draw_pairs(
        left,
        ["whole tree", "leader"],
        [PUBLISHED.total, Pair(PUBLISHED.leader, 0)],
        [[tree.total for tree in trees], [Pair(tree.leader, 0) for tree in trees]],
    )
    draw_pairs(
        right,
        [f"lateral {k + 1}" for k in range(LATERALS)],
        PUBLISHED.laterals,
        [[tree.laterals[k] for tree in trees if len(tree.laterals) > k] for k in range(LATERALS)],
    )
    names = ("published, not cut", "published, cut", f"here, not cut, {len(trees)} trees", "here, cut")
    handles = [Patch(color=c, alpha=alpha, lw=0, label=name) for (c, alpha), name in zip(BARS, names)]
    save_figure(figure, handles, 2, path)


def draw_trends(path: Path, trees: Sequence[CutTree]) -> None:
    """Draws the leader's share and the loss of the tree, and the gain of each lateral; one dot per tree."""
    figure, [[left, right]] = new_figure(1, 2, 3.8)
    corner = (100 * LEADER_SHARE[0], 100 * FALL[0])
    sides = (100 * (LEADER_SHARE[1] - LEADER_SHARE[0]), 100 * (FALL[1] - FALL[0]))
    left.add_patch(Rectangle(corner, *sides, color="black", alpha=0.1, lw=0, label="expected"))
    for alike, colour, label in ((True, BLUE, "branched as published"), (False, ORANGE, "otherwise")):
        chosen = [tree for tree in trees if tree.is_alike == alike]
        shares, falls = [100 * tree.leader_share for tree in chosen], [100 * tree.fall for tree in chosen]
        left.plot(shares, falls, ".", color=colour, ms=7, alpha=0.6, mew=0, label=label)
        for k in range(LATERALS):
            having = [tree.laterals[k] for tree in chosen if len(tree.laterals) > k]
            gains = [100 * pair.gain / pair.uncut for pair in having]
            places = k + 1 + (0.12 if alike else -0.12) + np.linspace(-0.08, 0.08, len(gains))
            right.plot(places, gains, ".", color=colour, ms=5, alpha=0.6, mew=0)
    left.plot(100 * PUBLISHED.leader_share, 100 * PUBLISHED.fall, "x", color=RED, ms=9, mew=2.5, label="published")
    gains = [100 * pair.gain / pair.uncut for pair in PUBLISHED.laterals]
    right.plot(range(1, LATERALS + 1), gains, "x", color=RED, ms=9, mew=2.5)
    left.set_xlabel("leader, % of the total")
    left.set_ylabel("fall of the total, %")
    left.set_xlim(0)
    left.set_ylim(0)
    right.set_xlabel("lateral below the cut")
    right.set_ylabel("gain by the cut, %")
    right.set_xticks(range(1, LATERALS + 1))
    right.axhline(0, color="black", lw=0.8)
    save_figure(figure, left.get_legend_handles_labels()[0], 4, path)


def draw_adaptations(path: Path, effects: Mapping[str, Effect]) -> None:
    """Draws bars for each disabled adaptation."""
    panels = (
        ("Trees in which all\nlaterals rise, %", [100 * effect.cut.all_rise for effect in effects.values()]),
        ("Fall of the total, %", [100 * effect.cut.fall for effect in effects.values()]),
        ("Cut shoots that\ngrow on, %", [100 * effect.grows for effect in effects.values()]),
        ("Turn of what leads\non, degrees", [effect.turn for effect in effects.values()]),
    )
    figure, [row] = new_figure(1, len(panels), 3.2)
    places = np.arange(len(effects))
    for axes, (title, values) in zip(row, panels):
        axes.barh(places, values, color=[BLUE, *[RED] * (len(effects) - 1)], height=0.6)
        for place, value in zip(places, values):
            axes.annotate(f"{value:.3g}", (value, place), (3, 0), textcoords="offset points", va="center", fontsize=9)
        axes.set_xlim(0, 1.3 * max(values))
        axes.set_yticks(places, list(effects) if axes is row[0] else [""] * len(effects))
        axes.grid(axis="y", visible=False)
        axes.invert_yaxis()
        axes.set_title(title, loc="left", fontsize=10)
    figure.savefig(path, dpi=DOTS_PER_INCH)


def draw_growth(path: Path, curves: Mapping[str, Curve]) -> None:
    """Draws metamers and height over the iterations, with the values of the trial."""
    figure, [[left, right]] = new_figure(1, 2, 3.8)
    for name, curve in curves.items():
        iterations, colour = np.arange(len(curve.metamers)), SET_COLOURS[name]
        pairs = ((left, curve.metamers, curve.metamers_spread), (right, curve.height, curve.height_spread))
        for axes, mean, spread in pairs:
            axes.fill_between(iterations[1:], (mean - spread)[1:], (mean + spread)[1:], color=colour, alpha=0.16, lw=0)
            axes.plot(iterations[1:], mean[1:], color=colour, lw=2, label=name)
        for trial in TRIAL.get(name, ()):
            left.plot(trial.iteration, trial.metamers, "o", color=colour, mfc="white")
            if trial.height is not None:
                right.plot(trial.iteration, trial.height, "o", color=colour, mfc="white")
    left.plot([], [], "o", color="black", mfc="white", label="trial")
    left.set_yscale("log")
    left.set_ylabel("metamers")
    right.set_ylabel("height, metamers")
    for axes in (left, right):
        axes.set_xlabel("iteration")
    save_figure(figure, left.get_legend_handles_labels()[0], 4, path)


def draw_lambda(path: Path, habits: Mapping[str, Mapping[float, Habit]]) -> None:
    """Draws habits over lambda."""
    figure, [row] = new_figure(1, 3, 3.4)
    ordinates = ("height, metamers", "height over spread", "metamers")
    for name, of_set in habits.items():
        values = sorted(of_set)
        columns = (
            [of_set[value].height for value in values],
            [of_set[value].slenderness for value in values],
            [of_set[value].metamers for value in values],
        )
        for axes, column, ordinate in zip(row, columns, ordinates):
            axes.plot(values, column, ".-", color=SET_COLOURS[name], lw=1.8, ms=7, label=name)
            axes.set_xlabel("lambda")
            axes.set_ylabel(ordinate)
    row[0].set_ylim(0)
    row[1].set_ylim(0)
    row[2].set_yscale("log")
    save_figure(figure, row[0].get_legend_handles_labels()[0], 2, path)


def draw_figures(
    folder: Path,
    trees: Sequence[CutTree],
    effects: Mapping[str, Effect],
    curves: Mapping[str, Curve],
    habits: Mapping[str, Mapping[float, Habit]],
) -> None:
    """Draws all figures except the pictures of trees, as PNG files in `folder`."""
    with matplotlib.rc_context(STYLE):
        draw_table(folder / "table.png", trees)
        draw_trends(folder / "trends.png", trees)
        draw_adaptations(folder / "adaptations.png", effects)
        draw_growth(folder / "growth.png", curves)
        draw_lambda(folder / "lambda.png", habits)
