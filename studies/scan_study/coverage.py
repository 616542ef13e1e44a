# SPDX-License-Identifier: Apache-2.0
"""The visible part of the walnut in a scan and its apparent thickness, by the diameter and the order of segments."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from .walnut import STATIONS, Segments

FEW = 5  #: points that a segment needs to count as seen
MANY = 30  #: points that suffice to fit a cylinder to a segment
CLASSES = (0.0, 0.004, 0.006, 0.008, 0.01, 0.015, 0.02, 0.04, 1.0)  #: limits of diameters, metres


@dataclass(frozen=True)
class Coverage:
    """A class of segments for one instrument and number of stations."""

    instrument: str
    stations: int
    low: float  #: smallest diameter, metres
    high: float
    segments: int
    length: float  #: metres
    seen: float  #: share of the length with a few points
    fitted: float  #: share of the length with many points
    points: int
    thickness: float  #: median of the measured distance from the axis over the true radius


@dataclass(frozen=True)
class OrderCoverage:
    """The shoots of one order, from all stations."""

    instrument: str
    order: int
    shoots: int
    length: float
    seen: float  #: share of shoots with a few points
    length_seen: float  #: share of the length of segments with a few points


@dataclass(frozen=True)
class Located:
    """For each point, its segment and its distance from the segment's axis in metres."""

    segment: NDArray[np.int64]
    distance: NDArray[np.float64]
    station: NDArray[np.int64]


def distance_to(position: NDArray[Any], begin: NDArray[Any], end: NDArray[Any]) -> NDArray[np.float64]:
    """Returns distances in metres from points to one segment, or to one segment per row."""
    way = end - begin
    share = np.clip(np.sum((position - begin) * way, axis=-1) / np.sum(way * way, axis=-1), 0, 1)
    distance: NDArray[np.float64] = np.linalg.norm(position - (begin + share[:, None] * way), axis=-1)
    return distance


def locate(scan: Mapping[str, NDArray[Any]], segments: Segments) -> Located:
    """Finds the segment of each point: the nearest segment of the shoot in the point's label."""
    order = np.argsort(segments.axis, kind="stable")
    axes = segments.axis[order]
    first = np.searchsorted(axes, np.arange(axes[-1] + 2))
    by_shoot = np.argsort(scan["shoot"], kind="stable")
    shoots = scan["shoot"][by_shoot]
    segment = np.full(len(shoots), -1)
    distance = np.full(len(shoots), np.inf)
    edges = np.flatnonzero(np.diff(shoots, prepend=-2, append=-2))
    for begin, end in zip(edges[:-1], edges[1:]):
        points = by_shoot[begin:end]
        position = scan["position"][points].astype(float)
        for one in order[first[shoots[begin]] : first[shoots[begin] + 1]]:
            there = distance_to(position, segments.begin[one].astype(float), segments.end[one].astype(float))
            nearer = there < distance[points]
            segment[points[nearer]] = one
            distance[points[nearer]] = there[nearer]
    return Located(segment, distance, scan["station"].astype(int))


def cover_classes(instrument: str, located: Located, segments: Segments, stations: int) -> list[Coverage]:
    """Returns one row per class of diameters, using only points of the first stations."""
    taken = (located.station < stations) & (located.segment >= 0)
    of = located.segment[taken]
    counts = np.bincount(of, minlength=len(segments))
    thickness = located.distance[taken] / segments.radius[of]
    diameter = 2 * segments.radius
    length = segments.length
    rows = []
    for low, high in zip(CLASSES[:-1], CLASSES[1:]):
        inside = (diameter >= low) & (diameter < high)
        total = float(length[inside].sum())
        if total == 0:
            continue
        points = thickness[inside[of]]
        rows.append(
            Coverage(
                instrument, stations, low, high, int(inside.sum()), total,
                float(length[inside & (counts >= FEW)].sum()) / total,
                float(length[inside & (counts >= MANY)].sum()) / total,
                len(points), float(np.median(points)) if len(points) else float("nan"),
            )
        )  # fmt: skip
    return rows


def cover_orders(instrument: str, located: Located, segments: Segments) -> list[OrderCoverage]:
    counts = np.bincount(located.segment[located.segment >= 0], minlength=len(segments))
    of_shoot = np.bincount(segments.axis, weights=counts)
    order_of_shoot = np.zeros(len(of_shoot), int)
    order_of_shoot[segments.axis] = segments.order
    is_shoot = np.bincount(segments.axis, minlength=len(of_shoot)) > 0
    rows = []
    for order in range(int(segments.order.max()) + 1):
        shoots = is_shoot & (order_of_shoot == order)
        inside = segments.order == order
        length = segments.length
        rows.append(
            OrderCoverage(
                instrument, order, int(shoots.sum()), float(length[inside].sum()),
                float((of_shoot[shoots] >= FEW).mean()),
                float(length[inside & (counts >= FEW)].sum() / length[inside].sum()),
            )
        )  # fmt: skip
    return rows


def share_of_length(rows: Sequence[Coverage], member: str) -> float:
    """Returns the share of the length of all classes together."""
    seen = sum(float(getattr(row, member)) * row.length for row in rows)
    return seen / sum(row.length for row in rows)


def cover_stations(instrument: str, located: Located, segments: Segments) -> list[Coverage]:
    return [row for count in range(1, STATIONS + 1) for row in cover_classes(instrument, located, segments, count)]
