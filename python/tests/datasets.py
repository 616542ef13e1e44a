# SPDX-License-Identifier: Apache-2.0
"""A small data set of rods that grow fast, for tests."""

from __future__ import annotations

import hashlib
import subprocess
import sys
from pathlib import Path
from typing import Any

import meristem

ROD: dict[str, Any] = {
    "meristem": 1,
    "name": "Rod",
    "licence": "CC0-1.0",
    "variables": {"tall": {"value": 1, "min": 0.5, "max": 2}},
    "components": {"rod": {"type": "tree", "length": "tall", "radius": 0.02, "segments": 4}},
}


def rod() -> meristem.Document:
    return meristem.Document(ROD)


def plan(plants: int, **more: Any) -> dict[str, Any]:
    return {
        "seeds": plants,
        "rows": 50,
        "files": [".csv"],
        "measures": ["height", "nodes"],
        "vary": {"tall": {"normal": [1, 0.3]}},
        **more,
    }


def digest(folder: Path) -> str:
    """Returns a hash of the names and bytes of all files except partial ones."""
    all_files = hashlib.sha256()
    for path in sorted(folder.rglob("*")):
        below = path.relative_to(folder)
        if path.is_file() and below.parts[0] != "partial":
            all_files.update(f"{below}\n".encode())
            all_files.update(path.read_bytes())
    return all_files.hexdigest()


def rows_there(folder: Path) -> int:
    """Returns the number of plants that have a row, in a table or beside the tables."""
    count = 0
    for path in [*folder.glob("manifest/*.csv"), *folder.glob("partial/rows/*.csv")]:
        try:
            # The first line contains the labels; the last line of a part is its hash.
            count += sum(line[:1].isdigit() for line in path.read_text().splitlines())
        except FileNotFoundError:
            pass  # it has just become part of a table
    return count


def python(*arguments: str, folder: Path) -> subprocess.Popen[str]:
    """Starts Python with access to this module and meristem."""
    import os

    path = [str(Path(meristem.__file__).parents[1]), str(Path(__file__).parent)]
    return subprocess.Popen(
        [sys.executable, "-B", *arguments],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(path)},
    )
