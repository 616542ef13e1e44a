# SPDX-License-Identifier: Apache-2.0
"""The position of the sun, and the light that a wall blocks."""

from __future__ import annotations

import numpy as np

import meristem

LATITUDE = 51.5

# The functions of the sun accept numbers and arrays.
azimuth, altitude = meristem.sun_position(LATITUDE, 172, 12)
print(f"midsummer noon: azimuth {azimuth:.0f}°, altitude {altitude:.1f}°")
sunrise, sunset = meristem.daylight(LATITUDE, np.array([80, 172, 266, 355]))
print("hours of daylight over the seasons:", np.round(sunset - sunrise, 1))

# A garden of 8 by 8 metres with a house at its southern side, from April to September.
wall = {"box": [[-4, 0, 4], [4, 5, 4.3]]}
season = {"days": [91, 273], "every_days": 14, "every_hours": 1}
scene = meristem.Scene({"latitude": LATITUDE, "sun": season, "sky": 0.4, "obstacles": [wall]})
print(scene)

# Which share of the light reaches the ground, row by row from the wall to the north?
for z in (3.5, 2.0, 0.0, -4.0):
    row = np.column_stack([np.linspace(-3.5, 3.5, 50), np.zeros(50), np.full(50, z)])
    print(f"{4 - z:4.1f} m from the wall: {100 * scene.light_at(row).mean():3.0f} % of the light")

# At which hours of midsummer does the sun reach a bench before the wall?
hours = np.arange(5, 20)
toward_sun = meristem.unit_vector(*meristem.sun_position(LATITUDE, 172, hours))
in_shade = scene.blocked([0, 0.5, 3], toward_sun)
print("sun on the bench at", ", ".join(str(hour) for hour in hours[~in_shade]))

# What does a bird from the south hit at 3 m and at 8 m?
distances, obstacles = scene.first_hit([[0, 3, 10], [0, 8, 10]], [0, 0, -1])
print("flying north:", distances, "m to obstacles", obstacles)
