#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every link of the pages leads to a file, and to a heading where it names one. Usage: page_links_test.py ROOT"""

import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1]).resolve()
pages = [*root.glob("*.md"), *sorted((root / "docs").glob("**/*.md"))]


def without_code(text: str) -> str:
    return re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)


def anchors_of(page: pathlib.Path) -> set[str]:
    """The names that links give a page's headings, as code hosts make them."""
    anchors = set()
    for heading in re.findall(r"^#+ (.*)$", without_code(page.read_text(encoding="utf-8")), re.MULTILINE):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        anchors.add(re.sub(r"[^\w\- ]", "", plain.strip().lower()).replace(" ", "-"))
    return anchors


links = 0
faults = 0
for page in pages:
    for target in re.findall(r"\[[^\]]*\]\(([^)\s]+)\)", without_code(page.read_text(encoding="utf-8"))):
        if re.match(r"[a-z]+:", target):
            continue
        links += 1
        name, _, anchor = target.partition("#")
        path = (page.parent / name).resolve() if name else page
        if not path.exists():
            wrong = "there is no such file"
        elif anchor and anchor not in anchors_of(path):
            wrong = "the page has no such heading"
        else:
            continue
        faults += 1
        print(f"{page.relative_to(root)}: {target}: {wrong}")
print(f"{links} links, {faults} faults")
sys.exit(links == 0 or faults > 0)
