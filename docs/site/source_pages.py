# SPDX-License-Identifier: Apache-2.0
"""A Sphinx extension: pages of the source files that the manual links to.

In:  links `source:PATH`, and sources.json with all such paths (stage.py).
Out: a page for each text file and folder, and a copy of each file below files/.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any, Iterator

from docutils import nodes
from pygments.lexers import get_lexer_for_filename
from pygments.util import ClassNotFound
from sphinx.transforms.post_transforms import SphinxPostTransform

ROOT = Path(__file__).resolve().parents[2]
PICTURES = (".jpg", ".png", ".svg")
LEFT_OUT = {"build", "__pycache__", "node_modules"}
MOST_BYTES = 300_000  # of a file that has a page
#: Documents contain comments, which JSON itself has not.
LEXERS = {".json": "javascript", ".cff": "yaml", ".csv": "text", ".txt": "text"}


def has_page(path: Path) -> bool:
    return path.is_dir() or (path.suffix not in PICTURES and path.stat().st_size <= MOST_BYTES)


def address_of(path: str) -> str:
    """Returns the address of a file from the site's root."""
    return f"source/{path}.html" if has_page(ROOT / path) else f"files/{path}"


class SourceLinks(SphinxPostTransform):
    """Resolves links to source files."""

    default_priority = 900

    def run(self, **kwargs: Any) -> None:
        up = "../" * self.env.docname.count("/")
        for node in self.document.findall(nodes.reference):
            if node.get("refuri", "").startswith("source:"):
                node["refuri"] = up + address_of(node["refuri"].removeprefix("source:"))
                node["internal"] = True


def linked_files(app: Any) -> Iterator[str]:
    """Yields all linked files and folders, and the text files of linked folders."""
    for name in json.loads((Path(app.srcdir) / "sources.json").read_text(encoding="utf-8")):
        yield name
        if (ROOT / name).is_dir():
            yield from files_of_folder(name)


def files_of_folder(name: str) -> list[str]:
    return sorted(path.relative_to(ROOT).as_posix() for path in (ROOT / name).iterdir()
                  if path.is_file() and has_page(path) and path.suffix != ".md")


def language_of(path: Path) -> str:
    if path.suffix in LEXERS:
        return LEXERS[path.suffix]
    try:
        return str(get_lexer_for_filename(path.name).aliases[0])
    except ClassNotFound:
        return "text"


def body_of(app: Any, name: str) -> str:
    path, up = ROOT / name, "../" * (1 + name.count("/"))
    if path.is_dir():
        items = "".join(f'<li><a class="reference internal" href="{up}{address_of(file)}">{Path(file).name}</a></li>'
                        for file in files_of_folder(name))
        return f"<h1>{name}/</h1><ul>{items}</ul>"
    text = path.read_text(encoding="utf-8")
    shown = app.builder.highlighter.highlight_block(text, language_of(path), force=True)
    return f'<h1>{name}</h1><p><a class="reference internal" href="{up}files/{name}">The file itself</a></p>{shown}'


def make_pages(app: Any) -> Iterator[tuple[str, dict[str, Any], str]]:
    for name in sorted(set(linked_files(app))):
        path = ROOT / name
        if path.is_file():
            target = Path(app.outdir) / "files" / name
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(path, target)
        if has_page(path):
            yield f"source/{name}", {"title": name, "body": body_of(app, name), "parents": []}, "page.html"


def setup(app: Any) -> dict[str, bool]:
    app.add_post_transform(SourceLinks)
    app.connect("html-collect-pages", make_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
