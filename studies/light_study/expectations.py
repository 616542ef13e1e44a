# SPDX-License-Identifier: Apache-2.0
"""The expectations of the study as numbers: bands for means, and the strengths of extremes.

Azimuths are compared on the circle. Lit shares and azimuths are in the units of the measures (shares of 1, degrees).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Mapping, Sequence

import numpy as np

from common.tables import Finding

from .trees import AZIMUTHS, Mean, Treatment

SHIFTS = tuple(round(0.001 * k, 3) for k in range(11))
ANY = np.inf

Means = Mapping[Treatment, Mean]


@dataclass(frozen=True)
class Band:
    """A band for means, or for differences from the mean without a response."""

    response: str
    scene: str
    measure: str
    strengths: Sequence[float]
    low: float
    high: float
    change: bool = False  #: true: the difference from strength 0 is compared
    relative: bool = False  #: true: the difference is relative to the value at strength 0
    spread: bool = False  #: true: the spread is compared


@dataclass(frozen=True)
class Extreme:
    """A measure whose minimum or maximum must be at some of the strengths."""

    scene: str
    measure: str
    highest: bool
    within: Sequence[float]
    among: Sequence[float]
    spread: bool = False
    response: str = "shift"


BANDS = (
    Band("shift", "A", "inclination_azimuth", SHIFTS[5:], 174, 186),
    Band("shift", "A", "inclination_azimuth", [0], 45, ANY, spread=True),
    Band("shift", "A", "inclination_altitude", [0], 87.3, 90),
    Band("shift", "A", "inclination_altitude", [0.010], 65.9, 68.9),
    Band("shift", "A", "height", [0], 3.4, 3.8),
    Band("shift", "A", "height", [0.010], 6.6, 7.0),
    Band("shift", "A", "lit_share_still", [0.010], -0.08, -0.03, change=True),
    Band("shift", "A", "lit_share_day", SHIFTS[1:], -0.005, 0.005, change=True),
    Band("shift", "B", "inclination_azimuth", SHIFTS[2:7], -30, 30),
    Band("shift", "B", "inclination_azimuth", SHIFTS[9:], 160, 200),
    Band("shift", "B", "centroid_azimuth", SHIFTS[1:], -30, 30),
    Band("shift", "B", "lit_share_day", [0.010], 0.05, 0.07, change=True),
    Band("shift_scaled", "B", "lit_share_day", [0.005], 0.008, 0.025, change=True),
    Band("limit", "A", "lit_share_still", [0.36], 0.04, ANY, change=True),
    Band("limit", "A", "lit_share_still", [0.6], 0.08, ANY, change=True),
    Band("limit", "A", "height", [0.36, 0.6], -0.02, 0.02, change=True, relative=True),
    Band("drift", "B", "lit_share_day", [0.9, 1], 0.06, ANY, change=True),
    Band("drift", "B", "height", [0.9, 1], -0.02, 0.02, change=True, relative=True),
)

EXTREMES = (
    Extreme("B", "inclination_altitude", False, SHIFTS[3:6], SHIFTS[1:7]),
    Extreme("B", "inclination_altitude", True, SHIFTS[7:9], SHIFTS[1:]),
    Extreme("B", "inclination_azimuth", True, SHIFTS[7:9], SHIFTS[1:], spread=True),
    Extreme("B", "centroid_radius", True, SHIFTS[6:9], SHIFTS),
)


def value_of(mean: Mean, measure: str, spread: bool = False) -> float:
    return (mean.spreads if spread else mean.measures)[measure]


def change_of(means: Means, mean: Mean, measure: str, relative: bool = False) -> float:
    """Returns the difference of a measure from the measure without a response, in one scene and series."""
    plain = means[mean.treatment._replace(strength=0)].measures[measure]
    change = mean.measures[measure] - plain
    return change / plain if relative else change


def is_between(value: float, low: float, high: float, circular: bool) -> bool:
    if not circular:
        return low <= value <= high
    middle = (low + high) / 2
    return abs((value - middle + 180) % 360 - 180) <= (high - low) / 2


def name_series(response: str, scene: str, measure: str, spread: bool) -> str:
    return f"{response} {scene}: {measure}" + (" spread" if spread else "")


def check_band(band: Band, means: Means) -> Finding | None:
    """Returns None if the strengths were not studied."""
    treatments = [Treatment(band.response, band.scene, strength) for strength in band.strengths]
    studied = [means[treatment] for treatment in treatments if treatment in means]
    if not studied:
        return None
    if band.change:
        values = [change_of(means, mean, band.measure, band.relative) for mean in studied]
    else:
        values = [value_of(mean, band.measure, band.spread) for mean in studied]
    circular = band.measure in AZIMUTHS and not band.spread
    what = name_series(band.response, band.scene, band.measure, band.spread) + (" change" if band.change else "")
    at = ", ".join(f"{mean.treatment.strength:g}" for mean in studied)
    limits = f"at least {band.low:g}" if band.high == ANY else f"{band.low:g} to {band.high:g}"
    return Finding(
        f"{what} at {at}",
        limits,
        ", ".join(f"{value:.4g}" for value in values),
        all(is_between(value, band.low, band.high, circular) for value in values),
    )


def check_extreme(extreme: Extreme, means: Means) -> Finding | None:
    """Returns None if some strengths were not studied."""
    treatments = [Treatment(extreme.response, extreme.scene, strength) for strength in extreme.among]
    if any(treatment not in means for treatment in treatments):
        return None
    values = [value_of(means[treatment], extreme.measure, extreme.spread) for treatment in treatments]
    found = extreme.among[int(np.argmax(values) if extreme.highest else np.argmin(values))]
    return Finding(
        f"{name_series(extreme.response, extreme.scene, extreme.measure, extreme.spread)} "
        + ("highest" if extreme.highest else "lowest"),
        f"at {extreme.within[0]:g} to {extreme.within[-1]:g}",
        f"{found:g}",
        found in extreme.within,
    )


def check_line(means: Means) -> list[Finding]:
    """Altitudes in scene A must fall strictly and nearly linearly."""
    treatments = [Treatment("shift", "A", shift) for shift in SHIFTS]
    studied = [means[treatment] for treatment in treatments if treatment in means]
    shifts = [mean.treatment.strength for mean in studied]
    altitudes = [mean.measures["inclination_altitude"] for mean in studied]
    explained = float(np.corrcoef(shifts, altitudes)[0, 1] ** 2)
    falls = bool(np.all(np.diff(altitudes) < 0))
    what = "shift A: inclination_altitude"
    return [
        Finding(f"{what} from shift to shift", "falls", "falls" if falls else "rises", falls),
        Finding(f"{what}, R² of a line", "at least 0.95", f"{explained:.4f}", explained >= 0.95),
    ]


def check_expectations(means: Means) -> list[Finding]:
    """Checks all expectations whose treatments were studied."""
    found = [check_band(band, means) for band in BANDS] + [check_extreme(extreme, means) for extreme in EXTREMES]
    return [finding for finding in found if finding is not None] + check_line(means)
