# SPDX-License-Identifier: Apache-2.0
"""Grows the trees of the study, measures them and computes means over clouds.

Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund 2020,
chapter 5. Scene A has a constant sun in the south. Scene B has a building in the south, and the sun of a day in May.
Each tree grows into its own cloud, without post-processing and radii. It is measured under the constant sun and under
the day's, with the obstacles of its scene.
"""

from __future__ import annotations

from concurrent.futures import Executor, as_completed
from dataclasses import dataclass
from typing import Any, Callable, Iterable, Mapping, NamedTuple, Sequence

import meristem
import numpy as np
from numpy.typing import ArrayLike

Light = Mapping[str, Any]  #: keys of a document's `scene`

STILL_SUN: Light = {"sun": {"azimuth": 180, "altitude": 61}}
DAY: Light = {"latitude": 51.51494, "sun": {"day": 126, "every_hours": 1}}
OBSTACLES: Mapping[str, Light] = {"A": {}, "B": {"obstacles": [{"box": [[-3, 0, 3], [3, 8, 6]]}]}}
GROWTH_LIGHT: Mapping[str, Light] = {"A": STILL_SUN, "B": DAY}

PROFILE = ((0, 0.4), (0.96, 1.42), (1.6, 2.61), (0, 3.8))  #: radius and height of the crown, metres
STEP = 0.02  #: metres
WITHOUT_LIMIT = 1e6  #: metres; the largest influence that a document accepts
HELD_HEIGHT = 3.7  #: metres; height of the trees of "shift_scaled"
SCALE_ROUNDS = 2  #: number of times that these trees are grown, with better scales each time

AZIMUTHS = ("inclination_azimuth", "centroid_azimuth")
LIT_SHARES = ("lit_share_still", "lit_share_day")
MEASURES = (
    "height",
    "nodes",
    "length",
    "crown_hull_area",
    "inclination_azimuth",
    "inclination_altitude",
    "centroid_azimuth",
    "centroid_radius",
    *LIT_SHARES,
)


class Treatment(NamedTuple):
    """A treatment of ten trees that differ only in their clouds."""

    response: str  #: "shift", "shift_scaled" (in a scaled cloud), "shift_held" (hold_height), "limit" or "drift"
    scene: str  #: "A" or "B"
    strength: float  #: of the response: metres per step, the share of points removed, or steps per step; 0: no response


class Plan(NamedTuple):
    """A tree to grow."""

    treatment: Treatment
    seed: int
    scale: float  #: scale of the cloud


@dataclass(frozen=True)
class Tree:
    """A grown tree."""

    plan: Plan
    measures: dict[str, float]  #: by MEASURES: metres, degrees, shares of 1


@dataclass(frozen=True)
class Mean:
    """Means over the trees of a treatment."""

    treatment: Treatment
    trees: int
    scale: float
    measures: dict[str, float]  #: circular mean for azimuths
    spreads: dict[str, float]  #: standard deviations; circular for azimuths


def light_response(treatment: Treatment) -> dict[str, Any]:
    """Returns the key `light` of a document's `colonize`."""
    if treatment.response == "limit":
        return {"limit": {"share": treatment.strength, "radius": 0.3, "k": 0.1}}
    if treatment.response == "drift":
        return {"drift": treatment.strength, "sunlit_weight": 0.25, "hold_height": True}
    return {"shift_m": treatment.strength, "hold_height": treatment.response == "shift_held"}


def make_document(scene: str, light: Light) -> meristem.Document:
    """Returns the tree of the study under a light, in scene "A" or "B", without a response to the light."""
    tree = {
        "type": "colonize",
        "crown": {"profile": PROFILE},
        "points": 900,
        "step": STEP,
        "influence": WITHOUT_LIMIT,
        "kill": 0.08,
        "finish": {"relax": False},
    }
    surroundings = {**light, **OBSTACLES[scene]}
    return meristem.Document({"meristem": 1, "scene": surroundings, "components": {"tree": tree}})


