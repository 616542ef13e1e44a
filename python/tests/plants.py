# SPDX-License-Identifier: Apache-2.0
"""Small documents for tests."""

from __future__ import annotations

from typing import Any

import meristem


def small_tree(**parameters: Any) -> dict[str, Any]:
    """Returns a tree of a few hundred nodes with leaves, as a dict."""
    tree = {"type": "colonize", "points": 300, "crown": {"profile": [[0, 0.6], [0.6, 1.6], [0, 3]]}, **parameters}
    return {
        "meristem": 1,
        "name": "Small tree",
        "seed": 5,
        "scene": {"latitude": 50, "sun": {"day": 170, "hour": 12}},
        "variables": {"size": {"value": 0.06, "min": 0.02, "max": 0.2, "unit": "m", "doc": "Length of leaves."}},
        "components": {"tree": tree, "leaf": {"type": "leaf", "length": "size"}},
        "links": [{"from": "tree", "to": "leaf", "kind": "branch", "density": 40}],
    }


def grown_small_tree() -> meristem.Plant:
    return meristem.Document(small_tree()).grow()


# Settings of the oak, which then has 700,000 nodes and takes seconds.
LONG_GROWTH = {"age": 160, "tree.points": 400000, "tree.step": 0.01, "tree.kill": 0.1}


def long_growth() -> meristem.Document:
    return meristem.read("oak", set=LONG_GROWTH)
