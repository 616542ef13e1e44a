# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Variable:
    """A value of a document that its expressions use by name; Document.set({name: value}) sets it.

    Variables that are not `private` are the handles that a document offers to its users.
    """

    name: str
    value: float
    min: float  #: smallest and largest sensible value; values beyond them are not refused
    max: float
    unit: str
    doc: str
    expression: str | None = None  #: formula of the value, such as "2 + 0.1*age"; None for plain numbers
    private: bool = False  #: true: no handle, but a name for a value that several expressions share
