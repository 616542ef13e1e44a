# SPDX-License-Identifier: Apache-2.0
"""Reports the progress of a long call over many plants, to a function or as text on standard error."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Optional

#: Called with the number of finished plants and the total, None if it is unknown.
ProgressCallback = Callable[[int, Optional[int]], object]

_EVERY = 1.0  #: seconds between lines on a terminal; 10 elsewhere


def teller(progress: ProgressCallback | bool | None, what: str) -> ProgressCallback | None:
    """Returns the function that is called for finished plants. Raises TypeError if it cannot be called."""
    if progress is None or progress is False:
        return None
    if progress is True:
        return _Words(what).tell
    if not callable(progress):
        raise TypeError(f"progress must be a function of two numbers, or True, not {type(progress).__name__}")
    return progress


def duration_text(seconds: float) -> str:
    """Returns a text such as '8 s', '3 min', '2 h 5 min', '3 days 4 h'."""
    whole = round(seconds)
    if whole < 90:
        return f"{whole} s"
    minutes = round(seconds / 60)
    if minutes < 90:
        return f"{minutes} min"
    hours, minutes = divmod(minutes, 60)
    if hours < 48:
        return f"{hours} h {minutes} min"
    days, hours = divmod(hours, 24)
    return f"{days} days {hours} h"


class _Words:
    """Prints lines such as `1,200 of 10,000 plants, 3 min left`. On a terminal each line replaces the previous one."""

    def __init__(self, what: str) -> None:
        self._what = what
        self._begin = time.monotonic()
        self._shown = self._begin
        self._first: int | None = None

    def tell(self, done: int, total: int | None) -> None:
        now = time.monotonic()
        if self._first is None:
            self._first = done - 1  # plants that existed before take no time
        is_over = total is not None and done >= total
        shows = sys.stderr.isatty()
        if not is_over and now - self._shown < (_EVERY if shows else 10 * _EVERY):
            return
        self._shown = now
        text = f"{done:,} of {total:,} {self._what}s" if total is not None else f"{done:,} {self._what}s"
        made = done - self._first
        if total is not None and not is_over and made > 0:
            text += f", {duration_text((now - self._begin) / made * (total - done))} left"
        if shows:
            print(f"\r\033[K{text}", end="\n" if is_over else "", file=sys.stderr, flush=True)
        else:
            print(text, file=sys.stderr, flush=True)
