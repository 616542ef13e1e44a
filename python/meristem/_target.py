# SPDX-License-Identifier: Apache-2.0
"""Targets of a fit, and the errors of measures."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Tuple, Union

#: The wanted value of a measure, or its smallest and largest allowed value
Wanted = Union[float, Tuple[float, float]]


@dataclass(frozen=True)
class Target:
    """The target of one measure, for fit().

    For example, for a height and for the length of all axes:

        height = meristem.Target((8, 9))                        # metres: any height in this band is as good
        length = meristem.Target(120, scale=10, weight=0.5)     # an error of 10 m counts as 1, half as important
    """

    value: Wanted  #: a number, or a band (low, high), within which all numbers are equally good
    scale: float | None = None
    """The error that counts as 1, in the measure's unit. A larger scale makes the target less strict. None uses the
    number itself, or the middle of the band, so that errors are relative; for azimuths it uses 180."""
    weight: float = 1.0  #: weight of the target; a larger weight makes it more important than the others


@dataclass(frozen=True)
class CheckedTarget:
    """A valid Target of a measure."""

    name: str
    low: float
    high: float
    scale: float
    weight: float

    @property
    def is_azimuth(self) -> bool:
        return self.name.endswith("_azimuth")

    def error_of(self, measured: float) -> float:
        """Returns the error in the target's scale: positive above the target, negative below."""
        if self.is_azimuth:
            half = math.fmod(self.high - self.low + 360.0, 360.0) / 2
            away = math.fmod(measured - self.low - half + 900.0, 360.0) - 180.0
            return math.copysign(max(0.0, abs(away) - half), away) / self.scale
        return (measured - min(max(measured, self.low), self.high)) / self.scale

    def mean_of(self, measured: Sequence[float]) -> float:
        """Returns the mean over several plants; for azimuths, the azimuth of the mean of their unit vectors."""
        if not self.is_azimuth:
            return math.fsum(measured) / len(measured)
        angles = [math.radians(angle) for angle in measured]
        east, north = math.fsum(map(math.sin, angles)), math.fsum(map(math.cos, angles))
        return math.degrees(math.atan2(east, north)) % 360.0


def check_targets(targets: Mapping[str, Wanted | Target]) -> list[CheckedTarget]:
    """Raises TypeError and ValueError for invalid targets."""
    if not isinstance(targets, Mapping):
        raise TypeError(f"targets must be a dict, such as {{'height': 9.5}}, not {type(targets).__name__}")
    if not targets:
        raise ValueError("targets must have at least one measure, such as {'height': 9.5}")
    return [_checked(name, given if isinstance(given, Target) else Target(given)) for name, given in targets.items()]


def _checked(name: str, target: Target) -> CheckedTarget:
    where = f"targets[{name!r}]"
    low, high = _band(where, target.value)
    is_azimuth = name.endswith("_azimuth")
    if low > high and not is_azimuth:
        raise ValueError(f"{where} is a band from {low:g} down to {high:g}; expected (low, high)")
    scale = _number(f"{where}.scale", target.scale if target.scale is not None else _usual_scale(low, high, is_azimuth))
    if scale <= 0:
        reason = "its value is 0, so give the error that counts as 1 by `scale`" if target.scale is None else "it must be above 0"
        raise ValueError(f"{where} has no scale: {reason}" if target.scale is None else f"{where}.scale: {reason}")
    weight = _number(f"{where}.weight", target.weight)
    if weight <= 0:
        raise ValueError(f"{where}.weight must be above 0; leave out measures that should not count")
    return CheckedTarget(name, low, high, scale, weight)


def _usual_scale(low: float, high: float, is_azimuth: bool) -> float:
    return 180.0 if is_azimuth else abs(low + high) / 2


def _band(where: str, value: Any) -> tuple[float, float]:
    if isinstance(value, Iterable) and not isinstance(value, (str, Mapping)):
        ends = list(value)
        if len(ends) == 2:
            return _number(where, ends[0]), _number(where, ends[1])
    else:
        number = _number(where, value)
        return number, number
    raise ValueError(f"{where} must be a number or a band (low, high), not {len(ends)} numbers")


def _number(where: str, value: Any) -> float:
    if isinstance(value, (str, bytes, bool)) or not hasattr(value, "__float__"):
        raise TypeError(f"{where} must be a number or a band (low, high), not {type(value).__name__}")
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"{where} is {number}; expected a finite number")
    return number
