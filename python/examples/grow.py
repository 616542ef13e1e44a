# SPDX-License-Identifier: Apache-2.0
"""Trees that grow into given points, as from a scan: alone, in competition, and around a wall."""

from __future__ import annotations

import numpy as np

import meristem

# Any points are possible: here a crown that is wider toward its top.
random = np.random.default_rng(4)
height = random.uniform(1.5, 4.5, 2500)
angle, reach = random.uniform(0, 2 * np.pi, 2500), np.sqrt(random.uniform(0, 1, 2500)) * (height - 1) * 0.6
points = np.column_stack([reach * np.cos(angle), height, reach * np.sin(angle)])

tree = meristem.colonize(points, kill=0.2)
measures = tree.measure()
print(f"one tree: {len(tree)} nodes, {measures['length']:.0f} m of wood, {measures['height']:.2f} m high")

# Smaller kill distances give denser twigs.
for kill in (0.4, 0.2, 0.1):
    tips = meristem.colonize(points, kill=kill).measure()["tips"]
    print(f"kill {kill}: {tips} tips")

# Three roots compete for one set of points, and form one skeleton.
group = meristem.colonize(points, roots=[[-0.6, 0, 0], [0.6, 0, 0], [0, 0, 0.9]], kill=0.2)
print("three trees:", ", ".join(f"{len(one)} nodes" for one in group.trees()))

# No branch enters the wall, and points move toward the light.
scene = meristem.Scene({"latitude": 51.5, "sun": {"day": 172, "every_hours": 1},
                        "obstacles": [{"box": [[0.5, 0, -4], [0.8, 6, 4]]}]})
shaded = meristem.colonize(points, kill=0.2, scene=scene, light={"shift": 0.2})
for name, skeleton in (("in the open", tree), ("at the wall", shaded)):
    print(f"middle of the tree {name}: {skeleton.position[:, 0].mean():+.2f} m east")
print("nodes in the wall:", np.count_nonzero(scene.inside(shaded.position)))
