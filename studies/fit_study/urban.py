# SPDX-License-Identifier: Apache-2.0
"""Compares shipped broad-leaved trees with measured urban trees of their species.

The bands are the 5th to the 95th percentile of height, diameter at 1.3 m, crown diameter and their ratios, over trees
of all ages. The data are not part of the project: they are in `shared/data` beside it, or in the folder that
MERISTEM_SHARED_DATA names, in `trees/urban_tree_ranges.csv`.
Based on: E. G. McPherson, N. S. van Doorn, P. J. Peper: Urban tree database (Forest Service Research Data Archive
2016).
"""

from __future__ import annotations

import csv
import math
import os
from dataclasses import dataclass
from pathlib import Path

import meristem
import numpy as np

BESIDE_THE_PROJECT = Path(__file__).resolve().parents[3] / "shared" / "data"
FILE = Path(os.environ.get("MERISTEM_SHARED_DATA", BESIDE_THE_PROJECT)) / "trees" / "urban_tree_ranges.csv"
BREAST_HEIGHT = 1.3  #: metres

#: Names of the file's columns by quantity, and the factor to metres
QUANTITIES = {
    "height": ("height_m", 1.0),
    "diameter": ("DBH_cm", 0.01),
    "crown": ("crown_diam_m", 1.0),
    "height_over_diameter": ("H_over_D", 1.0),
    "crown_over_height": ("crown_over_H", 1.0),
    "crown_over_diameter": ("crown_over_D", 1.0),
}


@dataclass(frozen=True)
class Species:
    model: str
    name: str  #: name of the plant in its document
    measured: str | None  #: species in the file, or its closest relative; None: all broad-leaved trees
    size: str | None = None  #: the variable that determines age or size
    sizes: tuple[float, ...] = ()  #: values over its whole range, except the document's own value


SPECIES = (
    Species("apple", "Malus domestica", "Malus sp."),
    Species("birch", "Betula pendula", "Betula pendula", "tree_height", (4, 8, 15, 20)),
    Species("chestnut", "Aesculus hippocastanum", None, "tree_height", (8, 11, 17, 20)),
    Species("elm", "American elm", "Ulmus americana", "age", (3, 4, 5, 7)),
    Species("hawthorn", "Crataegus monogyna", "Crataegus x lavallei", "age", (8, 20, 28, 38)),
    Species("large-maple", "Acer pseudoplatanus", "Acer platanoides", "tree_height", (14, 18, 25)),
    Species("lime", "Tilia cordata", "Tilia cordata", "age", (6, 14, 20, 34, 40)),
    Species("maple", "Acer platanoides", "Acer platanoides"),
    Species("oak", "Quercus robur", "Quercus lobata", "age", (8, 20, 60, 100, 160)),
    Species("old-oak", "Quercus robur", "Quercus lobata", "age", (40, 100, 150, 215)),
    Species("weeping-beech", "Fagus sylvatica", None, "age", (20, 40, 60, 76)),
)
#: Ratios of open-grown broad-leaved trees of all species
ALL_BROAD_LEAVED = {"height_over_diameter": (16.0, 31.0, 64.0), "crown_over_height": (0.39, 0.80, 1.30)}
THINNEST = 0.08  #: metres; approximate begin of the diameter bands of most species

Bands = dict[str, tuple[float, float, float]]  #: 5th, 50th and 95th percentile of each quantity


def read_bands(measured: str | None, path: Path = FILE) -> Bands:
    """Returns the bands of a species of the file. Without a species, returns the bands of all broad-leaved
    trees."""
    if measured is None:
        return dict(ALL_BROAD_LEAVED)
    with open(path, newline="", encoding="utf-8") as file:
        [row] = [row for row in csv.DictReader(file) if row["species"] == measured]
    bands: Bands = {}
    for quantity, (column, factor) in QUANTITIES.items():
        low, middle, high = (factor * float(row[f"{column}_{percentile}"]) for percentile in ("p5", "p50", "p95"))
        bands[quantity] = (low, middle, high)
    return bands


def breast_diameter(skeleton: meristem.Skeleton) -> float:
    """Returns the diameter of the thickest stem 1.3 m above the root, NaN if no stem passes this height."""
    parent = skeleton.parent
    node = np.flatnonzero(parent >= 0)
    parent = parent[node]
    rise, radius = (values.astype(float) for values in (skeleton.position[:, 1] - skeleton.position[0, 1], skeleton.radius))
    passes = (np.minimum(rise[node], rise[parent]) <= BREAST_HEIGHT) & (BREAST_HEIGHT < np.maximum(rise[node], rise[parent]))
    node, parent = node[passes], parent[passes]
    if node.size == 0:
        return math.nan
    share = (BREAST_HEIGHT - rise[parent]) / (rise[node] - rise[parent])
    return float(2 * np.max(radius[parent] + share * (radius[node] - radius[parent])))


def measure_tree(plant: meristem.Plant) -> dict[str, float]:
    """Returns the quantities of a tree, from its tallest skeleton."""
    skeleton = max((stem.skeleton for stem in plant.stems), key=lambda one: float(one.position[:, 1].max()))
    measures = skeleton.measure(threads=1, crown_rays=1000)
    height, crown, diameter = measures["height"], measures["crown_mean_width"], breast_diameter(skeleton)
    return {
        "height": height,
        "diameter": diameter,
        "crown": crown,
        "height_over_diameter": height / diameter,
        "crown_over_height": crown / height,
        "crown_over_diameter": crown / diameter,
    }


def outside_ratios(found: dict[str, float], bands: Bands) -> list[str]:
    """Returns the ratios outside their bands for a tree as thick as measured trees. Empty for a thinner tree."""
    thinnest = bands["diameter"][0] if "diameter" in bands else THINNEST
    if found["diameter"] < thinnest:
        return []
    return outside(found, {name: band for name, band in bands.items() if "_over_" in name})


def outside(found: dict[str, float], bands: Bands) -> list[str]:
    """Describes the quantities outside their bands."""
    return [
        f"{quantity} is {found[quantity]:.3g}, beyond {low:.3g} to {high:.3g}"
        for quantity, (low, _, high) in bands.items()
        if not low <= found[quantity] <= high
    ]
