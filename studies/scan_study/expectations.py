# SPDX-License-Identifier: Apache-2.0
"""Expectations from scans of real trees, and whether these scans fulfil them."""

from __future__ import annotations

from typing import Sequence

from common.tables import Finding

from .coverage import Coverage, OrderCoverage, share_of_length
from .walnut import STATIONS


def of(rows: Sequence[Coverage], instrument: str, stations: int = STATIONS) -> list[Coverage]:
    return [row for row in rows if row.instrument == instrument and row.stations == stations]


def check_scans(rows: Sequence[Coverage], orders: Sequence[OrderCoverage]) -> list[Finding]:
    whole = of(rows, "terrestrial")
    shares = [share_of_length(of(rows, "terrestrial", count), "fitted") for count in range(1, STATIONS + 1)]
    thick = {name: of(rows, name)[0].thickness for name in ("terrestrial", "phase", "ray")}
    stem = whole[-1]
    thinnest = whole[0]
    return [
        Finding(
            "limbs look as thick as they are",
            "0.95 to 1.1 of the true radius above 4 cm",
            f"{stem.thickness:.3f}",
            0.95 <= stem.thickness <= 1.1,
        ),
        Finding(
            "the thinnest twigs look thicker than they are",
            "above 1.3 of the true radius below 4 mm",
            f"{thinnest.thickness:.2f}",
            thinnest.thickness > 1.3,
        ),
        Finding(
            "rays without width or noise see twigs as thick as they are",
            "0.85 to 1.1 of the true radius below 4 mm",
            f"{thick['ray']:.3f}",
            0.85 <= thick["ray"] <= 1.1,
        ),
        Finding(
            "more stations let more wood be fitted",
            "from each number to the next",
            ", ".join(f"{100 * share:.0f} %" for share in shares),
            all(a < b for a, b in zip(shares[:-1], shares[1:])),
        ),
        Finding(
            "thin wood is seen less than thick wood",
            "the thinnest class less than the thickest",
            f"{100 * thinnest.fitted:.0f} % and {100 * stem.fitted:.0f} %",
            thinnest.fitted < stem.fitted,
        ),
    ]
