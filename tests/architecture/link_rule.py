#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that every link of the Markdown pages has a target. Usage: link_rule.py [ROOT]

In:  the root of a source tree (by default this one).
Out: one line per error, `page:line: link: message`, and exit code 1.

A link leads to a file or folder of the tree. With `#` it leads to a heading of that page, named like code hosts name
headings. A picture is a file with a picture's extension. Links from the README must lead to every page below `docs`,
directly or indirectly. Every picture below `docs` is shown or linked by a page. The rule reads only links of the form
`[text](target)`; other forms are errors.
"""

from __future__ import annotations

import posixpath
import re
import sys
from pathlib import Path, PurePosixPath
from typing import Callable, Iterator, NamedTuple

import prose_rule

PICTURES = {".jpg", ".png", ".svg"}
START = PurePosixPath("README.md")
LEAST_LINKS = 500  #: fewer links in the whole project mean that the rule is broken

CODE_BLOCK = re.compile(r"^(```|~~~).*?^\1", re.MULTILINE | re.DOTALL)
INLINE_CODE = re.compile(r"`[^`\n]*`")
LINK = re.compile(r"(!?)\[((?:[^\[\]]|!?\[[^\[\]]*\](?:\([^)\s]*\))?)*)\]\(([^)\s]+)\)")
OTHER_FORM = re.compile(r"^\[[^\]]+\]: |\]\[[^\]]*\]|<(?:a|img)\b", re.MULTILINE)


class Link(NamedTuple):
    line: int  #: line of the page, from 1
    target: str  #: as written
    is_picture: bool


def without_code(text: str) -> str:
    """Returns the text with its code blanked, keeping lines and columns."""
    return INLINE_CODE.sub(lambda code: "x" * len(code[0]), without_blocks(text))


def without_blocks(text: str) -> str:
    return CODE_BLOCK.sub(lambda code: re.sub(r"[^\n]", " ", code[0]), text)


def matches_of(text: str) -> Iterator[re.Match[str]]:
    """Yields all links of a text. A picture inside a link comes after the link."""
    for found in LINK.finditer(text):
        yield found
        yield from LINK.finditer(text, found.start(2), found.end(2))


def links_of(text: str) -> list[Link]:
    text = without_code(text)
    return [Link(1 + text.count("\n", 0, found.start()), found[3], found[1] == "!") for found in matches_of(text)]


def with_targets(text: str, new_target: Callable[[Link], str]) -> str:
    """Returns the text with new targets of links."""
    bare = without_code(text)
    changes = [(found.start(3), found.end(3), new_target(Link(0, found[3], found[1] == "!"))) for found in matches_of(bare)]
    for begin, end, target in sorted(changes, reverse=True):
        text = text[:begin] + target + text[end:]
    return text


def file_of(page: PurePosixPath, target: str) -> PurePosixPath | None:
    """Returns the file that a link of a page names, as a path in the tree. None for links to the web and within the
    page."""
    name = target.partition("#")[0]
    if not name or re.match(r"[a-z]+:", name):
        return None
    return PurePosixPath(posixpath.normpath(page.parent / name))


def anchors_of(text: str) -> set[str]:
    """Returns the anchors of a page's headings. A repeated heading has a number after its name."""
    counts: dict[str, int] = {}
    anchors = set()
    for heading in re.findall(r"^#+ (.*)$", without_blocks(text), re.MULTILINE):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        name = re.sub(r"[^\w\- ]", "", plain.strip().lower()).replace(" ", "-")
        earlier = counts.get(name, 0)
        counts[name] = earlier + 1
        anchors.add(f"{name}-{earlier}" if earlier else name)
    return anchors


class Tree:
    """The Markdown pages of a source tree."""

    def __init__(self, root: Path) -> None:
        self.root = root
        found = [path.relative_to(root).as_posix() for path in prose_rule.written_files(root) if path.suffix == ".md"]
        self.texts = {PurePosixPath(name): (root / name).read_text(encoding="utf-8") for name in found}
        self.anchors = {page: anchors_of(text) for page, text in self.texts.items()}

    def fault_of(self, page: PurePosixPath, link: Link) -> str | None:
        file = file_of(page, link.target)
        anchor = link.target.partition("#")[2]
        if file is None and not link.target.startswith("#"):
            return None
        file = page if file is None else file
        if file.parts[:1] == ("..",):
            return "leads out of the repository"
        if not (self.root / file).exists():
            return "there is no such file"
        if link.is_picture and file.suffix not in PICTURES:
            return "is no picture"
        if anchor and anchor not in self.anchors.get(file, set()):
            return "the page has no such heading"
        return None

    def reached(self) -> set[PurePosixPath]:
        """Returns the pages that can be reached from the README by links."""
        seen: set[PurePosixPath] = set()
        waiting = [START]
        while waiting:
            page = waiting.pop()
            if page in seen or page not in self.texts:
                continue
            seen.add(page)
            files = [file_of(page, link.target) for link in links_of(self.texts[page])]
            waiting += [file for file in files if file is not None]
        return seen

    def pictures(self) -> set[PurePosixPath]:
        """Returns the pictures below `docs`."""
        found = (path for path in (self.root / "docs").rglob("*") if path.suffix in PICTURES)
        return {PurePosixPath(path.relative_to(self.root).as_posix()) for path in found}


def check(root: Path, least: int = LEAST_LINKS) -> list[str]:
    tree, faults, count = Tree(root), [], 0
    for page, text in tree.texts.items():
        for link in links_of(text):
            count += 1
            what = tree.fault_of(page, link)
            faults += [] if what is None else [f"{page}:{link.line}: {link.target}: {what}"]
        bare = without_code(text)
        for found in OTHER_FORM.finditer(bare):
            line = 1 + bare.count("\n", 0, found.start())
            faults.append(f"{page}:{line}: {found[0].strip()}: links have the form [text](target)")
    lost = sorted(page for page in tree.texts.keys() - tree.reached() if page.parts[0] == "docs")
    faults += [f"{page}:1: no link leads here from {START}" for page in lost]
    named = {file_of(page, link.target) for page, text in tree.texts.items() for link in links_of(text)}
    unseen = sorted(picture for picture in tree.pictures() if picture not in named)
    faults += [f"{picture}:1: no page shows this picture" for picture in unseen]
    if count < least:
        faults.append(f"only {count} links were found: the rule reads too little")
    return faults


def main() -> int:
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2]).resolve()
    faults = check(root)
    print(*faults, f"{len(faults)} faults", sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
