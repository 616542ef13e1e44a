# SPDX-License-Identifier: Apache-2.0
"""The errors of fits to measured leaves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Iterable, Mapping, Sequence

import numpy as np
from meristem import grass

from .measured import SMOOTHING, AgedMidrib, Floats, MeasuredLeaf

ENOUGH_POINTS = 12  #: the distance is bounded for midribs with at least this number
DISTANCE = 0.015  #: root mean square, as a share of the length
LENGTH = 0.01  #: relative to the polyline's, for smooth midribs
AREA = 0.02  #: relative to the trapezium rule's over the measured widths
SMOOTH = 20.0  #: degrees; largest to-and-fro turn of a smooth midrib
SMOOTHINGS = (0.0, 0.001, 0.002, SMOOTHING, 0.003, 0.005, 0.0075, 0.01, 0.015)


@dataclass(frozen=True)
class Fit:
    """Errors of one fitted leaf, as shares of the measured values."""

    plant: str
    rank: int
    points: int  #: of the midrib
    to_and_fro: float  #: degrees; sum of absolute turns of the polyline minus its total turn
    distance: float  #: root mean square, from the digitised points
    length: float  #: length of the midrib over the polyline's, minus 1
    area: float  #: area over the trapezium rule's, minus 1

    @property
    def is_long(self) -> bool:
        return self.points >= ENOUGH_POINTS

    @property
    def is_smooth(self) -> bool:
        return self.to_and_fro <= SMOOTH


@dataclass(frozen=True)
class FitSummary:
    """The leaves of a rank, or all leaves."""

    plant: str
    rank: str
    leaves: int
    distance: float  #: median
    distance_most: float  #: largest, of midribs with enough points; NaN without such midribs
    length: float  #: median
    smooth: int  #: number of smooth midribs
    length_most: float  #: largest absolute value of smooth midribs; NaN without such midribs
    area: float  #: median of absolute values
    area_most: float
    all_hold: float  #: share of the leaves that meet all bounds that apply to them


@dataclass(frozen=True)
class Smoothed:
    """All leaves of a plant, fitted with one smoothing; shares of the length."""

    plant: str
    smoothing: float
    distance: float  #: median root mean square distance
    distance_most: float
    length: float  #: median of the length over the polyline's, minus 1
    length_holds: float  #: share of all leaves whose length is within the bound of smooth ones


def to_and_fro(x: Floats, y: Floats) -> float:
    turns = np.diff(np.unwrap(np.arctan2(np.diff(x), np.diff(y))))
    return float(np.degrees(np.abs(turns).sum() - abs(turns.sum())))


def measure_fit(leaf: MeasuredLeaf) -> Fit:
    fitted = leaf.fit()
    # Positions that end at 1 are shares of the length.
    length = fitted.midrib_length if abs(leaf.s[-1] - 1) < 1e-6 else 1.0
    measured = length * float(np.trapz(leaf.r, leaf.s))
    return Fit(
        plant=leaf.plant,
        rank=leaf.rank,
        points=len(leaf.x),
        to_and_fro=to_and_fro(leaf.x, leaf.y),
        distance=fitted.distance / fitted.polyline_length,
        length=fitted.midrib_length / fitted.polyline_length - 1,
        area=fitted.leaf.area / measured - 1,
    )


def vary_smoothing(leaves: Sequence[MeasuredLeaf]) -> list[Smoothed]:
    rows = []
    for smoothing in SMOOTHINGS:
        fitted = [leaf.fit(smoothing=smoothing) for leaf in leaves]
        distances = [one.distance / one.polyline_length for one in fitted]
        lengths = np.array([one.midrib_length / one.polyline_length - 1 for one in fitted])
        rows.append(
            Smoothed(
                leaves[0].plant,
                smoothing,
                float(np.median(distances)),
                max(distances),
                float(np.median(lengths)),
                float(np.mean(np.abs(lengths) < LENGTH)),
            )
        )
    return rows


def length_errors(classes: Mapping[int, Sequence[AgedMidrib]]) -> list[float]:
    """Returns errors of fits to midribs by age, which are smooth medians: length over the polyline's, minus 1."""
    midribs = [midrib.points for of_class in classes.values() for midrib in of_class]
    fitted = [grass.fit_leaf(points[:, 0], points[:, 1], (0, 0.5, 1), (1, 1, 0)) for points in midribs]
    return [one.midrib_length / one.polyline_length - 1 for one in fitted]


def holds(fit: Fit) -> bool:
    near = not fit.is_long or fit.distance < DISTANCE
    long = not fit.is_smooth or abs(fit.length) < LENGTH
    return near and long and abs(fit.area) < AREA


def most(values: Iterable[float]) -> float:
    return max((abs(value) for value in values), default=float("nan"))


def summarize(fits: Sequence[Fit], rank: str) -> FitSummary:
    smooth = [fit for fit in fits if fit.is_smooth]
    return FitSummary(
        plant=fits[0].plant,
        rank=rank,
        leaves=len(fits),
        distance=float(np.median([fit.distance for fit in fits])),
        distance_most=most(fit.distance for fit in fits if fit.is_long),
        length=float(np.median([fit.length for fit in fits])),
        smooth=len(smooth),
        length_most=most(fit.length for fit in smooth),
        area=float(np.median([abs(fit.area) for fit in fits])),
        area_most=most(fit.area for fit in fits),
        all_hold=float(np.mean([holds(fit) for fit in fits])),
    )


def summarize_ranks(fits: Sequence[Fit]) -> list[FitSummary]:
    """Returns summaries of each rank, followed by the summary of all ranks."""
    ranks = sorted({fit.rank for fit in fits})
    of_ranks = [summarize([fit for fit in fits if fit.rank == rank], str(rank)) for rank in ranks]
    return [*of_ranks, summarize(fits, "all")]
