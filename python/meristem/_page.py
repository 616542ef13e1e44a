# SPDX-License-Identifier: Apache-2.0
"""Makes a page that shows a plant in three dimensions. The user turns, moves and zooms it, without a server.

The page's template, `viewer.html`, holds the studio's view. It is built with the module if node is installed. Without
it there are no such pages, and has_viewer() returns False.
"""

from __future__ import annotations

import base64
import gzip
import html
import os
import re
from pathlib import Path
from typing import Any

from ._core import Plant, write_whole_file
from ._errors import MachineError

TRIANGLES = 1_000_000  #: triangles of a page by default, which browsers turn smoothly
_TEMPLATE = Path(__file__).with_name("viewer.html")
_ENDINGS = (".html", ".htm")
_HEIGHT = 480  #: height of a view in a notebook, pixels


def has_viewer() -> bool:
    """Returns true if pages can be made."""
    return _TEMPLATE.is_file()


def is_page(path: Path) -> bool:
    return path.suffix.lower() in _ENDINGS


def to_html(
    self: Plant,
    *,
    triangles: int = TRIANGLES,
    view: tuple[float, float] | None = None,
    threads: int = 0,
    progress: Any = None,
) -> str:
    """Returns a page that shows the plant in a browser, where the user turns, moves and zooms it. Needs no server or
    network.

    A plant of more than `triangles` triangles is thinned out to about this number, with a note on the page; 0 keeps
    all. `view` is (azimuth, altitude) of the camera in degrees, as in png(). Raises ValueError for angles out of range,
    and MachineError if the module was built without the view.
    """
    look = "" if view is None else _look(*view)
    template = _template()
    packet = self.packet(triangles=triangles, threads=threads, progress=progress)
    values = {
        "title": html.escape(self.document.name or "Plant"),
        "look": look,
        "packet": base64.b64encode(gzip.compress(packet, 6, mtime=0)).decode(),
    }
    return re.sub(r"\{\{(title|look|packet)\}\}", lambda found: values[found[1]], template)


def save_html(
    self: Plant,
    path: str | os.PathLike[str],
    *,
    triangles: int = TRIANGLES,
    view: tuple[float, float] | None = None,
    threads: int = 0,
    progress: Any = None,
) -> None:
    """Writes the page of to_html() to a .html file, which appears whole or not at all.

    Raises like to_html(), ValueError for other endings, and MachineError if the file cannot be written.
    """
    target = Path(path)
    if not is_page(target):
        raise ValueError(f"'{target.name}' is not a page; expected a name that ends in .html")
    write_whole_file(target, to_html(self, triangles=triangles, view=view, threads=threads, progress=progress))


class PageInNotebook:
    """A page as a frame within another, as notebooks show it."""

    def __init__(self, page: str, size: tuple[int, int] | None) -> None:
        self._page = page
        self._width, self._height = ("100%", _HEIGHT) if size is None else size

    def _repr_html_(self) -> str:
        style = "border: 0; border-radius: 6px; display: block; max-width: 100%"
        return (
            f'<iframe srcdoc="{html.escape(self._page)}" sandbox="allow-scripts" title="A plant in three dimensions" '
            f'width="{self._width}" height="{self._height}" style="{style}"></iframe>'
        )

    def __repr__(self) -> str:
        return "<a plant in three dimensions, which notebooks show>"


def _look(azimuth: float, altitude: float) -> str:
    if not (-360 <= azimuth <= 360 and -89 <= altitude <= 89):
        raise ValueError("view must be an azimuth from -360 to 360 and an altitude from -89 to 89 degrees")
    return f"{float(azimuth):.9g} {float(altitude):.9g}"


def _template() -> str:
    try:
        return _TEMPLATE.read_text(encoding="utf-8")
    except OSError as error:
        raise MachineError(
            f"cannot read '{_TEMPLATE}': the module was built without the view of pages, which needs node; "
            "see the manual's page on Python"
        ) from error
