# SPDX-License-Identifier: Apache-2.0
"""Pictures of trees with and without the cut, side by side as in the source's figure 5.2."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import matplotlib
from matplotlib.figure import Figure

from common.style import DOTS_PER_INCH, STYLE

from .adaptations import ADAPTATIONS
from .cuts import compare_cut, find_cut
from .trees import Settings, make_document

SEEN = 19  #: iterations
SIZE = (260, 520)  #: pixels
MOST_SEEDS = 1000


class Picture(NamedTuple):
    title: str
    settings: Settings
    is_cut: bool


PICTURES = (
    Picture("not cut", ADAPTATIONS["all on"], False),
    Picture("cut", ADAPTATIONS["all on"], True),
    Picture("cut, and grown again", ADAPTATIONS["cut buds grow again"], True),
    Picture("cut, laterals as terminals", ADAPTATIONS["laterals open as terminals"], True),
)


def find_seed() -> int:
    """Returns the seed of the first tree that is branched like the published one."""
    for seed in range(MOST_SEEDS):
        tree = compare_cut(ADAPTATIONS["all on"], seed)
        if tree is not None and tree.is_alike:
            return seed
    raise RuntimeError(f"none of {MOST_SEEDS} trees is branched as the published one")


def draw_trees(path: Path) -> None:
    seed = find_seed()
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(9, 5), layout="constrained")
        for axes, picture in zip(figure.subplots(1, len(PICTURES)), PICTURES):
            cut = find_cut(picture.settings, seed) if picture.is_cut else None
            plant = make_document(picture.settings, SEEN, seed, cut).grow()
            height = float(plant.stems[0].skeleton.position[:, 1].max())
            axes.imshow(plant.render(size=SIZE, transparent=True))
            axes.set_title(f"{picture.title}\n{height:.1f} m high", fontsize=10)
            axes.axis("off")
        figure.savefig(path, dpi=DOTS_PER_INCH)
