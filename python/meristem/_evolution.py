# SPDX-License-Identifier: Apache-2.0
"""A search for the lowest value in a box, by evolution.

In: the value of each requested point. Out: the points to try next. Each generation is drawn about a mean. Its better
half moves the mean, and shapes the matrix that multiplies draws. The search therefore stretches along valleys and
shrinks near a minimum. Draws that leave the box are reflected at its walls.

Every draw is a function of the key, the generation, the point and the coordinate, and all sums are rounded once. The
points are therefore equal to the bit wherever the values are computed. The search uses no derivatives, and only the
order of the values. Based on: H.-G. Beyer, B. Sendhoff: Simplify your covariance matrix adaptation evolution strategy
(IEEE Transactions on Evolutionary Computation 21, 2017), figure 3. The settings come from N. Hansen: The CMA evolution
strategy, a tutorial (2016), table 1, without the negative weights.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Sequence
from statistics import NormalDist

_NORMAL = NormalDist()


def uniform(*key: object) -> float:
    """Returns a number above 0 and below 1, a function of the key alone."""
    digest = hashlib.blake2b(repr(key).encode(), digest_size=8).digest()
    return (int.from_bytes(digest, "big") // 4096 + 0.5) / 2.0**52


def normal(*key: object) -> float:
    """Returns a number of the normal distribution, a function of the key alone."""
    return _NORMAL.inv_cdf(uniform(*key))


def latin_hypercube(count: int, dimensions: int, *key: object) -> list[list[float]]:
    """Returns points of the unit box. Along each axis, each of `count` slices holds one point."""
    columns = []
    for axis in range(dimensions):
        order = sorted(range(count), key=lambda row: uniform(*key, "slice", axis, row))
        columns.append([(place + uniform(*key, "within", axis, row)) / count for row, place in enumerate(order)])
    return [list(point) for point in zip(*columns)]


class Evolution:
    """The search, with `ask`, `tell` and `should_stop` as in the package cmaes."""

    def __init__(
        self, mean: Sequence[float], sigma: float, *, population_size: int | None = None, key: object = 0
    ) -> None:
        """Begins in the unit box, with points about `mean` and a standard deviation of `sigma`.

        A larger population is slower and less easily caught in a local minimum.
        """
        dimensions = len(mean)
        self.population_size = population_size or 4 + int(3 * math.log(dimensions))
        self._key = key
        self._generation = 0
        self._asked = 0
        self._mean = [float(number) for number in mean]
        self._sigma = sigma
        self._matrix = [[float(row == column) for column in range(dimensions)] for row in range(dimensions)]
        self._path = [0.0] * dimensions
        raw = [
            math.log((self.population_size + 1) / 2) - math.log(rank + 1) for rank in range(self.population_size // 2)
        ]
        self._weights = [weight / math.fsum(raw) for weight in raw]
        effective = 1 / math.fsum(weight**2 for weight in self._weights)
        self._effective = effective
        self._path_rate = (effective + 2) / (dimensions + effective + 5)
        self._one_rate = 2 / ((dimensions + 1.3) ** 2 + effective)
        self._many_rate = min(
            1 - self._one_rate, 2 * (effective - 2 + 1 / effective) / ((dimensions + 2) ** 2 + effective)
        )
        self._damping = 1 + self._path_rate + 2 * max(0.0, math.sqrt((effective - 1) / (dimensions + 1)) - 1)
        #: of a normal vector
        self._usual_length = math.sqrt(dimensions) * (1 - 1 / (4 * dimensions) + 1 / (21 * dimensions**2))
        self._unfolded: dict[tuple[float, ...], list[float]] = {}  #: the draw of each requested point

    @property
    def sigma(self) -> float:
        """Returns the present standard deviation of points, as a share of the box."""
        return self._sigma

    @property
    def mean(self) -> list[float]:
        """Returns the mean of the next points."""
        return [folded(number) for number in self._mean]

    def ask(self) -> list[float]:
        """Returns the next point of the generation."""
        draw = [normal(self._key, self._generation, self._asked, axis) for axis in range(len(self._mean))]
        self._asked += 1
        step = _times(self._matrix, draw)
        point = [folded(centre + self._sigma * move) for centre, move in zip(self._mean, step)]
        self._unfolded[tuple(point)] = draw
        return point

    def tell(self, solutions: Sequence[tuple[Sequence[float], float]]) -> None:
        """Accepts the generation's points with their values; lower values are better.

        The points may include points that ask() did not return. They count as if they had been drawn.
        """
        # Sorting is stable, so of equal points the earlier point wins.
        best = sorted(solutions, key=lambda solution: solution[1])[: len(self._weights)]
        draws = [self._draw_of(point) for point, _ in best]
        steps = [_times(self._matrix, draw) for draw in draws]
        weights = self._weights[: len(best)]
        axes = range(len(self._mean))

        # The mean moves to the better points.
        mean_draw = [math.fsum(weight * draw[axis] for weight, draw in zip(weights, draws)) for axis in axes]
        for axis in axes:
            move = math.fsum(weight * step[axis] for weight, step in zip(weights, steps))
            self._mean[axis] = folded(self._mean[axis] + self._sigma * move)

        # The path sums up recent moves. A path longer than expected by chance makes steps larger.
        rate = self._path_rate
        gain = math.sqrt(rate * (2 - rate) * self._effective)
        self._path = [(1 - rate) * past + gain * now for past, now in zip(self._path, mean_draw)]

        # The matrix stretches along the path, and along the draws of the better points.
        one, many = self._one_rate, self._many_rate
        change = [
            [
                float(row == column) * (1 - one / 2 - many / 2)
                + one / 2 * self._path[row] * self._path[column]
                + many / 2 * math.fsum(weight * draw[row] * draw[column] for weight, draw in zip(weights, draws))
                for column in axes
            ]
            for row in axes
        ]
        self._matrix = [
            [math.fsum(self._matrix[row][k] * change[k][column] for k in axes) for column in axes] for row in axes
        ]
        length = math.sqrt(math.fsum(number**2 for number in self._path))
        self._sigma *= math.exp(min(1.0, rate / self._damping * (length / self._usual_length - 1)))
        self._sigma = min(self._sigma, 1.0)
        self._generation += 1
        self._asked = 0
        self._unfolded.clear()

    def should_stop(self) -> bool:
        """Returns true if its points hardly differ any more."""
        widest = max(math.sqrt(math.fsum(number**2 for number in row)) for row in self._matrix)
        return self._sigma * widest < 1e-5

    def _draw_of(self, point: Sequence[float]) -> list[float]:
        draw = self._unfolded.get(tuple(point))
        if draw is None:
            step = [(number - centre) / self._sigma for number, centre in zip(point, self._mean)]
            draw = solve(self._matrix, step)
            # A distant point counts like a far draw, because it would distort the search otherwise.
            length = math.sqrt(math.fsum(number**2 for number in draw))
            most = 2 * self._usual_length
            if length > most:
                draw = [number * most / length for number in draw]
        return draw


def folded(number: float) -> float:
    """Returns the number, reflected at 0 and 1 into this range."""
    rest = math.fmod(abs(number), 2.0)
    return 2.0 - rest if rest > 1.0 else rest


def solve(matrix: Sequence[Sequence[float]], right: Sequence[float]) -> list[float]:
    """Returns x with matrix times x = right, by elimination with pivots. Undetermined coordinates are 0."""
    size = len(right)
    rows = [[*row, number] for row, number in zip(matrix, right)]
    pivots = []
    for column in range(size):
        pivot = max(range(column, size), key=lambda row: abs(rows[row][column]))
        rows[column], rows[pivot] = rows[pivot], rows[column]
        pivots.append(abs(rows[column][column]) > 1e-300)
        if not pivots[-1]:
            continue
        for row in range(column + 1, size):
            factor = rows[row][column] / rows[column][column]
            if factor != 0:
                rows[row] = [below - factor * above for below, above in zip(rows[row], rows[column])]
    found = [0.0] * size
    for column in reversed(range(size)):
        if pivots[column]:
            rest = rows[column][size] - math.fsum(rows[column][k] * found[k] for k in range(column + 1, size))
            found[column] = rest / rows[column][column]
    return found


def _times(matrix: Sequence[Sequence[float]], vector: Sequence[float]) -> list[float]:
    return [math.fsum(entry * number for entry, number in zip(row, vector)) for row in matrix]
