#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints how many lines and functions of each room the tests run.

Reads what `llvm-cov export -summary-only` writes from standard input and takes the root of the sources. `./dev coverage`
calls it. Tests, and files outside the root, do not count.
"""
import json
import sys
from collections import defaultdict
from pathlib import Path

FEW = 60  # percent of the lines of a source; sources below it are listed
SHORT = 20  # lines; shorter sources are not listed


class Share:
    """Counts of what there is and of what has run."""

    def __init__(self) -> None:
        self.count = 0
        self.covered = 0

    def add(self, summary: dict[str, int]) -> None:
        self.count += summary["count"]
        self.covered += summary["covered"]

    def percent(self) -> float:
        return 100 * self.covered / self.count if self.count else 100.0


def room_of(path: Path) -> str:
    """The first two folders: `meristem/graph`, `apps/cli`."""
    return "/".join(path.parts[:2]) if len(path.parts) > 2 else path.parts[0]


def is_counted(path: Path) -> bool:
    return path.parts[0] in ("meristem", "apps", "python") and not path.stem.endswith("_test") and path.stem != "test"


def main() -> int:
    root = Path(sys.argv[1]).resolve()
    lines: dict[str, Share] = defaultdict(Share)
    functions: dict[str, Share] = defaultdict(Share)
    few: list[tuple[float, int, Path]] = []
    for file in json.load(sys.stdin)["data"][0]["files"]:
        path = Path(file["filename"])
        if not path.is_relative_to(root) or not is_counted(path.relative_to(root)):
            continue
        path = path.relative_to(root)
        summary = file["summary"]
        for room in (room_of(path), "all"):
            lines[room].add(summary["lines"])
            functions[room].add(summary["functions"])
        if summary["lines"]["percent"] < FEW and summary["lines"]["count"] >= SHORT:
            few.append((summary["lines"]["percent"], summary["lines"]["count"], path))
    print(f"{'room':24} {'lines':>8} {'run':>8} {'functions':>10} {'run':>8}")
    for room in sorted(lines, key=lambda name: (name == "all", name)):
        print(f"{room:24} {lines[room].count:8} {lines[room].percent():7.1f} % {functions[room].count:9} "
              f"{functions[room].percent():7.1f} %")
    if few:
        print(f"\nsources of at least {SHORT} lines of which less than {FEW} % run:")
        for percent, count, path in sorted(few, key=lambda entry: (entry[0], str(entry[2]))):
            print(f"{percent:6.1f} % of {count:4}  {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
