# SPDX-License-Identifier: Apache-2.0
"""Exceptions, and the diagnostics that describe faults."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Iterable


@dataclass(frozen=True)
class Diagnostic:
    """One fault or oddity of an input."""

    severity: str  #: "error" or "warning"
    message: str  #: what is wrong
    expected: str  #: what was expected, or empty
    nearest: str  #: the nearest valid name, or empty
    path: str  #: its document path, such as "components.leaf.length", or empty
    file: str  #: the file, or empty
    line: int  #: line in the file, from 1; 0 if unknown
    column: int  #: in characters from 1; 0 if unknown
    text: str  #: the whole diagnostic in one line

    def __str__(self) -> str:
        return self.text


class Error(Exception):
    """Base class of meristem's own exceptions."""


class InputError(Error, ValueError):
    """An input is wrong: a document or file is faulty, or exceeds a limit. `diagnostics` lists all faults."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics: tuple[Diagnostic, ...] = tuple(diagnostics)
        super().__init__(self.diagnostics)

    def __str__(self) -> str:
        return "\n".join("warning: " * (d.severity == "warning") + d.text for d in self.diagnostics)


class MachineError(Error, OSError):
    """The machine failed: a disk is full, a path refused."""


class Cancelled(Error):
    """A call was cancelled by its Progress. No file is left half-written."""
