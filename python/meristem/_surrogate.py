# SPDX-License-Identifier: Apache-2.0
"""Guesses the point of a box that has the wanted measures, from points with known measures.

Near the best point, each measure is approximated by a polynomial of second degree, or by a plane if points are few.
Regression fits the polynomial to the nearest points; nearer points count more. The guess is the point at which these
polynomials come closest to the targets, within the reach of the points. Measures jump a little from plant to plant, and
regression over more points than necessary evens this out. Based on: K. Levenberg, D. Marquardt (damped least squares);
M. J. D. Powell: The NEWUOA software for unconstrained optimization without derivatives (2006), but without its trust
region: the nearest points bound the guess.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from ._evolution import solve

Vector = Sequence[float]

_RIDGE = 1e-6  #: ridge against directions in which points do not differ, in squares of their distance
_STEPS = 30  #: number of steps of damped least squares on the polynomials


def guess_point(
    shares: Sequence[Vector], measured: Sequence[Vector], best: int, errors_of: Callable[[Vector], list[float]]
) -> list[float] | None:
    """Returns the point of the unit box with the smallest expected sum of squared errors. None if too few points are
    known.

    `shares` are points and `measured` their measures, `best` the index of the best one; `errors_of` gives weighted errors
    of measures.
    """
    dimensions = len(shares[0])
    centre = shares[best]
    order = sorted(range(len(shares)), key=lambda index: math.dist(shares[index], centre))
    degree = 2 if len(shares) >= 1.5 * _coefficient_count(dimensions, 2) else 1
    count = 2 * _coefficient_count(dimensions, degree)
    near = order[:count]
    if len(near) < dimensions + 2:
        return None
    radius = math.dist(shares[near[-1]], centre)
    if radius == 0:
        return None
    polynomials = _fit_polynomials([shares[k] for k in near], [measured[k] for k in near], centre, radius, degree)
    return _least(polynomials, centre, radius, degree, errors_of)


def _coefficient_count(dimensions: int, degree: int) -> int:
    return 1 + dimensions + (dimensions * (dimensions + 1) // 2 if degree == 2 else 0)


def _terms(move: Vector, degree: int) -> list[float]:
    """Returns 1, the coordinates, and for degree 2 their products."""
    terms = [1.0, *move]
    if degree == 2:
        terms += [move[i] * move[j] for i in range(len(move)) for j in range(i, len(move))]
    return terms


def _fit_polynomials(
    shares: Sequence[Vector], measured: Sequence[Vector], centre: Vector, radius: float, degree: int
) -> list[list[float]]:
    """Returns the coefficients of _terms for each measure, by weighted least squares."""
    rows = [_terms([(a - b) / radius for a, b in zip(share, centre)], degree) for share in shares]
    weights = [(1 - min(1.0, math.dist(share, centre) / (1.1 * radius)) ** 3) ** 3 for share in shares]
    size = len(rows[0])
    matrix = [[math.fsum(w * row[i] * row[j] for w, row in zip(weights, rows)) for j in range(size)] for i in range(size)]
    for k in range(1, size):
        matrix[k][k] += _RIDGE if k <= len(centre) else 100 * _RIDGE
    middle = measured[0]
    polynomials = []
    for number in range(len(middle)):
        # Uses differences from the best point's measures, because the ridge pulls to these.
        right = [
            math.fsum(w * row[i] * (values[number] - middle[number]) for w, row, values in zip(weights, rows, measured))
            for i in range(size)
        ]
        coefficients = solve(matrix, right)
        polynomials.append([coefficients[0] + middle[number], *coefficients[1:]])
    return polynomials


def _least(
    polynomials: Sequence[Vector],
    centre: Vector,
    radius: float,
    degree: int,
    errors_of: Callable[[Vector], list[float]],
) -> list[float]:
    """Minimizes by damped least squares on the polynomials, within the box and the radius."""
    axes = range(len(centre))
    low = [max(-1.0, -share / radius) for share in centre]
    high = [min(1.0, (1 - share) / radius) for share in centre]

    def errors_at(move: Vector) -> list[float]:
        terms = _terms(move, degree)
        return errors_of([math.fsum(c * term for c, term in zip(coefficients, terms)) for coefficients in polynomials])

    move = [0.0] * len(centre)
    errors = errors_at(move)
    loss = math.fsum(error**2 for error in errors)
    damping = 1e-3
    for _ in range(_STEPS):
        slopes = []  # slope of each error along each axis
        for axis in axes:
            delta = 1e-4 if move[axis] + 1e-4 <= high[axis] else -1e-4
            beside = errors_at([number + delta * (k == axis) for k, number in enumerate(move)])
            slopes.append([(there - here) / delta for here, there in zip(errors, beside)])
        matrix = [[math.fsum(a * b for a, b in zip(slopes[i], slopes[j])) for j in axes] for i in axes]
        downhill = [-math.fsum(a * error for a, error in zip(slopes[i], errors)) for i in axes]
        # At a wall, a coordinate that would leave the box stays.
        for axis in axes:
            if (move[axis] <= low[axis] and downhill[axis] < 0) or (move[axis] >= high[axis] and downhill[axis] > 0):
                downhill[axis] = 0.0
                matrix[axis] = [0.0] * len(centre)
                for row in matrix:
                    row[axis] = 0.0
        scale = max((matrix[axis][axis] for axis in axes), default=0.0)
        if scale == 0:
            break
        for axis in axes:
            matrix[axis][axis] += damping * scale
        step = solve(matrix, downhill)
        tried = [min(max(number + change, low[k]), high[k]) for k, (number, change) in enumerate(zip(move, step))]
        tried_errors = errors_at(tried)
        tried_loss = math.fsum(error**2 for error in tried_errors)
        if tried_loss < loss:
            move, errors, loss, damping = tried, tried_errors, tried_loss, max(damping / 5, 1e-9)
        else:
            damping *= 5
    return [min(max(share + radius * number, 0.0), 1.0) for share, number in zip(centre, move)]
