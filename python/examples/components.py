# SPDX-License-Identifier: Apache-2.0
"""The component types, their parameters, and a plant of each type that can stand alone."""

from __future__ import annotations

from typing import Any

import meristem

types = meristem.components()
for name, facts in types.items():
    print(f"{name:10} {len(facts['parameters']):3} parameters: {facts['doc']}")

step = types["colonize"]["parameters"]["step"]
print(f"\ncolonize.step: {step['doc']} {step['expected']}, default {step['default']}")

needed: dict[str, dict[str, Any]] = {"colonize": {"crown": {"profile": [[0, 0.5], [0.5, 1.5], [0, 3]]}, "points": 200}}
for name in ("colonize", "leaf", "tree"):
    component: dict[str, Any] = {"type": name, **needed.get(name, {})}
    print(meristem.Document({"meristem": 1, "name": name, "components": {name: component}}).grow())
