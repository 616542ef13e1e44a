# SPDX-License-Identifier: Apache-2.0
"""Batches: plants of many seeds and parameters on all cores, as one table."""

from __future__ import annotations

import itertools
import random

import numpy as np

import meristem


def lean(plant: meristem.Plant) -> float:
    """Returns the horizontal distance from the root to the mean of the nodes, in metres. Workers import this module to
    find the function."""
    position = plant.stems[0].skeleton.position
    offset = position.mean(axis=0) - position[0]
    return float(np.hypot(offset[0], offset[2]))


def main() -> None:
    bush = meristem.read("bush", set={"leafiness": 0})

    # All combinations of a grid, each with three seeds, measured by name.
    grid = {"branches": [300, 900], "crown_height": [2, 4]}
    batch = meristem.batch(bush, seeds=range(3), grid=grid, measure=["length", "crown_hull_volume"])
    table = meristem.collect(batch)
    for branches, height in np.unique(table[["branches", "crown_height"]]):
        rows = table[(table["branches"] == branches) & (table["crown_height"] == height)]
        wood = rows["length"] / rows["crown_hull_volume"]
        density = f"{wood.mean():.1f} m of wood in a cubic metre (+- {wood.std():.1f})"
        print(f"{branches:3} branches, {height} m high: {density}")

    # Endless random samples and a function of the plant; the loop decides when to stop.
    generator = random.Random(1)
    samples = ({"branches": 300, "crown_width": generator.uniform(1, 6)} for _ in itertools.count())
    for count, plant in enumerate(meristem.batch(bush, seeds=[1], samples=samples, measure=lean), 1):
        if plant.result < 0.02:
            width = plant.values["crown_width"]
            print(f"plant {count}, {width:.2f} m wide, stands upright: it leans by {100 * plant.result:.1f} cm")
            break


if __name__ == "__main__":
    main()
