#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes trees/sapling.mtg: a synthetic tree in the form of a digitised one, and prints its figures.

`make_tree.py [FOLDER]` writes below FOLDER, or below its own folder. No measurement is in the file. Coordinates are in
cm, diameters in mm, z is up, and the base of the trunk stands with the axis, as in digitised trees. One segment has no
values. `make_tree.py --facts` prints the measures of the file, computed from the rounded numbers by a program that
shares no code with the library. Tests hold the library to them. All random numbers have a fixed seed.
"""

from __future__ import annotations

import math
import random
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Iterator

SEGMENTS = (18, 10, 7, 4, 2)  # of an axis, by order
PIPE_EXPONENT = 2.0
TIP_DIAMETER = 4.0  # mm
FORK_DIAMETER = 20.0  # mm; of the forks whose area ratio counts
GAP = 40  # the segment without values, by its place in the file

Vector = tuple[float, float, float]


@dataclass
class Segment:
    """A segment that ends at `end`; cm and mm."""

    end: Vector
    order: int
    parent: Segment | None
    continues: bool
    children: list[Segment] = field(default_factory=list)
    diameter: float = 0.0
    has_values: bool = True


def turned(heading: Vector, angle: float, around: float) -> Vector:
    """Returns a unit vector `angle` radians away from `heading`, in the direction `around`."""
    helper = (1.0, 0.0, 0.0) if abs(heading[0]) < 0.8 else (0.0, 1.0, 0.0)
    a = unit(cross(heading, helper))
    b = cross(heading, a)
    side = [math.cos(around) * a[k] + math.sin(around) * b[k] for k in range(3)]
    x, y, z = (math.cos(angle) * heading[k] + math.sin(angle) * side[k] for k in range(3))
    return (x, y, z)


def cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length_of(a: Vector) -> float:
    return math.sqrt(a[0] ** 2 + a[1] ** 2 + a[2] ** 2)


def unit(a: Vector) -> Vector:
    return (a[0] / length_of(a), a[1] / length_of(a), a[2] / length_of(a))


def minus(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def grow_axis(draws: random.Random, parent: Segment, order: int, heading: Vector) -> None:
    """Adds an axis of the next segments after `parent`, with laterals. The trunk's lowest segments have none."""
    count = max(1, SEGMENTS[order] - draws.randrange(3)) if order > 0 else SEGMENTS[0]
    for k in range(count):
        heading = unit(turned(heading, 0.22 * draws.random(), 2 * math.pi * draws.random()))
        step = (24 if order == 0 else 17 - 2 * order) * (0.7 + 0.6 * draws.random())
        end = (
            round(parent.end[0] + step * heading[0], 2),
            round(parent.end[1] + step * heading[1], 2),
            round(parent.end[2] + step * heading[2] + 0.1 * step, 2),
        )
        segment = Segment(end, order, parent, continues=k > 0 or order == 0)
        parent.children.append(segment)
        bears = order + 1 < len(SEGMENTS) and k + 1 < count and k >= (4 if order == 0 else 0)
        for _ in range(1 + (draws.random() < 0.15) if bears and draws.random() < 0.6 else 0):
            angle = math.radians(35 + 40 * draws.random())
            grow_axis(draws, segment, order + 1, turned(heading, angle, 2 * math.pi * draws.random()))
        parent = segment


def thicken(draws: random.Random, segments: list[Segment]) -> None:
    """Gives diameters by the pipe model, with errors of 4 %, from the tips to the base."""
    for segment in reversed(segments):
        below = sum(child.diameter**PIPE_EXPONENT for child in segment.children)
        whole = below ** (1 / PIPE_EXPONENT) if below > 0 else TIP_DIAMETER
        segment.diameter = round(whole * (1 + 0.04 * (2 * draws.random() - 1)), 1)


def walk(segment: Segment) -> Iterator[Segment]:
    """Yields the segments after this one, parents first, laterals before the continuation, as the file has them."""
    for child in sorted(segment.children, key=lambda one: one.continues):
        yield child
        yield from walk(child)


def make_tree() -> tuple[Segment, list[Segment]]:
    draws = random.Random(4)
    base = Segment((12.5, -30.25, 4.0), 0, None, continues=True)
    grow_axis(draws, base, 0, (0.0, 0.0, 1.0))
    segments = list(walk(base))
    thicken(draws, segments)
    gap = next(one for one in segments[GAP:] if one.children and one.continues)
    assert gap.parent is not None
    gap.has_values, gap.diameter = False, gap.parent.diameter
    gap.end = gap.parent.end
    return base, segments


HEADER = """\
# A synthetic tree; make_tree.py writes this file. Coordinates in cm, diameters in mm.
CODE:\tFORM-A

CLASSES:
SYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION
$\t0\tFREE\tFREE\tIMPLICIT
P\t1\tCONNECTED\tFREE\tEXPLICIT
A\t2\t<-LINEAR\tFREE\tEXPLICIT
S\t3\tNONE\tFREE\tEXPLICIT

DESCRIPTION :
LEFT\tRIGHT\tRELTYPE\tMAX
A\tA\t+\t?
S\tS\t+\t?
S\tS\t<\t1

FEATURES:
NAME\tTYPE
XX\tREAL
YY\tREAL
ZZ\tREAL
TopDia\tREAL
NFe\tINT

MTG:
"""


