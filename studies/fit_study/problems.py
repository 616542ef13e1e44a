# SPDX-License-Identifier: Apache-2.0
"""What is planted: models with four variables each, and the measures that their values are to be found by."""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from typing import Mapping, Optional

import meristem

PLANTINGS = 2  #: of each model


@dataclass(frozen=True)
class Problem:
    """A model whose variables are drawn, grown and measured, and then sought by these measures."""

    model: str
    system: str  #: that grows it
    variables: Mapping[str, Optional[range]]  #: None for the declared range, or the whole numbers of one
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
    error: float  #: what they differ, as a share of the range
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
        {"age": range(6, 31), "leader": None, "breadth": None, "leafiness": None},
        ("height", "metamers", "crown_mean_width", "branching_angle_mean", "tips", "leaf_count"),
    ),
    Problem(
        "hawthorn",
        "organize",
        {"age": range(8, 33), "leader": None, "blossom": None, "leafiness": None},
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
        {"age": range(5, 91), "fronds": range(1, 25), "pairs": range(10, 46), "arch": None},
        ("height", "crown_mean_width", "nodes", "axes", "length", "leaf_count"),
    ),
    Problem(
        "birch",
        "p-graph",
        dict.fromkeys(("tree_height", "weeping", "leafiness", "leaf_size")),
        ("height", "length", "inclination_altitude", "leaf_count", "leaf_area"),
    ),
    Problem(
        "rhododendron",
        "p-graph",
        {"bush_height": None, "branches": range(6, 41), "breadth": None, "leaf_size": None},
        ("height", "crown_mean_width", "axes", "length", "leaf_count", "leaf_area"),
    ),
    Problem(
        "wheat",
        "grassleaf",
        {"tillers": range(0, 10), "plant_height": None, "lean": None, "stage": None},
        ("height", "crown_mean_width", "axes", "length", "leaf_count", "leaf_area"),
    ),
    Problem(
        "maize",
        "grassleaf",
        {"age": None, "leaves": range(12, 19), "plant_height": None, "ears": range(0, 3)},
        ("height", "axes", "nodes", "length", "leaf_count", "leaf_area"),
    ),
)
QUICK = ("bush", "wheat")


def plant(problem: Problem, planting: int) -> dict[str, float]:
    """The values of a planting, drawn evenly from the ranges."""
    declared = {variable.name: variable for variable in problem.document().variables}
    values: dict[str, float] = {}
    for name, whole in problem.variables.items():
        draw = random.Random(f"{problem.model} {planting} {name}")
        low, high = declared[name].min, declared[name].max
        values[name] = draw.choice(whole) if whole is not None else round(draw.uniform(low, high), 6)
    return values


def solve(problem: Problem, planting: int, growths: int) -> list[Found]:
    """Plants values, measures, and seeks the values by the measures."""
    document = problem.document()
    truth = plant(problem, planting)
    measures = document.set(truth).grow().measure()
    targets = {name: measures[name] for name in problem.measures}
    result = meristem.fit(document, problem.variables, targets, growths=growths, tolerance=1e-3)
    declared = {variable.name: variable for variable in document.variables}
    found = []
    for name, true in truth.items():
        whole = problem.variables[name]
        width = whole[-1] - whole[0] if whole is not None else declared[name].max - declared[name].min
        value = result.values[name]
        found.append(
            Found(
                problem.model,
                problem.system,
                planting,
                name,
                true,
                value,
                abs(value - true) / width,
                result.growths,
                result.error,
                result.reason,
            )
        )
    return found
