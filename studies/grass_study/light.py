# SPDX-License-Identifier: Apache-2.0
"""The light that each leaf of a plant absorbs, with curved and with straight leaves.

Leaves and stems absorb all light that reaches them. A field continues beyond its edge as an opaque hedge as high as the
topmost collar; otherwise low light from the side would reach far into it. The sky is equally bright everywhere.
organ_light() is called for single directions, because the sky of a document is weighted by the sine of the altitude.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Mapping, NamedTuple, Sequence

import meristem
import numpy as np

from .measured import Floats
from .plants import Plant, Stand, make_document

SKY_BANDS, SKY_TURNS = 6, 8  #: directions of the sky
SUN_LATITUDE, SUN_DAY = 45.0, 190.0
SUN_HOURS = tuple(np.arange(5.5, 19))
LOWEST_SUN = 4.5  #: degrees; in lower sun, plants alone would shade each other
HEDGE = 3.0  #: thickness in metres; leaves of the outermost plants reach into it
CLEARNESS = 0.7  #: share of the sun's light that passes through the air from the zenith


class Case(NamedTuple):
    """The names of a measurement's plant, form, stand and light."""

    plant: str
    form: str
    stand: str
    light: str


class Ray(NamedTuple):
    """Light from one direction: degrees, and its strength on a surface that faces it."""

    azimuth: float
    altitude: float
    strength: float


@dataclass(frozen=True)
class Lit:
    """Light on the leaves of a plant, means over plants; leaves from the base up."""

    taken: Floats  #: square metres: light of each leaf, relative to the light on a square metre of level open ground
    areas: Floats  #: square metres
    plants: int

    @property
    def area(self) -> float:
        return float(self.areas.sum())

    @property
    def total(self) -> float:
        return float(self.taken.sum())

    @property
    def shares(self) -> Floats:
        """The share of each leaf in the light of all leaves."""
        return np.asarray(self.taken / self.taken.sum())

    @property
    def efficiency(self) -> Floats:
        """The light of each leaf relative to an equal area that lies on open ground."""
        return np.asarray(self.taken / self.areas)


def level(rays: Sequence[Ray]) -> list[Ray]:
    """Returns the rays with strengths that sum to 1 on level ground."""
    ground = sum(ray.strength * float(np.sin(np.radians(ray.altitude))) for ray in rays)
    return [ray._replace(strength=ray.strength / ground) for ray in rays]


def thin_out(rays: Sequence[Ray], step: int) -> list[Ray]:
    """Returns every `step`-th ray."""
    return level(rays[step // 2 :: step])


def sky_rays() -> list[Ray]:
    """Returns the rays of an equally bright sky."""
    sines = (np.arange(SKY_BANDS) + 0.5) / SKY_BANDS  # bands of equal solid angle
    return level(
        [
            Ray((turn + 0.5 * (band % 2)) * 360 / SKY_TURNS, float(np.degrees(np.arcsin(sine))), 1)
            for band, sine in enumerate(sines)
            for turn in range(SKY_TURNS)
        ]
    )


def sun_rays() -> list[Ray]:
    """Returns the rays of a clear summer's day, one for each hour."""
    rays = []
    for hour in SUN_HOURS:
        azimuth, altitude = meristem.sun_position(SUN_LATITUDE, SUN_DAY, float(hour))
        if altitude > LOWEST_SUN:
            rays.append(Ray(azimuth, altitude, float(CLEARNESS ** (1 / np.sin(np.radians(altitude))))))
    return level(rays)


LIGHTS: Mapping[str, Callable[[], list[Ray]]] = {"uniform sky": sky_rays, "clear summer's day": sun_rays}


def make_hedge(plant: Plant, stand: Stand) -> list[dict[str, Any]]:
    """Returns four walls around a field, and no walls around single plants."""
    if not stand.edge:
        return []
    height = plant.topmost
    x, z = 0.5 * stand.plants * stand.spacing, 0.5 * stand.rows * stand.row_spacing
    far = HEDGE + max(x, z)
    walls = [
        [[-far, -0.01, z], [far, height, z + HEDGE]],
        [[-far, -0.01, -z - HEDGE], [far, height, -z]],
        [[x, -0.01, -z], [x + HEDGE, height, z]],
        [[-x - HEDGE, -0.01, -z], [-x, height, z]],
    ]
    return [{"box": box} for box in walls]


def measure_light(plant: Plant, form: str, stand: Stand, rays: Sequence[Ray]) -> Lit:
    """Measures the light of the plants within the stand's edge."""
    document = make_document(plant, form, stand)
    hedge = make_hedge(plant, stand)
    count = len(plant.blades)
    numbers = {f"leaf{rank}": rank for rank in range(count)}
    taken, areas, plants = np.zeros(count), np.zeros(count), 0
    for ray in rays:
        sun = {"azimuth": ray.azimuth, "altitude": ray.altitude}
        grown = document.set({"scene": {"sun": sun, "obstacles": hedge}}).grow()
        light = grown.organ_light()
        number = np.array([numbers.get(prototype.component, -1) for prototype in grown.prototypes])
        rank = number[grown.organs.prototype]
        places = grown.organs.frame[:, 3, [0, 2]]
        inner = (np.abs(places) <= np.abs(places).max(0) - stand.edge + 1e-3).all(1) & (rank >= 0)
        plants = int(np.count_nonzero(inner & (rank == 0)))
        taken += ray.strength * np.bincount(rank[inner], (light["irradiance"] * light["area"])[inner], count) / plants
        areas = np.bincount(rank[inner], light["area"][inner], count) / plants
    return Lit(taken, areas, plants)
