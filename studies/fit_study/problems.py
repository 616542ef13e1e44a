# SPDX-License-Identifier: Apache-2.0
"""The problems: models with four variables each, and the measures that must recover the values."""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from typing import Any, Mapping, Tuple, Union

import meristem

Range = Union[None, Tuple[float, float], range]

PLANTINGS = 2  #: number per model
TOLERANCE = 1e-3  #: the error at which a fit ends


@dataclass(frozen=True)
class Problem:
    """A model whose variables are drawn, grown, measured, and then recovered from these measures."""

    model: str
    system: str  #: the growth system
    variables: Mapping[str, Range]  #: None for the declared range; (low, high); or whole numbers
    measures: tuple[str, ...]
    fixed: Mapping[str, float] = field(default_factory=dict)

    def document(self) -> meristem.Document:
        return meristem.read(self.model, set=dict(self.fixed))


@dataclass(frozen=True)
class Found:
    """One variable of one planting."""

    model: str
    system: str
    planting: int
    variable: str
    true: float
    found: float
    error: float  #: difference as a share of the range
    growths: int
    loss: float
    reason: str


PROBLEMS = (
    Problem(
        "bush",
        "colonize",
        dict.fromkeys(("crown_height", "crown_width", "branches", "leafiness")),
        ("height", "crown_mean_width", "length", "tips", "leaf_count"),
    ),
    Problem(
        "slender",
        "colonize",
        dict.fromkeys(("crown_height", "crown_width", "branches", "leaf_size")),
        ("height", "crown_mean_width", "length", "tips", "leaf_area"),
    ),
    Problem(
        "lime",
        "organize",
        {"age": range(8, 27), "leader": None, "breadth": None, "leafiness": None},
        ("height", "metamers", "crown_mean_width", "branching_angle_mean", "tips", "leaf_count"),
    ),
    Problem(
        "hawthorn",
        "organize",
        {"age": range(14, 25), "leader": None, "blossom": None, "leafiness": None},
        ("height", "metamers", "crown_mean_width", "tips", "leaf_count", "leaf_area"),
    ),
    Problem(
        "elm",
        "lsystem",
        dict.fromkeys(("spread", "bending", "irregular", "leafiness")),
        ("height", "crown_mean_width", "branching_angle_mean", "branching_angle_spread", "length", "leaf_count"),
        {"age": 5},
    ),
    Problem(
        "fern",
        "lsystem",
        {"age": range(30, 61), "fronds": range(3, 11), "pairs": range(10, 46), "arch": None},
        ("height", "crown_mean_width", "nodes", "axes", "length", "leaf_count"),
    ),
    Problem(
        "tulip",
        "p-graph",
        {"stem_length": None, "flower": None, "leaves": range(2, 6), "bend": None},
        ("height", "width", "length", "inclination_altitude", "leaf_count", "leaf_area"),
    ),
    Problem(
        "rhododendron",
        "p-graph",
        {"bush_height": None, "branches": range(6, 41), "breadth": None, "leaf_size": None},
        ("height", "width", "axes", "length", "leaf_count", "leaf_area"),
    ),
    Problem(
        "wheat",
        "grassleaf",
        {"tillers": range(2, 10), "plant_height": None, "lean": None, "stage": (30, 60)},
        ("height", "axes", "length", "inclination_altitude", "centroid_radius", "leaf_count", "leaf_area"),
    ),
    Problem(
        "maize",
        "grassleaf",
        {"age": (30, 90), "leaves": range(12, 19), "plant_height": None, "spread": None},
        ("height", "width", "axes", "length", "leaf_count", "leaf_area"),
    ),
)
QUICK = ("bush", "wheat")


def measure_plant(plant: meristem.Plant) -> dict[str, Any]:
    """Returns all measures, and the width of the plant with its leaves: the mean of the widths along x and z."""
    bounds = plant.bounds
    assert bounds is not None
    return {**plant.measure(threads=1), "width": float((bounds[1] - bounds[0])[[0, 2]].mean())}


def ends_of(problem: Problem) -> dict[str, tuple[float, float]]:
    """Returns the smallest and largest value of each variable."""
    declared = {variable.name: (variable.min, variable.max) for variable in problem.document().variables}
    ends = {}
    for name, given in problem.variables.items():
        ends[name] = declared[name] if given is None else (given[0], given[-1])
    return ends


def plant(problem: Problem, planting: int) -> dict[str, float]:
    """Returns the values of a planting, drawn uniformly from the ranges."""
    values: dict[str, float] = {}
    for name, (low, high) in ends_of(problem).items():
        draw = random.Random(f"{problem.model} {planting} {name}")
        whole = problem.variables[name]
        values[name] = draw.choice(whole) if isinstance(whole, range) else round(draw.uniform(low, high), 6)
    return values


def solve(problem: Problem, planting: int, growths: int) -> list[Found]:
    """Plants values, measures the plant, and searches the values by the measures."""
    document = problem.document()
    truth = plant(problem, planting)
    measures = measure_plant(document.set(truth).grow())
    targets = {name: measures[name] for name in problem.measures}
    result = meristem.fit(
        document, problem.variables, targets, measure=measure_plant, growths=growths, tolerance=TOLERANCE
    )
    found = []
    for name, (low, high) in ends_of(problem).items():
        true, value = truth[name], float(result.values[name])
        error = abs(value - true) / (high - low)
        where = (problem.model, problem.system, planting, name)
        found.append(Found(*where, true, value, error, result.growths, result.error, result.reason))
    return found
