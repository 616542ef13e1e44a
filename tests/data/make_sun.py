#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes reference/sun.md: positions of the sun, computed by a program that shares no code with the library.

`make_sun.py [FOLDER]` writes below FOLDER, or below its own folder. Altitudes and azimuths come from the spherical law
of cosines, with the arc cosine, and sunrise from a search for altitude 0, so both differ from the library's way. The
declination is by the published formula that `meristem/scene/light/sun.h` names.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

LATITUDES = (64.15, 51.51494, 1.35, -33.87)  # Reykjavik, Dortmund, Singapore, Sydney
DAYS = (20, 80, 140, 200, 290, 340)
HOURS = (6, 9, 12, 15)


def declination(day: float) -> float:
    angle = 2 * math.pi * day / 365.25
    return math.asin(0.3978 * math.sin(angle - 1.4 + 0.0355 * math.sin(angle - 0.0489)))


def altitude(latitude: float, day: float, hour: float) -> float:
    sun = declination(day)
    turn = math.radians(15 * (hour - 12))
    return math.asin(math.sin(latitude) * math.sin(sun) + math.cos(latitude) * math.cos(sun) * math.cos(turn))


def azimuth(latitude: float, day: float, hour: float) -> float:
    height = altitude(latitude, day, hour)
    cosine = (math.sin(declination(day)) - math.sin(height) * math.sin(latitude)) / (math.cos(height) * math.cos(latitude))
    before_noon = math.acos(min(1.0, max(-1.0, cosine)))
    return before_noon if hour <= 12 else 2 * math.pi - before_noon


def sunrise(latitude: float, day: float) -> float:
    early, late = 0.0, 12.0
    for _ in range(60):
        middle = (early + late) / 2
        if altitude(latitude, day, middle) < 0:
            early = middle
        else:
            late = middle
    return late


def main() -> None:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    lines = ["# Positions of the sun", "", "Degrees: altitude and azimuth, from north over east, at hours of true solar time. `make_sun.py` writes this page.", ""]  # fmt: skip
    lines += ["| latitude | day | declination | 06 h | 09 h | 12 h | 15 h | sunrise (h) |", "|---|---|---|---|---|---|---|---|"]
    for degrees in LATITUDES:
        latitude = math.radians(degrees)
        for day in DAYS:
            places = [
                f"{math.degrees(altitude(latitude, day, hour)):.4f} {math.degrees(azimuth(latitude, day, hour)):.4f}"
                for hour in HOURS
            ]
            cells = [f"{degrees:g}", str(day), f"{math.degrees(declination(day)):.4f}", *places, f"{sunrise(latitude, day):.4f}"]
            lines.append("| " + " | ".join(cells) + " |")
    (folder / "reference" / "sun.md").write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
