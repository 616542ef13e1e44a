# SPDX-License-Identifier: Apache-2.0
"""Surfaces as arrays: meshes, their instances, and what can be computed on them."""

from __future__ import annotations

import numpy as np

import meristem

birch = meristem.read("birch").grow()
print(f"{birch.triangle_count} triangles of {len(birch.meshes)} meshes, materials {birch.materials}")

# Leaves share meshes, and a frame places each leaf. The centres of the leaves show where the crown has leaves.
places = []
for meshes in birch.meshes:
    if birch.materials[meshes.material].two_sided:
        middle = meshes.mesh.positions.mean(axis=0)
        places.append(middle @ meshes.frames[:, :3] + meshes.frames[:, 3])
height = np.concatenate(places)[:, 1]
counts, edges = np.histogram(height, bins=6)
for count, low, high in zip(counts, edges, edges[1:]):
    print(f"{low:5.1f} to {high:4.1f} m: {count:6d} leaves")

# A skeleton made from arrays can get a surface as well.
bend = np.linspace(0, 1, 20)
arch = meristem.Skeleton(
    np.arange(20) - 1, np.column_stack([bend, np.sqrt(bend), 0 * bend]), radius=0.05 - 0.03 * bend
)
tube = meristem.tubes(arch, sides=16)
print(f"an arch of {len(tube.triangles)} triangles, {tube.area:.3f} m2, {1000 * tube.volume:.2f} litres")
