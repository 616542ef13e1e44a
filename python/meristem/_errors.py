# SPDX-License-Identifier: Apache-2.0
"""What is raised, and the diagnostics that say what is wrong."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Iterable


@dataclass(frozen=True)
class Diagnostic:
    """One thing that is wrong, or odd, with an input."""

    severity: str  #: "error" or "warning"
    message: str  #: what is wrong
    expected: str  #: what was expected, or empty
    nearest: str  #: the nearest valid name, or empty
    path: str  #: its document path, such as "components.leaf.length", or empty
    file: str  #: the file, or empty
    line: int  #: from 1; 0 where not known
    column: int  #: in characters from 1; 0 where not known
    text: str  #: all of it in one line

    def __str__(self) -> str:
        return self.text


class Error(Exception):
    """What everything that meristem raises on its own is."""


class InputError(Error, ValueError):
    """An input is wrong: a document, a file, a limit. `diagnostics` has all that is."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics: tuple[Diagnostic, ...] = tuple(diagnostics)
        super().__init__(self.diagnostics)

    def __str__(self) -> str:
        return "\n".join("warning: " * (d.severity == "warning") + d.text for d in self.diagnostics)


class MachineError(Error, OSError):
    """The machine failed: a disk is full, a path refused."""


class Cancelled(Error):
    """A call was cancelled by its Progress. Nothing is left half-written."""
