# SPDX-License-Identifier: Apache-2.0
"""Measures of plants, and the light on their leaves."""

from __future__ import annotations

import numpy as np

import meristem

apple = meristem.read("apple").grow()
measures = apple.measure()
for name in ("height", "crown_width", "leaf_area", "leaf_area_index", "lit_share"):
    print(f"{name:16} {measures[name]:.3f}")

# The light on every organ, in the order of the organs. Where in the crown do leaves get little light?
light = apple.organ_light()
heights = apple.organs.frame[:, 3, 1]
low, high = np.percentile(heights, [25, 75])
for name, which in (("lowest quarter", heights < low), ("highest quarter", heights > high)):
    share = np.average(light["exposure"][which], weights=light["area"][which])
    print(f"{name}: {100 * share:.0f} % of the sun's rays arrive")

# Skeletons can be measured too, under any scene.
low_sun = meristem.Scene({"sun": {"azimuth": 250, "altitude": 15}})
print(f"lit share in the evening: {apple.stems[0].skeleton.measure(scene=low_sun)['lit_share']:.3f}")
