#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the architecture rules of the studio's page (apps/studio/page/src).

In:  the root of a source tree (by default this one).
Out: one line per error, `file:line: message`, and exit code 1. No output and exit code 0 without errors.

The folders have an order. A file imports only files of its own folder and of earlier folders. The files beside the
folders are the entry: they compose the page, may import every folder, and no folder imports them. Only the entry imports
the page's model. Files do not import each other in a circle. All rules count imports of types as well. A source has at
most 251 lines.
"""

import re
import sys
from pathlib import Path
from typing import Iterator, NamedTuple

PAGE = "apps/studio/page/src"
ORDER = ["base", "values", "server", "tables", "document", "view", "viewer", "controls", "page", "saving", "time",
         "files", "find", "rows", "editors", "gizmo", "text", "board", "camera", "scene", "growth", "measures", "grammar",
         "grass", "pruning", "timeline", "dialogs", "panels"]
ENTRY = ""  #: the name of the page's own folder, whose files are the entry
MODEL = "studio.ts"
MODEL_USERS = {"main.tsx"}  #: files that may import the model
MAX_LINES = 251

COMMENT = re.compile(r"/\*.*?\*/|^\s*//[^\n]*", re.MULTILINE | re.DOTALL)
IMPORT = re.compile(r"""(?:\bfrom|\bimport)\s*\(?\s*(['"])(?P<name>\.[^'"\n]*)\1""")


class Fault(NamedTuple):
    place: Path
    line: int
    message: str

    def text(self, root: Path) -> str:
        return f"{self.place.relative_to(root)}:{self.line}: {self.message}"


class Import(NamedTuple):
    line: int
    name: str  #: as written
    target: Path


def sources_below(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.suffix in (".ts", ".tsx"))


def imports_of(path: Path) -> list[Import]:
    text = COMMENT.sub(lambda comment: re.sub(r"[^\n]", " ", comment.group()), path.read_text(encoding="utf-8"))
    return [Import(text.count("\n", 0, found.start("name")) + 1, found["name"], (path.parent / found["name"]).resolve())
            for found in IMPORT.finditer(text)]


def folder_of(page: Path, path: Path) -> str:
    """Returns the first folder of a file below the page's folder. Returns ENTRY for files beside the folders."""
    parts = path.relative_to(page).parts
    return parts[0] if len(parts) > 1 else ENTRY


def import_fault(page: Path, path: Path, one: Import) -> str | None:
    """Returns the reason why a file must not have an import, or None."""
    if not one.target.is_relative_to(page):
        return f"'{one.name}' lies outside of the page"
    if one.target.suffix in (".ts", ".tsx") and not one.target.exists():
        return f"'{one.name}' is no file"
    own, other = folder_of(page, path), folder_of(page, one.target)
    if one.target == page / MODEL and path.relative_to(page).as_posix() not in MODEL_USERS:
        return f"only {', '.join(sorted(MODEL_USERS))} may import {MODEL}; panels import page/page.ts"
    if own == ENTRY or other == own:
        return None
    if other == ENTRY:
        return f"'{one.name}' belongs to the entry, which no folder imports"
    if own in ORDER and other in ORDER and ORDER.index(other) > ORDER.index(own):
        return f"{own} stands before {other} in the order and may not import '{one.name}'"
    return None


def check_folders(page: Path) -> Iterator[Fault]:
    """Checks that the order names exactly the folders with sources."""
    found = {folder_of(page, path) for path in sources_below(page)} - {ENTRY}
    for name in sorted(found - set(ORDER)):
        yield Fault(page / name, 1, "has no place in the order of the page's folders")
    for name in sorted(set(ORDER) - found):
        yield Fault(page, 1, f"has no sources in {name}, which the order names")


def circles_of(edges: dict[Path, list[Path]]) -> list[list[Path]]:
    """Returns the groups of files that reach each other by imports, the largest first (Tarjan's algorithm, without
    recursion)."""
    number: dict[Path, int] = {}
    low: dict[Path, int] = {}
    waiting: list[Path] = []
    circles = []
    for start in edges:
        walk = [] if start in number else [(start, iter(edges[start]))]
        while walk:
            path, others = walk[-1]
            if path not in number:
                number[path] = low[path] = len(number)
                waiting.append(path)
            for other in others:
                if other not in number:
                    walk.append((other, iter(edges.get(other, []))))
                    break
                if other in waiting:
                    low[path] = min(low[path], number[other])
            else:
                walk.pop()
                if walk:
                    low[walk[-1][0]] = min(low[walk[-1][0]], low[path])
                if low[path] == number[path]:
                    begin = waiting.index(path)
                    group, waiting = waiting[begin:], waiting[:begin]
                    if len(group) > 1 or path in edges.get(path, []):
                        circles.append(sorted(group))
    return sorted(circles, key=len, reverse=True)


def check(root: Path) -> list[Fault]:
    page = (root / PAGE).resolve()
    faults = list(check_folders(page))
    edges: dict[Path, list[Path]] = {}
    for path in sources_below(page):
        imports = imports_of(path)
        edges[path] = [one.target for one in imports]
        for one in imports:
            wrong = import_fault(page, path, one)
            if wrong:
                faults.append(Fault(path, one.line, wrong))
        lines = path.read_text(encoding="utf-8").count("\n")
        if lines > MAX_LINES:
            faults.append(Fault(path, MAX_LINES + 1, f"has {lines} lines, more than {MAX_LINES}; split it"))
    for group in circles_of(edges):
        names = ", ".join(path.relative_to(page).as_posix() for path in group)
        faults.append(Fault(group[0], 1, f"{len(group)} files import each other in a circle: {names}"))
    return faults


def main(arguments: list[str]) -> int:
    root = Path(arguments[0]).resolve() if arguments else Path(__file__).resolve().parents[2]
    faults = check(root)
    for fault in faults:
        print(fault.text(root))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
