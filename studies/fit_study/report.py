# SPDX-License-Identifier: Apache-2.0
"""The results that the manual's page quotes, as lines of Markdown."""

from __future__ import annotations

from statistics import median
from typing import Sequence

from .problems import Found

HEAD = (
    "| document | system | planting | median error | largest error | of the variable | growths | ended |",
    "| --- | --- | ---: | ---: | ---: | --- | ---: | --- |",
)
REASONS = {"reached": "found", "growths": "all growths spent", "converged": "nothing new to try"}


def table_lines(found: Sequence[Found]) -> list[str]:
    """Returns one row for each planting: its errors as shares of the variables' ranges."""
    lines = list(HEAD)
    for model, planting in dict.fromkeys((one.model, one.planting) for one in found):
        every = [one for one in found if (one.model, one.planting) == (model, planting)]
        worst = max(every, key=lambda one: one.error)
        middle = median(one.error for one in every)
        lines.append(
            f"| `{model}` | {worst.system} | {planting + 1} | {percent(middle)} | {percent(worst.error)} | "
            f"`{worst.variable}` | {worst.growths} | {REASONS[worst.reason]} |"
        )
    return lines


def percent(share: float) -> str:
    return f"{100 * share:.2f} %"
