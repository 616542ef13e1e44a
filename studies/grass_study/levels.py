# SPDX-License-Identifier: Apache-2.0
"""Leaves with fewer and fewer triangles: the error in form, and the gain in time."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Callable, NamedTuple, Sequence

import numpy as np
from meristem import grass

from .measured import Floats, MeasuredLeaf

FULL_PIECES = 200
PIECES = (1, 2, 3, 4, 6, 8, 10, 12, 16, 20, 24, 28, 32)  #: 4 n - 2 triangles if the tip is a point
SAMPLES = 16  #: positions on each piece of a coarse midrib at which distances are measured
TEN_OF_A_HUNDRED = 0.01  #: bound on the median Hausdorff distance, as a share of the length
KEPT_AREA = 1e-6
#: Triangles and milliseconds of fit and mesh by the authors' open program (Python), as measured for this project.
AUTHORS = ((11, 0.86), (31, 0.94), (99, 1.24))
TIMED = 40  #: leaves
REPEATS = 5  #: timings of a leaf; the smallest one counts


@dataclass(frozen=True)
class Level:
    """Means over leaves for one number of pieces; errors are shares."""

    pieces: int
    triangles: int
    distance: float  #: median Hausdorff distance of the midribs, as a share of the length
    distance_tenth: float  #: the ninth decile
    area: float  #: median of the area lost or gained by the points alone
    area_tenth: float
    kept_area: float  #: largest error of the area after widths are scaled


class Time(NamedTuple):
    """Microseconds per leaf."""

    triangles: int
    mesh: float  #: reduce, and make the blade
    all: float  #: fit, reduce, and make the blade


def distance_to(points: Floats, line: Floats) -> Floats:
    """Returns the distance of each point to a polyline."""
    start, way = line[:-1], np.diff(line, axis=0)
    from_start = points[:, None, :] - start[None]
    share = np.clip((from_start * way).sum(2) / (way * way).sum(1), 0, 1)
    return np.asarray(np.hypot(*(from_start - share[..., None] * way).transpose(2, 0, 1)).min(1))


def sample(line: Floats) -> Floats:
    places = np.linspace(0, len(line) - 1, SAMPLES * (len(line) - 1) + 1)
    return np.column_stack([np.interp(places, np.arange(len(line)), column) for column in line.T])


def hausdorff(full: grass.GrassLeaf, coarse: grass.GrassLeaf) -> float:
    """Returns the Hausdorff distance between two midribs, in leaf lengths."""
    a, b = np.column_stack([full.x, full.y]), np.column_stack([coarse.x, coarse.y])
    return float(max(distance_to(a, b).max(), distance_to(sample(b), a).max()))


def measure_levels(leaves: Sequence[grass.GrassLeaf]) -> list[Level]:
    orders = [grass.reduction_order(leaf) for leaf in leaves]
    levels = []
    for pieces in PIECES:
        plain = [
            grass.reduced(leaf, points=grass.points_kept(order, pieces)) for leaf, order in zip(leaves, orders)
        ]
        distance = np.percentile([hausdorff(leaf, small) for leaf, small in zip(leaves, plain)], (50, 90))
        area = np.percentile([abs(leaf.width / small.width - 1) for leaf, small in zip(leaves, plain)], (50, 90))
        levels.append(
            Level(
                pieces=pieces,
                triangles=len(grass.make_grass_blade(plain[0]).triangles),
                distance=float(distance[0]),
                distance_tenth=float(distance[1]),
                area=float(area[0]),
                area_tenth=float(area[1]),
                kept_area=max(abs(small.area / leaf.area - 1) for leaf, small in zip(leaves, plain)),
            )
        )
    return levels


def points_are_nested(leaves: Sequence[grass.GrassLeaf]) -> bool:
    """Returns true if each level's points are a subset of the next finer level's points."""
    for leaf in leaves:
        order = grass.reduction_order(leaf)
        kept = [set(grass.points_kept(order, pieces).tolist()) for pieces in PIECES]
        if not all(coarse <= fine for coarse, fine in zip(kept, kept[1:])):
            return False
    return True


def ten_of_a_hundred(leaves: Sequence[MeasuredLeaf]) -> float:
    """Returns the median Hausdorff distance for 10 points kept out of 100."""
    distances = []
    for measured in leaves:
        leaf = measured.fit(pieces=99).leaf
        distances.append(hausdorff(leaf, grass.reduced(leaf, pieces=9)))
    return float(np.median(distances))


def least_time(call: Callable[[], object]) -> float:
    """Returns microseconds."""
    times = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return 1e6 * min(times)


def measure_times(leaves: Sequence[MeasuredLeaf]) -> list[Time]:
    """Returns means over TIMED leaves, called from Python, with points that are already arrays."""
    some = leaves[:: max(1, len(leaves) // TIMED)][:TIMED]
    fitted = [(leaf, leaf.fit(pieces=FULL_PIECES).leaf) for leaf in some]
    times = []
    for pieces in PIECES:

        def mesh(leaf: grass.GrassLeaf, pieces: int = pieces) -> object:
            return grass.make_grass_blade(grass.reduced(leaf, pieces=pieces))

        of_mesh = [least_time(lambda leaf=leaf: mesh(leaf)) for _, leaf in fitted]  # type: ignore[misc]
        of_all = [
            least_time(lambda leaf=leaf: mesh(leaf.fit(pieces=FULL_PIECES).leaf))  # type: ignore[misc]
            for leaf, _ in fitted
        ]
        triangles = len(grass.make_grass_blade(grass.reduced(fitted[0][1], pieces=pieces)).triangles)
        times.append(Time(triangles, float(np.median(of_mesh)), float(np.median(of_all))))
    return times
