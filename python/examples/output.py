# SPDX-License-Identifier: Apache-2.0
"""Files and pictures."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np

import meristem

bush = meristem.read("bush").grow()
with tempfile.TemporaryDirectory() as folder:
    for name in ("bush.glb", "bush.obj", "bush.ply", "bush.skeleton.ply", "bush.csv", "bush.mtg"):
        bush.save(Path(folder) / name)
    bush.save(Path(folder) / "instanced.glb", instanced=True)
    for path in sorted(Path(folder).iterdir()):
        print(f"{path.name:28} {path.stat().st_size:9} bytes")

# A picture is an array of red, green, blue and alpha; without sky and ground its alpha is the plant's silhouette.
picture = bush.render(size=(160, 160), samples=4, transparent=True)
covered = (picture[..., 3] > 127).mean()
green = (picture[..., 1].astype(int) > picture[..., 0])[picture[..., 3] > 127].mean()
print(f"picture {picture.shape}: {100 * covered:.0f} % covered, {100 * green:.0f} % of that green")

# All nodes as columns, ready for pandas.DataFrame.
table = bush.skeleton_table()
print(f"{len(table['node'])} nodes; thickest {2000 * np.max(table['radius']):.0f} mm")
