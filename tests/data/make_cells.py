#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes reference/ambiguous_cells.csv: cells of a grid whose signs alone do not tell how the surface runs through them.

`make_cells.py [FOLDER]` writes below FOLDER, or below its own folder. A row has the values at the eight corners, with
the index 4 x + 2 y + z. It also has the topology of the trilinear function's zero surface: its components, its Euler
number and the loops of its border.

The topology comes from dense samples. The cell is cut into cubes, and each cube is in or out by the sign at its centre.
The surface is the set of squares between cubes of different signs. A cell counts if two densities agree, if the cubes at
the corners have the signs of the corners, and if no edge is touched by more than two squares.
The values are random, from a fixed seed. Every second cell has a tunnel.
"""

from __future__ import annotations

import random
import sys
from itertools import product
from pathlib import Path
from typing import NamedTuple

DENSITIES = (15, 24)
CELLS = 12

Values = tuple[float, ...]
Point = tuple[int, int, int]


class Topology(NamedTuple):
    components: int
    euler: int
    boundaries: int


def is_ambiguous(values: Values) -> bool:
    """Returns true if a face has equal signs at opposite corners only, or if only two opposite corners of the cell have
    their sign."""
    signs = [value < 0 for value in values]
    for axis, side in product((4, 2, 1), (0, 1)):
        others = [other for other in (4, 2, 1) if other != axis]
        a, b, c, d = (axis * side + others[0] * i + others[1] * j for i, j in ((0, 0), (0, 1), (1, 1), (1, 0)))
        if signs[a] == signs[c] != signs[b] == signs[d]:
            return True
    for sign in (True, False):
        of_sign = [corner for corner in range(8) if signs[corner] == sign]
        if len(of_sign) == 2 and of_sign[0] + of_sign[1] == 7:
            return True
    return False


def trilinear(values: Values, x: float, y: float, z: float) -> float:
    total = 0.0
    for corner, value in enumerate(values):
        total += value * (x if corner & 4 else 1 - x) * (y if corner & 2 else 1 - y) * (z if corner & 1 else 1 - z)
    return total


def components_of(sides: list[list]) -> int:
    """Returns the number of groups. The items of each list are in one group."""
    leader: dict = {}

    def find(item):  # type: ignore[no-untyped-def]
        while leader.setdefault(item, item) != item:
            leader[item] = leader[leader[item]]
            item = leader[item]
        return item

    for group in sides:
        for item in group:
            leader[find(item)] = find(group[0])
    return len({find(item) for item in list(leader)})


def squares_of(values: Values, n: int) -> list[list[Point]]:
    """Returns the corners of the squares between cubes of different signs, in order around each square."""
    centres = [(k + 0.5) / n for k in range(n)]
    is_in = {at: trilinear(values, *(centres[k] for k in at)) < 0 for at in product(range(n), repeat=3)}
    squares = []
    for at in is_in:
        for axis in range(3):
            beyond = tuple(k + (i == axis) for i, k in enumerate(at))
            if beyond not in is_in or is_in[at] == is_in[beyond]:
                continue
            b, c = (i for i in range(3) if i != axis)
            square = []
            for db, dc in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = list(beyond)
                corner[b] += db
                corner[c] += dc
                square.append((corner[0], corner[1], corner[2]))
            squares.append(square)
    return squares


def topology_of(values: Values, n: int) -> Topology | None:
    """Returns nothing if the samples are too few to tell."""
    near = (0.5 / n, 1 - 0.5 / n)
    for corner, value in enumerate(values):
        if (trilinear(values, near[corner >> 2], near[corner >> 1 & 1], near[corner & 1]) < 0) != (value < 0):
            return None
    touching: dict[tuple[Point, Point], int] = {}
    squares = squares_of(values, n)
    for square in squares:
        for k in range(4):
            edge = tuple(sorted((square[k], square[(k + 1) % 4])))
            touching[edge] = touching.get(edge, 0) + 1  # type: ignore[index, arg-type]
    if not squares or max(touching.values()) > 2:
        return None
    border = [list(edge) for edge, count in touching.items() if count == 1]
    ends: dict[Point, int] = {}
    for edge in border:
        for point in edge:
            ends[point] = ends.get(point, 0) + 1
    if any(count != 2 for count in ends.values()):
        return None
    points = {point for square in squares for point in square}
    euler = len(points) - len(touching) + len(squares)
    return Topology(components_of(squares), euler, components_of(border))  # type: ignore[arg-type]


def sampled_topology(values: Values) -> Topology | None:
    """Returns nothing if two densities disagree."""
    coarse = topology_of(values, DENSITIES[0])
    return coarse if coarse is not None and coarse == topology_of(values, DENSITIES[1]) else None


def drawn_values(draws: random.Random, reaches: bool) -> Values:
    """Returns random values. If `reaches`, two opposite corners reach for each other through the cell."""
    if not reaches:
        return tuple(round(10 * draws.random() - 5, 1) for _ in range(8))
    values = [round(0.2 + 1.8 * draws.random(), 1) for _ in range(8)]
    corner = draws.randrange(4)
    for end in (corner, 7 - corner):
        values[end] = round(-3 - 6 * draws.random(), 1)
    return tuple(values)


def cells() -> list[tuple[Values, Topology]]:
    """Returns as many cells with tunnels as without. Cells without a tunnel differ in topology or in the
    number of negative corners."""
    draws = random.Random(11)
    kept: list[tuple[Values, Topology]] = []
    seen = set()
    while len(kept) < CELLS:
        wants_tunnel = len(kept) % 2 == 1
        values = drawn_values(draws, wants_tunnel)
        key = sum(value < 0 for value in values)
        if 0 in values or not is_ambiguous(values):
            continue
        topology = sampled_topology(values)
        if topology is None or (topology.euler != topology.components) != wants_tunnel:
            continue
        if wants_tunnel or (topology, key) not in seen:
            seen.add((topology, key))
            kept.append((values, topology))
    return kept


def main() -> None:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    lines = ["case,v0,v1,v2,v3,v4,v5,v6,v7,iso,components,euler,boundaries"]
    for number, (values, topology) in enumerate(cells()):
        lines.append(",".join([f"cell_{number}", *(f"{value:g}" for value in values), "0", *map(str, topology)]))
    (folder / "reference" / "ambiguous_cells.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
