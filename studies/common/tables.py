# SPDX-License-Identifier: Apache-2.0
"""Tables of results, and expectations with the values found."""

from __future__ import annotations

import argparse
import csv
from dataclasses import astuple, dataclass
from pathlib import Path
from typing import Iterable


@dataclass(frozen=True)
class Finding:
    """An expectation and the value found."""

    what: str
    expected: str
    found: str
    holds: bool


def write_table(path: Path, head: Iterable[str], rows: Iterable[Iterable[object]]) -> None:
    """Writes a CSV file. Numbers have seven digits, the precision of 32-bit floats."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(head)
        for row in rows:
            writer.writerow([f"{cell:.7g}" if isinstance(cell, float) else cell for cell in row])


def write_findings(path: Path, findings: Iterable[Finding]) -> None:
    write_table(path, ("what", "expected", "found", "holds"), (astuple(finding) for finding in findings))


def print_findings(findings: Iterable[Finding]) -> None:
    """Prints one line per expectation."""
    for finding in findings:
        print(f"{'yes' if finding.holds else 'NO ':<4}{finding.what}: {finding.expected}; found {finding.found}")


def positive_number(text: str) -> int:
    """Parses a positive number of the command line."""
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError("at least 1")
    return number
