# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Variable:
    """A value of a document that its expressions use by name; Document.set({name: value}) sets it.

    Variables that are not `private` are the handles that a document offers to its users.
    """

    name: str  #: name in expressions and in Document.set()
    value: float  #: present value
    min: float  #: smallest sensible value; smaller values are not refused
    max: float  #: largest sensible value; larger values are not refused
    unit: str  #: unit for readers, such as "m"; may be empty
    doc: str  #: what the variable changes, in one sentence; may be empty
    expression: str | None = None  #: formula of the value, such as "2 + 0.1*age"; None for plain numbers
    private: bool = False  #: true: no handle, but a name for a value that several expressions share
