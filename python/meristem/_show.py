# SPDX-License-Identifier: Apache-2.0
"""Shows a plant: in notebooks, on desktops, and elsewhere."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ._core import Document, Plant
from ._errors import MachineError
from ._page import PageInNotebook, has_viewer, is_page, save_html, to_html

_QUICK: dict[str, Any] = {"size": (400, 400), "samples": 4}  # under a second for the shipped trees
_FAIR: dict[str, Any] = {"size": (480, 480), "samples": 8}  # for a requested picture, which may take a second or two
_OPENING_SECONDS = 2.0  #: seconds after which a running opener has found a program for the file


def show(
    self: Plant,
    path: str | os.PathLike[str] | None = None,
    *,
    size: tuple[int, int] | None = None,
    samples: int | None = None,
    view: tuple[float, float] | None = None,
) -> Path | None:
    """Shows the plant in a notebook, in a browser or as a picture. Returns the path of the written file, if any.

    With a `path`, writes a picture (.png, .jpg), a page with the plant to turn (.html), or a file of save() (.glb and
    others). Without a `path`, shows the plant in a notebook, where the user can turn it; on a desktop, opens such a
    page in the browser. Elsewhere, or without a browser, writes a picture NAME.png into the current folder, never over
    another file, and prints the path. A module that was built without the view shows a picture in notebooks, and opens
    a .glb file in the system's program for it.

    `size` is (width, height) in pixels and `view` (azimuth, altitude) of the camera in degrees, as in png(); `samples`
    is the number of light paths per pixel; if it is given, a still picture is shown. Default size and samples come from
    the document with a `path`, and are small without. Raises InputError for unknown endings, sizes out of range and
    files that the document reads, and MachineError if the file cannot be written.
    """
    given = {name: value for name, value in (("size", size), ("samples", samples), ("view", view)) if value is not None}
    if path is not None:
        return _write(self, Path(path), given)
    if _is_notebook():
        if has_viewer() and samples is None:
            _display(PageInNotebook(to_html(self, view=view), size))
        else:
            _display(_picture(self.png(**{**_FAIR, **given})))
        return None
    if _has_desktop() and (opened := _open_in_program(self, given)):
        return opened
    written = _write_beside_others(self.png(**{**_FAIR, **given}), _file_name(self))
    print(f"The picture is in {written}")
    return written


def make_preview(self: Plant) -> bytes:
    """Returns a small picture as the bytes of a PNG file, which notebooks show for a plant."""
    return self.png(**_QUICK)


def describe(self: Document) -> str:
    """Returns the document's name, its description, and its handles as a table, which notebooks show for it."""
    lines = [f"**{_cell(self.name or 'Document')}**, seed {self.seed}", ""]
    if self.description:
        lines += [_cell(self.description), ""]
    handles = [v for v in self.variables if not v.private]
    if handles:
        lines += ["| variable | value | from | to | unit | |", "| --- | ---: | ---: | ---: | --- | --- |"]
    for v in handles:
        lines.append(f"| `{v.name}` | {v.value:g} | {v.min:g} | {v.max:g} | {_cell(v.unit)} | {_cell(v.doc)} |")
    return "\n".join(lines)


def _cell(text: str) -> str:
    """Returns plain text within Markdown, on one line."""
    return re.sub(r"([\\`*_|<>\[\]])", r"\\\1", " ".join(text.split()))


def _write(plant: Plant, path: Path, given: Mapping[str, Any]) -> Path:
    if path.suffix.lower() in (".png", ".jpg", ".jpeg"):
        plant.save_picture(path, **given)
        return path
    if is_page(path):
        if given.keys() - {"view"}:
            raise ValueError(f"{', '.join(given)} are for pictures (.png, .jpg); of them '{path.name}' takes the view")
        save_html(plant, path, **given)
        return path
    if given:
        raise ValueError(f"{', '.join(given)} are for pictures (.png, .jpg), not for '{path.name}'")
    plant.save(path)
    return path


def _is_notebook() -> bool:
    """Returns true in an IPython kernel. IPython at a terminal shows no pictures."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell is not None and getattr(shell, "kernel", None) is not None


def _display(what: object) -> None:
    from IPython.display import display  # type: ignore[import]  # is there, as the kernel is

    display(what)


def _picture(png: bytes) -> object:
    from IPython.display import Image

    return Image(data=png, format="png")


def _has_desktop() -> bool:
    return sys.platform in ("darwin", "win32") or any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY"))


def _open_in_program(plant: Plant, given: Mapping[str, Any]) -> Path | None:
    """Opens the plant in a program and returns the file. Returns None if no program can show it."""
    if given.keys() - ({"view"} if has_viewer() else set()):
        return None
    folder = Path(tempfile.mkdtemp(prefix="meristem-"))
    path = folder / f"{_file_name(plant)}.{'html' if has_viewer() else 'glb'}"
    _write(plant, path, given)
    if _open(path):
        return path  # it stays, because the program may read it again
    shutil.rmtree(folder, ignore_errors=True)
    return None


def _open(path: Path) -> bool:
    if sys.platform == "win32":
        try:
            os.startfile(path)
        except OSError:
            return False
        return True
    opener = shutil.which("open" if sys.platform == "darwin" else "xdg-open")
    if opener is None:
        return False
    process = subprocess.Popen(
        [opener, str(path)], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    try:
        return process.wait(_OPENING_SECONDS) == 0
    except subprocess.TimeoutExpired:
        return True


def _file_name(plant: Plant) -> str:
    return re.sub(r"[^\w-]+", "-", plant.document.name).strip("-").lower() or "plant"


def _write_beside_others(png: bytes, name: str) -> Path:
    """Writes NAME.png into the current folder, or NAME-2.png and so on if the file exists."""
    number = 1
    while True:
        path = Path(f"{name}.png" if number == 1 else f"{name}-{number}.png")
        try:
            with path.open("xb") as file:
                file.write(png)
            return path
        except FileExistsError:
            number += 1
        except OSError as error:
            raise MachineError(f"cannot write '{path}' in the current folder: {error.strerror}") from error
