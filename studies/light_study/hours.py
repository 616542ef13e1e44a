# SPDX-License-Identifier: Apache-2.0
"""The lit share of trees in the open at each hour of a day: in limited space, grown in the light of this day, and with
response A, grown under the still sun of scene A."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Sequence

import meristem
import numpy as np

from .trees import DAY, STILL_SUN, Treatment, light_response, make_document

HOURS = tuple(range(5, 20))  #: whole hours between sunrise and sunset
STRENGTHS = {"limit": (0, 0.36, 0.6), "shift": (0, 0.010)}  #: of each response
GROWTH_LIGHT = {"limit": DAY, "shift": STILL_SUN}
WHOLE_DAY = -1  #: stands for the hour in the row of the whole day


@dataclass(frozen=True)
class Hour:
    """The mean over trees at one hour."""

    response: str  #: "limit" or "shift", as in Treatment
    strength: float
    hour: int  #: WHOLE_DAY: the mean over the day
    altitude: float  #: of the sun, degrees; 0 for the whole day
    lit_share: float


def sun_at(hour: int) -> meristem.Scene:
    day = {key: value for key, value in DAY["sun"].items() if key != "every_hours"}
    return make_document("A", {**DAY, "sun": {**day, "hour": hour}}).scene


def altitude_at(hour: int) -> float:
    """Returns the altitude of the sun in degrees, by the formulas of the specification of the sun's position."""
    angle = 2 * np.pi * DAY["sun"]["day"] / 365.25
    declination = np.arcsin(0.3978 * np.sin(angle - 1.4 + 0.0355 * np.sin(angle - 0.0489)))
    latitude, hours = np.radians(DAY["latitude"]), np.radians(15 * (hour - 12))
    sine = np.sin(latitude) * np.sin(declination) + np.cos(latitude) * np.cos(declination) * np.cos(hours)
    return float(np.degrees(np.arcsin(sine)))


def study_hours(seeds: Sequence[int]) -> list[Hour]:
    scenes = {WHOLE_DAY: make_document("A", DAY).scene, **{hour: sun_at(hour) for hour in HOURS}}
    found = []
    for response, strength in ((name, strength) for name, all_of in STRENGTHS.items() for strength in all_of):
        document = make_document("A", GROWTH_LIGHT[response])
        if strength:
            document = document.set({"tree.light": light_response(Treatment(response, "A", strength))})
        trees = [document.set({}, seed=seed).grow(threads=1).stems[0].skeleton for seed in seeds]
        for hour, scene in scenes.items():
            lit = [tree.measure(scene=scene, threads=1)["lit_share"] for tree in trees]
            altitude = 0.0 if hour == WHOLE_DAY else altitude_at(hour)
            found.append(Hour(response, strength, hour, altitude, float(np.mean(lit))))
    return found