def grow_tree(plan: Plan) -> Tree:
    """Grows and measures a tree on the calling thread. The result does not depend on the thread."""
    scene = plan.treatment.scene
    document = make_document(scene, GROWTH_LIGHT[scene]).set(
        {
            "tree.light": light_response(plan.treatment),
            "tree.crown.profile": [(plan.scale * radius, plan.scale * height) for radius, height in PROFILE],
        },
        seed=plan.seed,
    )
    skeleton = document.grow(threads=1).stems[0].skeleton
    found: dict[str, Any] = {}
    for name, light in zip(LIT_SHARES, (STILL_SUN, DAY)):
        found.update(skeleton.measure(scene=make_document(scene, light).scene, threads=1))
        found[name] = found["lit_share"]
    return Tree(plan, {name: float(found[name]) for name in MEASURES})


def circular_mean(azimuths: ArrayLike, weights: ArrayLike = 1.0) -> float:
    """Returns the direction of the weighted sum of unit vectors. Azimuths and result are in degrees, from 0 to below
    360."""
    angles = np.radians(np.asarray(azimuths, float))
    return float(np.degrees(np.angle(np.sum(weights * np.exp(1j * angles)))) % 360)


def circular_spread(azimuths: ArrayLike) -> float:
    """Returns the circular standard deviation sqrt(-2 ln R) in degrees. R is the length of the mean unit vector."""
    length = abs(np.mean(np.exp(1j * np.radians(np.asarray(azimuths, float)))))
    return float(np.degrees(np.sqrt(-2 * np.log(min(length, 1.0)))))


def take_mean(trees: Sequence[Tree]) -> Mean:
    """Returns the mean of the trees of one treatment. The mean of centroid azimuths is the azimuth of the mean
    centroid."""
    columns = {name: np.array([tree.measures[name] for tree in trees]) for name in MEASURES}
    means = {name: float(np.mean(column)) for name, column in columns.items()}
    spreads = {name: float(np.std(column)) for name, column in columns.items()}
    means["inclination_azimuth"] = circular_mean(columns["inclination_azimuth"])
    means["centroid_azimuth"] = circular_mean(columns["centroid_azimuth"], columns["centroid_radius"])
    for name in AZIMUTHS:
        spreads[name] = circular_spread(columns[name])
    return Mean(trees[0].plan.treatment, len(trees), trees[0].plan.scale, means, spreads)


def grow_trees(plans: Sequence[Plan], pool: Executor, count: Callable[[], None]) -> list[Tree]:
    """Grows all trees in the order of `plans` and calls `count` after each. Raises the first exception immediately."""
    futures = [pool.submit(grow_tree, plan) for plan in plans]
    for future in as_completed(futures):
        future.result()
        count()
    return [future.result() for future in futures]


def group_by_treatment(trees: Iterable[Tree]) -> dict[Treatment, list[Tree]]:
    """Returns the trees of each treatment, both in their order."""
    groups: dict[Treatment, list[Tree]] = {}
    for tree in trees:
        groups.setdefault(tree.plan.treatment, []).append(tree)
    return groups


def correct_scales(trees: Sequence[Tree]) -> dict[Treatment, float]:
    """Returns scales of clouds that would give each treatment the mean height HELD_HEIGHT, assuming proportionality."""
    means = {treatment: take_mean(group) for treatment, group in group_by_treatment(trees).items()}
    return {treatment: mean.scale * HELD_HEIGHT / mean.measures["height"] for treatment, mean in means.items()}


def grow_treatments(
    treatments: Sequence[Treatment], clouds: int, pool: Executor, count: Callable[[], None]
) -> list[Tree]:
    """Grows the trees of all treatments, one per cloud. "shift_scaled" must have the scenes and strengths of
    "shift"."""
    plain = [treatment for treatment in treatments if treatment.response != "shift_scaled"]
    trees = grow_trees([Plan(treatment, seed, 1.0) for treatment in plain for seed in range(clouds)], pool, count)
    scaled = [tree for tree in trees if tree.plan.treatment.response == "shift"]
    for _ in range(SCALE_ROUNDS):
        plans = [
            Plan(treatment._replace(response="shift_scaled"), seed, scale)
            for treatment, scale in correct_scales(scaled).items()
            for seed in range(clouds)
        ]
        scaled = grow_trees(plans, pool, count)
    return trees + scaled


def count_growths(treatments: Sequence[Treatment], clouds: int) -> int:
    """Returns how often grow_treatments() grows a tree."""
    return clouds * sum(SCALE_ROUNDS if treatment.response == "shift_scaled" else 1 for treatment in treatments)
