#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that sentences in the manual, in comments and in shipped documents name their subjects. Usage: prose_rule.py
[ROOT]

tests/support/check_sentence.h lists words that make a sentence depend on the previous one, and applies them to the
descriptions of parameters. Within a paragraph, a sentence may refer to an earlier one ("It grows ..."), so running text
is checked with a subset of the words. Descriptions of variables in shipped documents are tooltips, like descriptions of
parameters, and are checked with all words.
"""

from __future__ import annotations

import io
import json
import os
import re
import sys
import tokenize
from pathlib import Path
from typing import Iterator

# Words that are allowed within a paragraph, but not in a tooltip.
WITHIN_PARAGRAPHS = {"The same", "That ", "Its ", "It ", "They ", "Their ", "Also ", "Another ", "At the ", "Else",
                     "Where ", "Which ", "The one ", "How it ", "At which", "Within which", "the same", "so much", "as above",
                     "see above", "mother", "daughter", "how they", "of which", "hangs on", "worked out", "come to lie",
                     "heavier"}
MOST_BYTES = 200
LEAST_SENTENCES = 1000  #: fewer sentences in the whole project mean that the rule is broken
MADE = ("build", "node_modules", "out", "env")
SOURCES = (".h", ".cpp", ".ts", ".tsx", ".mjs")
HELD_ELSEWHERE = ("docs/manual/components.md", "tests/support/check_sentence.h",
                  "meristem/document/sentences_test.cpp", "tests/architecture/prose_rule.py",
                  "tests/architecture/prose_rule_test.py")


def word_lists(root: Path) -> tuple[list[str], list[str]]:
    """Returns the lists of openings and phrases in the header."""
    header = (root / "tests/support/check_sentence.h").read_text(encoding="utf-8")
    return tuple(re.findall(r'"([^"]*)"', re.search(name + r" = \{(.*?)\};", header, re.DOTALL)[1])
                 for name in ("kOpenings", "kLeanings"))


def comments_of_source(text: str) -> Iterator[tuple[int, str]]:
    """Yields line and text of each block of comments. Trailing comments are separate blocks."""
    block, begin = [], 0
    for number, line in enumerate([*text.splitlines(), ""], 1):
        alone = re.match(r"\s*//+[!<]? ?(.*)", line)
        if alone:
            begin = begin if block else number
            block.append(alone[1])
            continue
        if block:
            yield begin, "\n".join(block)
            block = []
        behind = re.search(r"[;,{)]\s*//+<? (.*)", line)
        if behind and '"' not in behind[1]:
            yield number, behind[1]


def comments_of_python(text: str) -> Iterator[tuple[int, str]]:
    before = tokenize.NEWLINE
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            yield token.start[0], token.string.lstrip("#: ")
        elif token.type == tokenize.STRING and before in (tokenize.NEWLINE, tokenize.INDENT, tokenize.NL):
            yield token.start[0], token.string.strip("rf\"'")
        before = token.type


def prose_of_markdown(text: str) -> Iterator[tuple[int, str]]:
    """Yields line and text of each paragraph, item or row, without code."""
    text = re.sub(r"^(```|~~~).*?^\1", lambda code: "\n" * code[0].count("\n"), text, flags=re.MULTILINE | re.DOTALL)
    block, begin = [], 0
    for number, line in enumerate([*text.splitlines(), ""], 1):
        begins = not line.strip() or re.match(r"\s*([-*|#>]|\d+\.) ?", line)
        if begins and block:
            yield begin, "\n".join(block)
            block = []
        if line.strip():
            begin = begin if block else number
            block.append(re.sub(r"^\s*([-*#>|]+|\d+\.) ?", "", line))


def prose_of(path: Path) -> Iterator[tuple[int, str]]:
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".md":
        return prose_of_markdown(text)
    if path.suffix in (".py", ".pyi"):
        return comments_of_python(text)
    return comments_of_source(text)


def faults_of_prose(text: str, openings: list[str], leanings: list[str]) -> Iterator[tuple[int, str]]:
    """Yields the line within the text and the error."""
    text = re.sub(r"`[^`\n]*`", lambda code: "x" * len(code[0]), text)
    for opening in openings:
        for found in re.finditer(rf"(?:^|(?<=[.!?:] )|(?<=[.!?:]\n)){re.escape(opening.strip())}\b(?! course)", text):
            yield text.count("\n", 0, found.start()), f"a sentence opens with '{opening.strip()}'"
    for leaning in leanings:
        pattern = r"\s+".join(re.escape(word) for word in leaning.split())
        for found in re.finditer(rf"\b{pattern}\b", text):
            yield text.count("\n", 0, found.start()), f"has '{leaning.strip()}'"


def tooltip_fault(sentence: str, openings: list[str], leanings: list[str]) -> str:
    if not sentence.endswith("."):
        return "does not end with a full stop"
    if len(sentence.encode()) > MOST_BYTES:
        return "is too long for a tooltip"
    found = [f"opens with '{opening}'" for opening in openings if sentence.startswith(opening)]
    found += [f"has '{leaning}'" for leaning in leanings if leaning in sentence]
    return "" if not found else found[0]


def written_files(root: Path) -> Iterator[Path]:
    """Yields files that people write, without built and fetched files."""
    for folder, folders, files in os.walk(root):
        folders[:] = sorted(name for name in folders if name not in MADE and not name.startswith("."))
        yield from (Path(folder, name) for name in sorted(files))


def check(root: Path, least: int = LEAST_SENTENCES) -> list[str]:
    openings, leanings = word_lists(root)
    of_prose = [[words for words in of_kind if words not in WITHIN_PARAGRAPHS] for of_kind in (openings, leanings)]
    faults, sentences = [], 0
    for path in written_files(root):
        name = path.relative_to(root).as_posix()
        if name in HELD_ELSEWHERE:
            continue
        if path.suffix in (*SOURCES, ".md", ".py", ".pyi"):
            for begin, text in prose_of(path):
                sentences += 1
                faults += [f"{name}:{begin + line}: {what}" for line, what in faults_of_prose(text, *of_prose)]
        elif path.suffix == ".json" and (name.startswith("models/") or name.startswith("docs/manual/figures/")):
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                for variable in re.finditer(r'"(\w+)": \{[^{}]*"doc": ("(?:[^"\\]|\\.)*")', line):
                    sentences += 1
                    what = tooltip_fault(json.loads(variable[2]), openings, leanings)
                    faults += [f"{name}:{number}: the sentence of '{variable[1]}' {what}"] if what else []
    if sentences < least:
        faults.append(f"only {sentences} sentences were found: the rule reads too little")
    return faults


def main() -> int:
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2]).resolve()
    faults = check(root)
    print(*faults, f"{len(faults)} faults", sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
