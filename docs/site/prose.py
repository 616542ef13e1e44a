# SPDX-License-Identifier: Apache-2.0
"""Turns comments and docstrings into nodes of a page.

A text is a series of paragraphs separated by empty lines. An indented block is code, paragraphs that begin with "- "
are items of a list, and lines that begin with "|" are rows of a table. `Names` in backticks, names of classes such as
MeshScene, and calls such as grow() become links if the reference has them.
"""

from __future__ import annotations

import re
from typing import Callable, Iterator, Optional

from docutils import nodes

#: Returns the address of a name relative to the page, or None.
Resolve = Callable[[str], Optional[str]]

WORD = re.compile(r"(`[^`]+`|\b(?:\w+(?:\.|::))*\w+\(\)|\b[A-Z][a-z0-9]+(?:[A-Z][a-z0-9]*)+\b|\bk[A-Z]\w+\b)")


def link(text: str, address: str) -> nodes.reference:
    return nodes.reference("", "", nodes.Text(text), internal=True, refuri=address)


def inline(text: str, resolve: Resolve) -> list[nodes.Node]:
    """Returns a text on one line with code and links."""
    found: list[nodes.Node] = []
    for part in WORD.split(text):
        is_code = part.startswith("`") and len(part) > 2
        bare = part[1:-1] if is_code else part
        address = resolve(re.sub(r"\(\)$", "", bare)) if WORD.fullmatch(part) else None
        if is_code:
            code = nodes.literal(bare, "" if address else bare)
            if address:
                code += link(bare, address)
            found.append(code)
        elif address:
            found.append(link(bare, address))
        elif part:
            found.append(nodes.Text(part))
    return found


def blocks_of(text: str) -> Iterator[tuple[str, str]]:
    """Yields kind and text of each block: "paragraph", "item", "table" or "code"."""
    lines: list[str] = []

    def block() -> tuple[str, str]:
        if all(line.startswith("    ") or not line for line in lines):
            return "code", "\n".join(line[4:] for line in lines)
        if lines[0].startswith("|"):
            return "table", "\n".join(lines)
        joined = " ".join(line.strip() for line in lines)
        return ("item", joined[2:]) if joined.startswith("- ") else ("paragraph", joined)

    for line in [*text.splitlines(), ""]:
        begins_item = line.startswith("- ")
        begins_code = line.startswith("    ") and bool(lines) and not lines[0].startswith(("    ", "- "))
        ends_code = bool(line) and not line.startswith("    ") and bool(lines) and lines[0].startswith("    ")
        if lines and (not line.strip() or begins_item or begins_code or ends_code):
            yield block()
            lines = []
        if line.strip():
            lines.append(line.rstrip())


def prose(text: str, resolve: Resolve, language: str) -> list[nodes.Node]:
    """Returns the blocks of a text. Neighbouring blocks of code are one block."""
    found: list[nodes.Node] = []
    for kind, block in blocks_of(text):
        before = found[-1] if found else None
        if kind == "code":
            if isinstance(before, nodes.literal_block):
                block = before.astext() + "\n\n" + block
                found.pop()
            found.append(code_block(block, "none" if language == "cpp" and not is_cpp(block) else language))
        elif kind == "table":
            cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in block.splitlines()]
            rows = [[inline(cell, resolve) for cell in row] for row in cells[2:]]
            found.append(table(rows, [1] * len(cells[0]), cells[0]))
        elif kind == "item":
            items = before if isinstance(before, nodes.bullet_list) else nodes.bullet_list()
            if items is not before:
                found.append(items)
            items += nodes.list_item("", nodes.paragraph("", "", *inline(block, resolve)))
        else:
            found.append(nodes.paragraph("", "", *inline(block, resolve)))
    return found


def is_cpp(code: str) -> bool:
    """Returns true if a line ends like a statement. Comments also show grammars, commands and tables."""
    return re.search(r";$", code, re.MULTILINE) is not None


def code_block(text: str, language: str) -> nodes.literal_block:
    return nodes.literal_block(text, text, language=language)


def first_sentence(text: str) -> str:
    """Returns the first sentence of the first paragraph."""
    for kind, block in blocks_of(text):
        if kind == "paragraph":
            found = re.match(r"((?:`[^`]*`|[^`])*?\.)(?=\s|$)", block)  # not within code
            return found[1] if found else block.rstrip(":")
    return ""


def table(rows: list[list[list[nodes.Node]]], widths: list[int], head: list[str]) -> nodes.table:
    """Returns a table of rows of cells."""
    body = nodes.tbody()
    for cells in rows:
        body += nodes.row("", *(nodes.entry("", nodes.paragraph("", "", *cell)) for cell in cells))
    columns = [nodes.colspec(colwidth=width) for width in widths]
    header = nodes.thead("", nodes.row("", *(nodes.entry("", nodes.paragraph(text, text)) for text in head)))
    made = nodes.table("", nodes.tgroup("", *columns, header, body, cols=len(widths)))
    made["classes"] += ["names"]
    return made