def values_of(segment: Segment) -> str:
    if not segment.has_values:
        return ""
    x, y, z = segment.end
    leaves = 0 if segment.children else 3 + int(segment.diameter * 10) % 4
    return f"{x:g}\t{y:g}\t{z:g}\t{segment.diameter:g}\t{leaves}"


def lines_of(parent: Segment, column: int, columns: int, number: int) -> Iterator[str]:
    """Yields the lines of what follows `parent`: its laterals, then its successor. `number` counts the axis."""
    laterals = [child for child in parent.children if not child.continues]
    for k, lateral in enumerate(laterals):
        indent, rest = "\t" * (column + 1), "\t" * (columns - column - 1)
        yield f"{indent}+A{k + 1}{rest}"
        yield f"{indent}^/S1{rest}{values_of(lateral)}".rstrip()
        yield from lines_of(lateral, column + 1, columns, 1)
    for child in parent.children:
        if child.continues:
            yield f"{chr(9) * column}^<S{number + 1}{chr(9) * (columns - column)}{values_of(child)}".rstrip()
            yield from lines_of(child, column, columns, number + 1)


def text_of(base: Segment) -> str:
    columns = len(SEGMENTS) + 1
    tabs = "\t" * columns
    first = base.children[0]
    x, y, z = base.end
    lines = [f"ENTITY-CODE{tabs}XX\tYY\tZZ\tTopDia\tNFe", "/P1", f"\t/A1{tabs[1:]}{x:g}\t{y:g}\t{z:g}"]
    lines.append(f"\t^/S1{tabs[1:]}{values_of(first)}")
    lines += lines_of(first, 1, columns, 1)
    return HEADER + "\n".join(line.rstrip() for line in lines) + "\n"


# --- the facts --------------------------------------------------------------------------------------------------------


def quantile(numbers: list[float], share: float) -> float:
    """Returns a percentile, linearly between the two nearest numbers."""
    ordered = sorted(numbers)
    at = share * (len(ordered) - 1)
    low = math.floor(at)
    high = min(low + 1, len(ordered) - 1)
    return ordered[low] + (at - low) * (ordered[high] - ordered[low])


def strahler_streams(base: Segment, segments: list[Segment]) -> list[int]:
    number: dict[int, int] = {}
    for segment in reversed(segments):
        of_children = sorted((number[id(child)] for child in segment.children), reverse=True) or [0]
        rises = len(of_children) == 1 and of_children[0] == 0 or of_children[:1] == of_children[1:2]
        number[id(segment)] = of_children[0] + rises
    streams = [0] * max(number.values())
    for segment in segments:
        parent = segment.parent
        if parent is None or parent is base or number[id(parent)] != number[id(segment)]:
            streams[number[id(segment)] - 1] += 1
    return streams


def pipe_exponent(segment: Segment) -> float | None:
    """Returns the exponent that makes the children's diameters sum to the parent's, or nothing without a solution."""

    def excess(exponent: float) -> float:
        return sum((child.diameter / segment.diameter) ** exponent for child in segment.children) - 1

    low, high = 0.0, 100.0
    if excess(high) > 0:
        return None
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if excess(middle) > 0 else (low, middle)
    return low


def branching_angles(segments: list[Segment]) -> list[float]:
    angles = []
    for fork in segments:
        assert fork.parent is not None
        own = minus(fork.end, fork.parent.end)
        for child in fork.children:
            other = minus(child.end, fork.end)
            if not child.continues and length_of(own) > 0 and length_of(other) > 0:
                cosine = sum(a * b for a, b in zip(unit(own), unit(other)))
                angles.append(math.degrees(math.acos(max(-1.0, min(1.0, cosine)))))
    return angles


def print_facts(base: Segment, segments: list[Segment]) -> None:
    forks = [one for one in segments if len(one.children) > 1]
    thick = [one for one in forks if one.diameter >= FORK_DIAMETER]
    ratios = [sum(child.diameter**2 for child in one.children) / one.diameter**2 for one in thick]
    exponents = [found for found in map(pipe_exponent, forks) if found is not None]
    angles = branching_angles(segments)
    streams = strahler_streams(base, segments)
    top = max(one.end[2] for one in segments)
    rises = [a / b for a, b in zip(streams, streams[1:])]
    first_fork = base.children[0]
    while len(first_fork.children) == 1:
        first_fork = first_fork.children[0]
    print("segments", len(segments), "laterals", sum(not one.continues for one in segments))
    print("orders", 1 + max(one.order for one in segments))
    print(f"height {top - base.end[2]:.2f} cm, above the first fork {top - first_fork.end[2]:.2f} cm")
    print("streams", streams, "ratios", [round(rise, 3) for rise in rises])
    print(f"geometric mean of the ratios {math.prod(rises) ** (1 / len(rises)):.4f}")
    for name, numbers in (("area ratios", ratios), ("angles", angles)):
        print(name, len(numbers), *(f"{quantile(numbers, share):.4f}" for share in (0.05, 0.5, 0.95)))
    print(f"pipe exponents: {len(forks)} forks, {len(exponents)} solved, median {quantile(exponents, 0.5):.4f}")


def main() -> None:
    base, segments = make_tree()
    if sys.argv[1:] == ["--facts"]:
        print_facts(base, segments)
        return
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    (folder / "trees" / "sapling.mtg").write_text(text_of(base), encoding="utf-8")


if __name__ == "__main__":
    main()
