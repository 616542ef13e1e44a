# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Variable:
    """A value of a document that its expressions use by name; Document.set({name: value}) sets it.

    Those that are not `private` are the handles that a document offers to its users.
    """

    name: str
    value: float
    min: float  #: least and greatest sensible value; nothing is refused beyond them
    max: float
    unit: str
    doc: str
    expression: str | None = None  #: from which the value was worked out, such as "2 + 0.1*age"; None for plain numbers
    private: bool = False  #: no handle, but a name for what several expressions share
