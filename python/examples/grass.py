# SPDX-License-Identifier: Apache-2.0
"""The stages of a grass leaf: fitted to points, aged, blown by the wind, reduced, meshed."""

from __future__ import annotations

import numpy as np

from meristem import grass

# A digitised midrib, and widths along the blade, in metres.
x = [0.00, 0.03, 0.08, 0.16, 0.26, 0.36, 0.45]
y = [0.00, 0.15, 0.29, 0.40, 0.46, 0.46, 0.40]
s = [0.00, 0.10, 0.30, 0.50, 0.70, 0.90, 1.00]
r = [0.035, 0.045, 0.055, 0.052, 0.040, 0.018, 0.000]
fitted = grass.fit_leaf(x, y, s, r)
leaf = fitted.leaf
print(f"fit: {leaf.length:.3f} m long, {1000 * fitted.distance:.1f} mm from the points, {1e4 * leaf.area:.1f} cm2")

# The leaf emerges tip first, and bends as it ages.
family = grass.MidribFamily(leaf)
for age in (0.25, 0.5, 0.75, 1.0):
    young = grass.aged(leaf, family, age)
    print(f"age {age:4.2f}: {young.length:.3f} m long, its tip at {young.angles[-1]:5.1f} degrees")

# The leaf in wind, and the inverse question: which weight of rain turns its tip by 20 degrees? The leaf's own weight is
# 1.
for wind in (0.1, 0.3):
    blown = grass.loaded(leaf, wind=(wind, 0))
    print(f"wind {wind}: the tip at {blown.angles[-1]:5.1f} degrees")
print(f"20 degrees more take {grass.load_for_turn(leaf, 1, 20, pull=(0, -1)):.3f} of its weight in rain")

# Levels of detail share points and keep the area.
order = grass.reduction_order(leaf)
for pieces in (16, 8, 4, 2):
    plain = grass.reduced(leaf, points=grass.points_kept(order, pieces))
    mesh = grass.make_grass_blade(plain, twist=20)
    gap = np.interp(leaf.s, plain.s, plain.y) - leaf.y
    print(f"{len(mesh.triangles):3d} triangles: {1e4 * mesh.area:.1f} cm2, midrib {100 * abs(gap).max():.1f} % off")
