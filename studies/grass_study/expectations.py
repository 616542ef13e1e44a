# SPDX-License-Identifier: Apache-2.0
"""The expectations of the study, and whether they hold."""

from __future__ import annotations

from typing import Mapping, Sequence

import numpy as np

from common.tables import Finding

from . import ages, fits, forces, levels
from .ages import AgeError
from .fits import Fit
from .forces import Turn
from .levels import Level
from .light import Case, Lit
from .plants import FIELD

SHARES_SUM = 1e-9
MEDIAN_DISTANCE = 0.007


def percent(value: float) -> str:
    return f"{100 * value:.2f} %"


def check_below(what: str, found: float, limit: float, more: str = "") -> Finding:
    return Finding(what, f"below {percent(limit)}", percent(found) + more, bool(found < limit))


def check_fits(plant: str, measured: Sequence[Fit]) -> list[Finding]:
    far = [fit.distance for fit in measured if fit.is_long]
    smooth = [fit.length for fit in measured if fit.is_smooth]
    areas = [abs(fit.area) for fit in measured]
    return [
        check_below(
            f"{plant}: root mean square distance, midribs of at least {fits.ENOUGH_POINTS} points",
            max(far),
            fits.DISTANCE,
            f" at most in {len(far)}",
        ),
        check_below(f"{plant}: its median", float(np.median(far)), MEDIAN_DISTANCE),
        check_lengths(f"{plant}: length of midribs that turn to and fro by at most {fits.SMOOTH:g}°", smooth),
        check_below(f"{plant}: area off the trapezium rule's", max(areas), fits.AREA, f" at most in {len(areas)}"),
    ]


def check_lengths(what: str, errors: Sequence[float]) -> Finding:
    off = np.abs(errors)
    within = int(np.count_nonzero(off < fits.LENGTH))
    return check_below(
        f"{what}, off the polyline's", float(off.max()), fits.LENGTH, f" at most, {within} of {len(off)} within"
    )


def check_ages(errors: Mapping[int, Sequence[AgeError]]) -> list[Finding]:
    return [
        check_below(
            f"class {name}: median error of the tip at an age that was left out",
            float(np.median([error.tip for error in of_class])),
            ages.TIP,
            f", at most {percent(max(error.tip for error in of_class))}",
        )
        for name, of_class in errors.items()
    ]


def check_levels(of_wheat: Sequence[Level], ten: float, nested: bool) -> list[Finding]:
    kept = max(level.kept_area for level in of_wheat)
    return [
        check_below("median Hausdorff distance of 10 points of 100", ten, levels.TEN_OF_A_HUNDRED),
        Finding(
            "area after a reduction, off that of the whole leaf",
            f"below {levels.KEPT_AREA:g}",
            f"{kept:.1g}",
            kept < levels.KEPT_AREA,
        ),
        Finding("points of coarser levels are among those of finer ones", "always", "yes" if nested else "no", nested),
    ]


def check_forces(turns: Sequence[Turn]) -> list[Finding]:
    found = [turn for turn in turns if np.isfinite(turn.load)]
    worst = max(turn.error for turn in found)
    return [
        Finding(
            "the leaf under the load that was found for a turn, off that turn",
            f"below {percent(forces.AGREES)}",
            f"{worst:.1g} at most in {len(found)}; for {len(turns) - len(found)} of {len(turns)} no load",
            worst < forces.AGREES,
        )
    ]


def check_light(lit: Mapping[Case, Lit]) -> list[Finding]:
    """A field must not absorb more light than falls on its ground, and the shares of leaves must sum to 1."""
    most = max(of.total / FIELD.ground for case, of in lit.items() if case.stand == FIELD.name)
    off = max(abs(float(of.shares.sum()) - 1) for of in lit.values())
    return [
        Finding("light that a field takes, of what falls on it", "at most 1", f"{most:.3f} at most", most <= 1),
        Finding("shares of all leaves of a plant, off 1", f"below {SHARES_SUM:g}", f"{off:.1g}", off < SHARES_SUM),
    ]
