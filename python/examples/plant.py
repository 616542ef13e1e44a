# SPDX-License-Identifier: Apache-2.0
"""Skeletons as columns, for numpy, without copies of nodes."""

from __future__ import annotations

import numpy as np

import meristem

oak = meristem.read("oak", seed=2).grow()
skeleton = oak.stems[0].skeleton
print(f"{len(skeleton)} nodes, columns {', '.join(skeleton.keys())}")

# Segments run from parent to child; roots have the parent -1.
child = skeleton.parent >= 0
segment = skeleton.position[child] - skeleton.position[skeleton.parent[child]]
length = np.linalg.norm(segment, axis=1)
order = skeleton.order[child]
for k in range(int(order.max()) + 1):
    steepness = np.degrees(np.arcsin(np.clip(segment[order == k, 1] / length[order == k], -1, 1)))
    print(f"order {k}: {length[order == k].sum():6.1f} m of wood, {np.median(steepness):4.0f} degrees steep")

# Wood is a cone for each segment.
near, far = skeleton.radius[skeleton.parent[child]], skeleton.radius[child]
volume = (np.pi / 3 * length * (near**2 + near * far + far**2)).sum()
print(f"{1000 * volume:.0f} litres of wood")

# A skeleton made from arrays: a stem with two laterals.
places = np.array([[0, 0, 0], [0, 1, 0], [0.3, 1.4, 0], [0, 2, 0]])
own = meristem.Skeleton([-1, 0, 1, 1], places, radius=[0.05, 0.04, 0.02, 0.03])
print(f"one of our own: {own.measure()['axes']} axes, orders {own.order.tolist()}")
