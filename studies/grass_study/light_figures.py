# SPDX-License-Identifier: Apache-2.0
"""Draws the light on each leaf of a plant."""

from __future__ import annotations

from pathlib import Path
from typing import Mapping

import matplotlib
import numpy as np

from common.style import BLUE, ORANGE, RED, STYLE, new_figure, save_figure

from .light import LIGHTS, Case, Lit
from .plants import ALONE, CHORD, CURVED, ERECT, FIELD

FORM_COLOURS = {CURVED: BLUE, ERECT: RED, CHORD: ORANGE}


def draw_light(path: Path, plant: str, lit: Mapping[Case, Lit]) -> None:
    """Draws the light of each leaf by rank, alone and in a field, under the sky and the sun."""
    with matplotlib.rc_context(STYLE):
        figure, rows = new_figure(2, len(LIGHTS), 5.6)
        for row, stand in zip(rows, (ALONE, FIELD)):
            for axes, light in zip(row, LIGHTS):
                for form, colour in FORM_COLOURS.items():
                    of = lit[Case(plant, form, stand.name, light)]
                    ranks = np.arange(1, len(of.taken) + 1)
                    axes.plot(ranks, 1e4 * of.taken, ".-", color=colour, lw=1.8, ms=7, label=form)
                axes.set_title(f"{stand.name}, {light}", loc="left", fontsize=10)
                axes.set_ylim(0)
            row[0].set_ylabel("light taken, cm² of open ground")
        for axes in rows[-1]:
            axes.set_xlabel("leaf, from the base up")
        save_figure(figure, rows[0][0].get_legend_handles_labels()[0], 3, path)
