# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Variable:
    """A value that a document offers to its users; Document.set({name: value}) sets it."""

    name: str
    value: float
    min: float  #: least and greatest sensible value; nothing is refused beyond them
    max: float
    unit: str
    doc: str
