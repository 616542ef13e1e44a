# SPDX-License-Identifier: Apache-2.0
"""A Sphinx extension: pages that are not in the sidebar share it with a page that is.

Sphinx builds the sidebar of every page from all tables of contents, which takes half of its time. The page of a C++
header shows the sidebar of its room. The page of a source file shows the sidebar of the first page. Only the addresses
differ.
"""

from __future__ import annotations

import posixpath
import re
from typing import Any

HREF = re.compile(r'href="(?![a-z]+:)([^"]*)"')


def owner_of(page: str) -> str | None:
    """Returns the page whose sidebar another page shows. None for pages that are in the sidebar."""
    header = re.fullmatch(r"(reference/cpp/\w+)/.*", page)
    if header:
        return header[1]
    return "index" if page.startswith("source/") else None


def moved(html: str, page: str, owner: str) -> str:
    """Returns the links of `owner`'s sidebar as they are on `page`."""
    here = posixpath.dirname(page)

    def change(found: re.Match[str]) -> str:
        target = found[1] if not found[1].startswith("#") else f"{posixpath.basename(owner)}.html{found[1]}".rstrip("#")
        return f'href="{posixpath.relpath(posixpath.join(posixpath.dirname(owner), target), here or ".")}"'

    return HREF.sub(change, html)


def share_sidebar(app: Any, pagename: str, templatename: str, context: dict[str, Any], doctree: Any) -> None:
    owner = owner_of(pagename)
    if owner is None:
        return
    whole = app.sidebars

    def toctree(**options: Any) -> str:
        key = (owner, posixpath.dirname(pagename))
        if key not in whole:
            if owner not in whole:
                whole[owner] = app.builder._get_local_toctree(owner, **options)
            whole[key] = moved(whole[owner], pagename, owner)
        return whole[key]

    context["toctree"] = toctree


def setup(app: Any) -> dict[str, bool]:
    app.sidebars = {}
    # Furo reads context["toctree"] in its own handler, which has the usual priority of 500.
    app.connect("html-page-context", share_sidebar, priority=400)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
