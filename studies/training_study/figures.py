# SPDX-License-Identifier: Apache-2.0
"""The figures of the study."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Sequence

import matplotlib
import numpy as np
from matplotlib.figure import Figure

from common.style import BLUE, DOTS_PER_INCH, GREEN, ORANGE, RED, STYLE, new_figure, save_figure

from . import cordon, espalier, pole, vase
from .bud import Branch
from .espalier import Upkeep
from .trees import SETS, SLIM, make_document

SIZE = (300, 340)  #: size of a picture, pixels
SERIES = (3, 6, 9, 12, 15)


def draw_poles(path: Path, seeds: Sequence[int]) -> None:
    """Draws distances along the stem, as in the source's figure 5.1."""
    with matplotlib.rc_context(STYLE):
        figure, [axes] = new_figure(1, 2, 3.4)
        handles: list[Any] = []
        for ax, name in zip(axes, SETS):
            for weight, colour in zip(pole.WEIGHTS, (RED, ORANGE, BLUE)):
                all_stems = [pole.distances(name, weight, seed) for seed in seeds]
                length = min(len(stem) for stem in all_stems)
                mean = np.mean([stem[:length] for stem in all_stems], axis=0)
                for stem in all_stems[:5]:
                    ax.plot(np.arange(1, len(stem) + 1), stem, color=colour, alpha=0.25, linewidth=0.8)
                label = "without a pole" if weight == 0 else f"pole, weight {weight:g}"
                [line] = ax.plot(np.arange(1, length + 1), mean, color=colour, linewidth=2, label=label)
                if ax is axes[0]:
                    handles.append(line)
            ax.set_title(f"{name} set")
            ax.set_xlabel("metamer of the stem")
            ax.set_ylabel("distance from the pole, metamers")
        save_figure(figure, handles, 3, path)


def draw_upkeep(path: Path, rows: Sequence[Upkeep]) -> None:
    with matplotlib.rc_context(STYLE):
        figure, [[ax]] = new_figure(1, 1, 3.4)
        handles: list[Any] = []
        for name, colour in zip((*espalier.UPKEEP, espalier.VIGOROUS_UPKEEP), (GREEN, ORANGE, RED, BLUE)):
            own = [row for row in rows if row.upkeep == name]
            handles += ax.plot([r.iteration for r in own], [r.metamers for r in own], color=colour, label=name)
        ax.set_yscale("log")
        ax.set_xlabel("iteration")
        ax.set_ylabel("metamers")
        save_figure(figure, handles, 3, path)


def draw_buds(path: Path, branches: Sequence[Branch]) -> None:
    with matplotlib.rc_context(STYLE):
        figure, [[ax]] = new_figure(1, 1, 3.4)
        stretch = ax.plot([b.stretch for b in branches], [b.stretch_cut for b in branches], "o", color=BLUE, ms=4,
                          label="from the cut to the third metamer above it")  # fmt: skip
        whole = ax.plot([b.whole for b in branches], [b.whole_cut for b in branches], "s", color=ORANGE, ms=4,
                        label="from the branch's base")  # fmt: skip
        ax.axline((40, 40), slope=1, color="#999999", linewidth=0.8)
        ax.set_xlabel("without the cut, degrees above the horizontal")
        ax.set_ylabel("with the cut")
        save_figure(figure, [*stretch, *whole], 2, path)


def draw_row(path: Path, titles: Sequence[str], documents: Sequence[Any], view: tuple[float, float] | None = None) -> None:
    """Draws pictures side by side, each with its own scale."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(9, 9 * SIZE[1] / SIZE[0] / len(documents) + 0.5), layout="constrained")
        for axes, title, document in zip(np.atleast_1d(figure.subplots(1, len(documents))), titles, documents):
            plant = document.grow()
            height = float(plant.stems[0].skeleton.position[:, 1].max())
            axes.imshow(plant.render(size=SIZE, samples=24, transparent=True, view=view))
            axes.set_title(f"{title}\n{height:.1f} m high", fontsize=9)
            axes.axis("off")
        figure.savefig(path, dpi=DOTS_PER_INCH)


def draw_pictures(folder: Path, seed: int) -> None:
    def slim(iterations: int, operations: Sequence[Any] = ()) -> Any:
        return make_document(SLIM, iterations, seed, operations)

    shown: list[dict[str, Any]] = [
        {**operation, "thickness": 0.02, "line": [[0, 0, 0], [0, 2.6, 0]]} for operation in pole.pole_of(4)
    ]
    draw_row(folder / "pole.png", ("without a pole", "with a pole"), (slim(18), slim(18, shown)))
    cut = vase.operations(10)
    draw_row(
        folder / "vase.png",
        ("10 iterations", "cut", "25 iterations, not cut", "25 iterations, cut"),
        (slim(10), slim(10, cut), slim(25), slim(25, cut)),
    )

    def trained(iterations: int, settings: Any = espalier.ESPALIER, upkeep: str = "spurs and limit") -> Any:
        return make_document(settings, iterations, seed, [*espalier.layers(), *espalier.UPKEEP[upkeep]])

    front = (180.0, 4.0)
    draw_row(folder / "espalier.png", [f"{k} iterations" for k in SERIES], [trained(k) for k in SERIES], front)
    draw_row(
        folder / "adaptations.png",
        list(espalier.ADAPTATIONS),
        [trained(espalier.SEEN, settings) for settings in espalier.ADAPTATIONS.values()],
        front,
    )
    draw_row(
        folder / "upkeep.png",
        list(espalier.UPKEEP),
        [trained(espalier.SEEN, upkeep=name) for name in espalier.UPKEEP],
        front,
    )
    draw_row(
        folder / "cordon.png",
        list(cordon.LIGHTS),
        [
            make_document(settings, cordon.ITERATIONS, seed, cordon.operations(), scene=scene)
            for settings, scene in cordon.LIGHTS.values()
        ],
        front,
    )
