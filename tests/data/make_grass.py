#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes grass/: synthetic leaves of a cereal in the forms in which measured leaves are published.

`make_grass.py [FOLDER]` writes below FOLDER, or below its own folder. No measurement is in these files. A midrib bends
from its angle at the stem to its angle at the tip. Its points have the errors of a person who clicks on a photograph.
All random numbers have a fixed seed.

- `midribs.csv`: 72 midribs of six ranks, in cm. x points away from the stem, y up.
- `widths.csv`: a width profile for each rank. s goes from 0 to 1, r is width / largest width.
- `few_widths.csv`: two profiles with quoted names of columns.
- `midribs_by_age.csv`: the midribs of two classes of leaves at 15 ages, without errors, of length 1.
- `blades.json`: 12 blades as arrays x, y, s, r in cm. Each array is base64 of 64-bit floats, little-endian.
"""

from __future__ import annotations

import base64
import json
import math
import random
import struct
import sys
from pathlib import Path

RANKS = 6
LEAVES_OF_A_RANK = 12
AGES = 15
Points = list[tuple[float, float]]


def midrib(places: list[float], base: float, tip: float, power: float) -> Points:
    """Returns points of a midrib of length 1 at these shares of the length. The direction goes from `base` to `tip`
    degrees away from the stem; a larger power bends more of that near the tip."""
    steps = 600
    line = [(0.0, 0.0)]
    for k in range(steps):
        angle = math.radians(base + (tip - base) * ((k + 0.5) / steps) ** power)
        x, y = line[-1]
        line.append((x + math.sin(angle) / steps, y + math.cos(angle) / steps))
    return [line[round(place * steps)] for place in places]


def uneven_places(draws: random.Random, count: int) -> list[float]:
    """Returns shares of a length from 0 to 1, with unequal steps."""
    steps = [1 + draws.random() for _ in range(count - 1)]
    places = [0.0]
    for step in steps:
        places.append(places[-1] + step / sum(steps))
    return [*places[:-1], 1.0]


def measured_midrib(draws: random.Random, rank: int) -> Points:
    """Returns a midrib in cm with errors of 0.2 % of its length in each point but the first."""
    length = 14 + 3 * rank + 8 * draws.random()
    base, turn = 8 + 22 * draws.random(), 20 + 110 * draws.random()
    ideal = midrib(uneven_places(draws, draws.randint(10, 18)), base, base + turn, 1.2 + 1.3 * draws.random())
    error = [0.0, *([0.002] * (len(ideal) - 1))]
    return [
        (length * (x + of * (2 * draws.random() - 1)), length * (y + of * (2 * draws.random() - 1)))
        for (x, y), of in zip(ideal, error)
    ]


def width(s: float, base: float, widest: float) -> float:
    """Returns the share of the largest width: `base` at s = 0, 1 at `widest`, and 0 at the tip."""
    if s < widest:
        return 1 - (1 - base) * (1 - s / widest) ** 2
    return 1 - ((s - widest) / (1 - widest)) ** 2.2


def write_midribs(folder: Path) -> None:
    draws = random.Random(1)
    lines = ["rank,lindex,x,y"]
    for rank in range(1, RANKS + 1):
        for leaf in range(LEAVES_OF_A_RANK):
            lines += [f"{rank},{leaf},{x:.3f},{y:.3f}" for x, y in measured_midrib(draws, rank)]
    (folder / "midribs.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


def write_widths(folder: Path) -> None:
    lines = ["rankclass,s,r"]
    for rank in range(1, RANKS + 1):
        for k in range(21):
            lines.append(f"{rank},{k / 20:g},{width(k / 20, 0.4 + 0.05 * rank, 0.2 + 0.04 * rank):.4f}")
    (folder / "widths.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    few = ['"rankclass","s","r"']
    for rank in (1, 2):
        few += [f"{rank},{k / 10:g},{width(k / 10, 0.5 + 0.1 * rank, 0.35):.4f}" for k in range(11)]
    (folder / "few_widths.csv").write_text("\n".join(few) + "\n", encoding="utf-8")


def write_ages(folder: Path) -> None:
    """Leaves of class 1 hang in the end, leaves of class 2 stay more upright. Both bend most at a middle age."""
    lines = ['"age","x","y","lindex"']
    for leaf_class, tip in ((1, 125), (2, 80)):
        for k in range(AGES):
            age = 0.5 * k
            share = 1 / (1 + math.exp(1.6 * (2.5 - age)))
            base = 4 + 14 * share
            points = midrib([n / 25 for n in range(26)], base, base + tip * share, 2.4 - 0.8 * share)
            lines += [f"{age:g},{x:.5f},{y:.5f},{leaf_class}" for x, y in points]
    (folder / "midribs_by_age.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


def stored(numbers: list[float]) -> dict:
    data = base64.b64encode(struct.pack(f"<{len(numbers)}d", *numbers)).decode()
    return {"__ndarray__": data, "dtype": "float64", "shape": [len(numbers)]}


def write_blades(folder: Path) -> None:
    draws = random.Random(2)
    blades: dict[str, list] = {}
    for rank in range(1, 13):
        length = 30 + 5 * rank - 0.3 * rank * rank
        base, turn = 15 + 10 * draws.random(), 60 + 70 * draws.random()
        points = midrib([k / 20 for k in range(21)], base, base + turn, 1.5)
        x, y = ([round(length * point[axis], 3) for point in points] for axis in (0, 1))
        s = [round(length * k / 20, 3) for k in range(21)]
        r = [round(7.5 * width(k / 20, 0.6, 0.4), 3) for k in range(21)]
        blades[str(rank)] = [[stored(x), stored(y), stored(s), stored(r)]]
    (folder / "blades.json").write_text(json.dumps(blades, indent=0) + "\n", encoding="utf-8")


def main() -> None:
    folder = (Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent) / "grass"
    write_midribs(folder)
    write_widths(folder)
    write_ages(folder)
    write_blades(folder)


if __name__ == "__main__":
    main()
