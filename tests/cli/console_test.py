#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the sessions in the manual's pages and compares their output. Usage: console_test.py PROGRAM ROOT [PAGE...]

A session is a block of ```console. A line that begins with `$ ` is run, and the following lines are the expected
output. A line of three dots matches any lines. A command without output lines must succeed. If a paragraph before a
block contains only a file name, such as "`tree.json`:", the block is written to that file first. A session may be in a
comment, <!-- console ... -->, before prose that quotes its figures. All sessions of a page run in one folder. In it,
ROOT gives `docs/` and `models/`. A digitised plant of the manual is the published one, if this machine has it. If
not, a synthetic tree stands in for it. The lines then begin with the words that the page shows, and their numbers differ.

Pictures take long to render. Their commands run with --fingerprint instead of a file, which only checks the plant.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

program = str(pathlib.Path(sys.argv[1]).resolve())
root = pathlib.Path(sys.argv[2]).resolve()
pages = [pathlib.Path(page).resolve() for page in sys.argv[3:]] or sorted((root / "docs").glob("**/*.md"))
published = pathlib.Path(os.environ.get("MERISTEM_SHARED_DATA", root.parent / "shared" / "data"))
digitised = {"walnut.mtg": (published / "trees" / "noylum2.mtg", root / "tests" / "data" / "trees" / "sapling.mtg")}

BLOCK = re.compile(r"(?:^`([\w.-]+)`:\n\n)?^(?:```|<!-- )(\w*)\n(.*?)^(?:```|-->)", re.MULTILINE | re.DOTALL)


def is_printed(expected: list[str], printed: list[str]) -> bool:
    """Returns true if the lines match; `...` matches any lines."""
    if not expected:
        return not printed
    if expected[0] == "...":
        return any(is_printed(expected[1:], printed[k:]) for k in range(len(printed) + 1))
    return bool(printed) and expected[0] == printed[0] and is_printed(expected[1:], printed[1:])


def commands_of(block: str) -> list[tuple[str, list[str]]]:
    commands: list[tuple[str, list[str]]] = []
    for line in block.splitlines():
        if line.startswith("$ "):
            commands.append((line[2:], []))
        elif commands:
            commands[-1][1].append(line)
    return commands


def copy_plant(words: list[str], folder: pathlib.Path) -> bool:
    """Copies a digitised plant that the command names into the folder. Returns true if another plant stands in for
    it."""
    stands_in = False
    for name, (source, other) in digitised.items():
        if name in words:
            stands_in = not source.is_file()
            shutil.copy(other if stands_in else source, folder / name)
    return stands_in


def first_words(lines: list[str]) -> list[str]:
    return [line.split(" ", 1)[0] for line in lines]


def run(command: str, folder: pathlib.Path) -> tuple[list[str], bool] | None:
    """Returns the output lines of a command and whether it succeeded. Returns None for a command of another
    program."""
    words = shlex.split(command)
    if words[0] != "meristem":
        return None
    words[0] = program
    if words[1] == "render":
        at = words.index("-o")
        words[at:at + 2] = ["--fingerprint", "--quiet"]
    done = subprocess.run(words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300,
                          check=False, encoding="utf-8")
    lines = [line for line in done.stdout.splitlines() if not re.fullmatch(r"[a-zA-Z ]+ \d+ %", line)]
    return lines, done.returncode == 0


sessions = 0
skipped = 0
failures = 0
for page in pages:
    text = page.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for name in ("docs", "models"):
            (folder / name).symlink_to(root / name)
        for block in BLOCK.finditer(text):
            name, kind, content = block.groups()
            if name and kind != "console":
                (folder / name).write_text(content, encoding="utf-8")
            if kind != "console":
                continue
            sessions += 1
            for command, expected in commands_of(content):
                stands_in = copy_plant(shlex.split(command), folder)
                outcome = run(command, folder)
                if outcome is None:
                    skipped += 1
                    continue
                printed, succeeded = outcome
                if " render " in f" {command} ":
                    expected = []
                if not expected and succeeded:
                    continue
                if stands_in:
                    expected, printed = first_words(expected), first_words(printed)
                if not is_printed(expected, printed):
                    failures += 1
                    line = 1 + text.count("\n", 0, text.index(command, block.start()))
                    print(f"{page.relative_to(root)}:{line}: $ {command}\nthe page says\n  " + "\n  ".join(expected) +
                          "\nand the program\n  " + "\n  ".join(printed[:40]))
print(f"{sessions} sessions, {skipped} commands passed over, {failures} faults")
sys.exit(sessions == 0 or failures > 0)
