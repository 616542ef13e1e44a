# SPDX-License-Identifier: Apache-2.0
"""Fits a bush to the height, the width and the wood of a measured bush."""

from __future__ import annotations

import meristem

MEASURED: dict[str, float | tuple[float, float] | meristem.Target] = {"height": 2.9, "crown_mean_width": (2.5, 2.7), "length": meristem.Target(130, scale=20)}


def main() -> None:
    bush = meristem.read("bush")
    result = meristem.fit(bush, ["crown_height", "crown_width", "branches"], MEASURED, growths=60, tolerance=0.002)
    for name, value in result.values.items():
        print(f"{name:<18}{value:g}")
    for name, error in result.errors.items():
        print(f"{name:<18}{result.measures[name]:.3g}, {100 * error:+.1f} % of the scale")
    print(f"{result.growths} growths, {result.reason}")
    print(result.text.splitlines()[0])


if __name__ == "__main__":
    main()
