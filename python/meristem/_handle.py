# SPDX-License-Identifier: Apache-2.0
"""The variables that a fit may change, and their ranges."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Tuple, Union

from ._core import Document
from ._variable import Variable

#: None for the range that the document declares; (low, high); or range(low, beyond, step) for whole numbers
Range = Union[None, Tuple[float, float], range]


@dataclass(frozen=True)
class Handle:
    """A variable with the values that it may take."""

    name: str
    low: float
    high: float
    whole: range | None  #: the values, if it has whole numbers only

    @property
    def may_be_whole(self) -> bool:
        """Returns true if the document may round the variable, such as a number of leaves."""
        return self.whole is None and self.low == round(self.low) and self.high == round(self.high) > self.low + 1

    def value_at(self, share: float) -> float | int:
        """Returns the value at a share of the range, from 0 to 1, with as many digits as a document needs."""
        share = min(max(share, 0.0), 1.0)
        if self.whole is not None:
            return self.whole[min(int(share * len(self.whole)), len(self.whole) - 1)]
        # Six digits of the range, so that the written document grows this plant.
        digits = 5 - math.floor(math.log10(self.high - self.low))
        value = round(self.low + share * (self.high - self.low), max(digits, 0))
        return min(max(value, self.low), self.high)

    def share_of(self, value: float) -> float:
        """Returns the position of a value in the range, from 0 to 1."""
        if self.whole is not None:
            return min(max(((value - self.whole[0]) / self.whole.step + 0.5) / len(self.whole), 0.0), 1.0)
        return min(max((value - self.low) / (self.high - self.low), 0.0), 1.0)


def check_handles(document: Document, variables: str | Iterable[str] | Mapping[str, Range]) -> list[Handle]:
    """Raises TypeError and ValueError for names that a fit cannot change, with the nearest valid names."""
    if not isinstance(variables, Iterable):
        raise TypeError(f"variables must be names, or a dict of ranges, not {type(variables).__name__}")
    if isinstance(variables, str):
        variables = [variables]
    ranges = dict(variables) if isinstance(variables, Mapping) else {name: None for name in variables}
    if not ranges:
        raise ValueError("variables must have at least one name, such as ['age']")
    return [_handle(document, name, given) for name, given in ranges.items()]


def _handle(document: Document, name: Any, given: Range) -> Handle:
    known = {variable.name: variable for variable in document.variables}
    open_ones = [variable.name for variable in document.variables if _is_open(variable)]
    variable = known.get(name)
    if variable is None:
        raise ValueError(f"{_name_of(document)} has no variable {name!r}; {_expected(name, open_ones)}")
    if variable.expression is not None:
        behind = [other for other in open_ones if other in variable.expression]
        source = f"the variable {name!r} is computed as {variable.expression!r}"
        raise ValueError(f"{source}; {_expected(name, behind or open_ones)}")
    if variable.private:
        raise ValueError(f"the variable {name!r} is private; {_expected(name, open_ones)}")
    return _ranged(variable, given)


def _ranged(variable: Variable, given: Range) -> Handle:
    where = f"the range of {variable.name!r}"
    if isinstance(given, range):
        if len(given) < 2 or given.step < 0:
            raise ValueError(f"{where} is {given}; expected at least two whole numbers that rise")
        return Handle(variable.name, given[0], given[-1], given)
    low, high = (variable.min, variable.max) if given is None else _ends(where, given)
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        hint = "; give one, such as {'age': (10, 40)}" if given is None else ""
        raise ValueError(f"{where} is {low:g} to {high:g}; expected one that rises{hint}")
    return Handle(variable.name, low, high, None)


def _ends(where: str, given: Any) -> tuple[float, float]:
    try:
        low, high = given
        return float(low), float(high)
    except (TypeError, ValueError):
        raise TypeError(f"{where} must be (low, high), range(low, beyond), or None, not {given!r}") from None


def _is_open(variable: Variable) -> bool:
    return variable.expression is None and not variable.private


def _expected(name: Any, names: list[str]) -> str:
    near = difflib.get_close_matches(str(name), names, 1, 0.5)
    if near:
        return f"expected {near[0]!r}, or another of {', '.join(names)}" if len(names) > 1 else f"expected {near[0]!r}"
    return f"expected one of {', '.join(names)}" if names else "it has no variables that can be turned"


def _name_of(document: Document) -> str:
    return f"{document.name!r}" if document.name else "the document"
