#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures memory and time of the program for stands of different old oaks.

    MERISTEM=build/release/bin/meristem /usr/bin/python3 bench/oak_stand.py [TREES...]

Each stand has this number of trees (6 and 36 by default), every one grown by itself from `oak` at 160 years, with 2.9
million triangles. The program scans it from 4 stations, measures each tree, and draws it. For each command the table has
the largest memory of the process, bytes per triangle, processor time and time. For two stands or more it also has the
memory of one more tree.

The stand of 120 trees has 345 million triangles, and every command must hold it in at most 4 GB:

    MERISTEM_STAND_TREES=120 ./dev bench oak_stand

MERISTEM_STAND_TREES are the numbers of trees, MERISTEM_STAND_STEP is the angle between pulses in degrees (0.2), and
MERISTEM_STAND_SIZE the size of the picture (800x600). None of the last two changes the memory much. The lines of the
table are written to the file named by MERISTEM_BENCH_TABLE. MERISTEM_BENCH=small runs two stands of saplings.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

SMALL = os.environ.get("MERISTEM_BENCH") == "small"
PROGRAM = os.path.abspath(os.environ.get("MERISTEM", "build/release/bin/meristem"))
AGE = 20 if SMALL else 160
STEP = "2" if SMALL else os.environ.get("MERISTEM_STAND_STEP", "0.2")
SIZE = "80x60" if SMALL else os.environ.get("MERISTEM_STAND_SIZE", "800x600")
MAX_BYTES = 4e9
MANY_TRIANGLES = 300e6  # triangles from which a stand must fit into MAX_BYTES

COMMANDS = {
    "scan": ["scan", "-o", "stand.las", "--set", f"instrument.step={STEP}"],
    "measure": ["measure", "--each", "-o", "stand.csv"],
    "render": ["render", "-o", "stand.png", "--size", SIZE, "--samples", "16"],
}

figures: list[list[str]] = []


class Run(NamedTuple):
    peak: int  # bytes
    processor: float  # seconds
    wall: float  # seconds


def document(trees: int) -> str:
    rows = next(rows for rows in range(int(trees**0.5), 0, -1) if trees % rows == 0)
    return json.dumps(
        {
            "meristem": 1,
            "name": f"Stand of {trees} different oaks",
            "limits": {
                "triangles": 2_000_000_000,
                "instances": 100_000_000,
                "nodes": 200_000_000,
                "mesh_bytes": 20_000_000_000,
            },
            "components": {
                "stand": {
                    "type": "field", "rows": rows, "plants": trees // rows, "row_spacing": 12, "spacing": 12,
                },
                "oak": {"type": "document", "file": "oak", "set": {"age": AGE}},
            },
            "links": [["stand", "oak"]],
        }
    )


def run(folder: Path, arguments: list[str]) -> Run:
    """Runs the program. Its rusage has the largest memory, the VmHWM of /proc."""
    command = [PROGRAM, arguments[0], "stand.json", *arguments[1:], "--quiet"]
    begin = time.perf_counter()
    process = subprocess.Popen(command, cwd=folder)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    wall = time.perf_counter() - begin
    if process.returncode != 0:
        raise SystemExit(f"{' '.join(command)} ended with exit code {process.returncode}")
    return Run(1024 * usage.ru_maxrss, usage.ru_utime + usage.ru_stime, wall)


def triangles_of(folder: Path) -> int:
    command = [PROGRAM, "measure", "stand.json", "--only", "triangles", "--json", "--quiet"]
    done = subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True)
    return int(json.loads(done.stdout)["triangles"])


def tell(figure: str, value: str, asked: str = "", held: bool | None = None) -> None:
    mark = "" if held is None else "held" if held else "not held"
    figures.append([f"oak_stand {figure}", value, "", "", asked, mark])
    print(f"{figure}: {value}{', asked ' + asked if asked else ''}{' (' + mark + ')' if mark else ''}", flush=True)


def measure(trees: int, scratch: Path) -> dict[str, Run]:
    (scratch / "stand.json").write_text(document(trees), encoding="utf-8")
    triangles = triangles_of(scratch)
    print(f"{trees} oaks of {AGE} years: {triangles / 1e6:.1f} million triangles")
    runs = {}
    for name, arguments in COMMANDS.items():
        done = runs[name] = run(scratch, arguments)
        is_bounded = triangles > MANY_TRIANGLES
        tell(
            f"{name} of {trees} oaks",
            f"{done.peak / 1e6:.0f} MB",
            f"<= {MAX_BYTES / 1e6:.0f} MB" if is_bounded else "",
            done.peak <= MAX_BYTES if is_bounded else None,
        )
        print(f"  {done.peak / triangles:.1f} bytes per triangle, {done.processor:.1f} s of processor time, {done.wall:.1f} s")
    return runs


def main() -> None:
    given = sys.argv[1:] or os.environ.get("MERISTEM_STAND_TREES", "").split()
    numbers = sorted({int(text) for text in given}) or ([2, 6] if SMALL else [6, 36])
    if min(numbers) < 1:
        raise SystemExit("a stand has at least 1 tree")
    print(f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}; step {STEP} degrees, picture of {SIZE}")
    runs = {}
    with tempfile.TemporaryDirectory(prefix="meristem-bench-") as scratch:
        for trees in numbers:
            runs[trees] = measure(trees, Path(scratch))
    for few, many in zip(numbers, numbers[1:]):
        for name in COMMANDS:
            more = (runs[many][name].peak - runs[few][name].peak) / (many - few)
            tell(f"{name}, one more oak after {few}", f"{more / 1e6:.1f} MB")
    table = os.environ.get("MERISTEM_BENCH_TABLE")
    if table and not SMALL:
        with open(table, "a", encoding="utf-8") as file:
            file.writelines("\t".join(line) + "\n" for line in figures)
    if any(line[5] == "not held" for line in figures) and not SMALL:
        raise SystemExit(1)


if __name__ == "__main__":
    main()
