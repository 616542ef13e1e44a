# SPDX-License-Identifier: Apache-2.0
"""A plant built in Python: components, links, variables and expressions."""

from __future__ import annotations

import meristem

plant = {
    "meristem": 1,
    "name": "Seedling",
    "variables": {"vigour": {"value": 1, "min": 0.5, "max": 2, "doc": "How strongly it grows."}},
    "components": {
        "stem": {"type": "tree", "length": "0.4 * vigour", "radius": 0.006},
        "leaf": {"type": "leaf", "length": "0.09 * vigour * (1 - 0.5*u)", "width": 0.04},
    },
    "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": "round(12 * vigour)", "divergence": 137.508}],
}

document = meristem.Document(plant)
for vigour in (0.5, 1, 2):
    grown = document.set({"vigour": vigour}).grow()
    measures = grown.measure()
    leaves = f"{measures['leaf_count']} leaves, {1e4 * measures['leaf_area']:.0f} cm2"
    print(f"vigour {vigour}: {measures['height']:.2f} m high, {leaves}")

# A plant with other links: the dict is copied, changed and read again.
content = document.to_dict()
content["links"][0]["divergence"] = 180
print(f"in two rows: {meristem.Document(content).grow()}")
