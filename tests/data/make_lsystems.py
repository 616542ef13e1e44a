#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes reference/lsystems.json: figures of L-systems, computed by a program that shares no code with the library.

`make_lsystems.py [FOLDER]` writes below FOLDER, or below its own folder. Each entry has the length of the word after
each step, the counts of its symbols, the SHA-256 of the last word and, for drawn words, what a turtle draws.

The rules are published in P. Prusinkiewicz, A. Lindenmayer: The Algorithmic Beauty of Plants (Springer 1990), in the
named figures. The system `contexts` has rules of the project's own, in the notation of figure 1.31.
"""

from __future__ import annotations

import hashlib
import json
import math
import sys
from collections import Counter
from pathlib import Path

SYSTEMS: dict[str, dict] = {
    "figure_1.3": {"axiom": "b", "rules": {"a": "ab", "b": "a"}, "n": 10, "delta": 0, "draw": ""},
    "figure_1.9b": {"axiom": "F-F-F-F", "rules": {"F": "FF-F-F-F-FF"}, "n": 4, "delta": 90, "draw": "F"},
    "figure_1.9c": {"axiom": "F-F-F-F", "rules": {"F": "FF-F+F-F-FF"}, "n": 3, "delta": 90, "draw": "F"},
    "figure_1.9d": {"axiom": "F-F-F-F", "rules": {"F": "FF-F--F-F"}, "n": 4, "delta": 90, "draw": "F"},
    "figure_1.9e": {"axiom": "F-F-F-F", "rules": {"F": "F-FF--F-F"}, "n": 5, "delta": 90, "draw": "F"},
    "figure_1.9f": {"axiom": "F-F-F-F", "rules": {"F": "F-F+F-F-F"}, "n": 4, "delta": 90, "draw": "F"},
    "figure_1.10b": {"axiom": "R", "rules": {"L": "R+L+R", "R": "L-R-L"}, "n": 6, "delta": 60, "draw": "LR"},
    "figure_1.24c": {"axiom": "F", "rules": {"F": "FF-[-F+F+F]+[+F-F-F]"}, "n": 4, "delta": 22.5, "draw": "F"},
    "figure_1.24e": {"axiom": "X", "rules": {"X": "F[+X][-X]FX", "F": "FF"}, "n": 7, "delta": 25.7, "draw": "F"},
    "figure_1.24f": {"axiom": "X", "rules": {"X": "F-[[X]+X]+F[+FX]-X", "F": "FF"}, "n": 5, "delta": 22.5, "draw": "F"},
    "contexts": {
        "axiom": "F1F1F1", "n": 24, "delta": 25, "ignore": "+-F",
        "rules": {"000": "1", "001": "1[-F1F1]", "010": "1", "011": "1", "100": "0", "101": "1F1", "110": "1", "111": "0"},
    },
}  # fmt: skip


def left_of(word: str, place: int, ignored: str) -> str:
    """Returns the symbol before `place` on the way to the root, or nothing."""
    depth = 0
    for symbol in reversed(word[:place]):
        if symbol == "]":
            depth += 1
        elif symbol == "[":
            depth = max(depth - 1, 0)
        elif depth == 0 and symbol not in ignored:
            return symbol
    return ""


def right_of(word: str, place: int, ignored: str) -> str:
    """Returns the symbol after `place` on the same axis, or nothing."""
    depth = 0
    for symbol in word[place + 1 :]:
        if symbol == "[":
            depth += 1
        elif symbol == "]":
            if depth == 0:
                return ""
            depth -= 1
        elif depth == 0 and symbol not in ignored:
            return symbol
    return ""


def rewrite(word: str, system: dict) -> str:
    rules = system["rules"]
    if "ignore" not in system:
        return "".join(rules.get(symbol, symbol) for symbol in word)
    parts = []
    for place, symbol in enumerate(word):
        if symbol in "+-":
            parts.append("-" if symbol == "+" else "+")
        elif symbol in "01":
            key = left_of(word, place, system["ignore"]) + symbol + right_of(word, place, system["ignore"])
            parts.append(rules.get(key, symbol))
        else:
            parts.append(symbol)
    return "".join(parts)


def draw(word: str, delta: float, letters: str) -> dict:
    """Draws steps of length 1, the first upward; `+` turns left."""
    x = y = 0.0
    turns = 0
    kept: list[tuple[float, float, int]] = []
    box = [0.0, 0.0, 0.0, 0.0]
    segments = 0
    for symbol in word:
        if symbol in letters:
            x -= math.sin(math.radians(turns * delta))
            y += math.cos(math.radians(turns * delta))
            box = [min(box[0], x), min(box[1], y), max(box[2], x), max(box[3], y)]
            segments += 1
        elif symbol in "+-":
            turns += 1 if symbol == "+" else -1
        elif symbol == "[":
            kept.append((x, y, turns))
        elif symbol == "]":
            x, y, turns = kept.pop()
    return {"segments": segments, "end": [rounded(x), rounded(y)], "bbox": [rounded(value) for value in box]}


def rounded(value: float) -> float:
    return round(value, 4) + 0.0  # no negative zero


def figures_of(system: dict) -> dict:
    word = system["axiom"]
    lengths = [len(word)]
    for _ in range(system["n"]):
        word = rewrite(word, system)
        lengths.append(len(word))
    digest = hashlib.sha256(word.encode()).hexdigest()
    figures = {**system, "lengths": lengths, "counts": dict(sorted(Counter(word).items())), "sha256": digest}
    if system.get("draw"):
        figures["turtle"] = draw(word, system["delta"], system["draw"])
    return figures


def main() -> None:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    entries = {name: figures_of(system) for name, system in SYSTEMS.items()}
    lines = ",\n".join(f"{json.dumps(name)}: {json.dumps(entry)}" for name, entry in entries.items())
    (folder / "reference" / "lsystems.json").write_text("{\n" + lines + "\n}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
