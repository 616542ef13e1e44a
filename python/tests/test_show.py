# SPDX-License-Identifier: Apache-2.0
"""Display of plants in notebooks, on desktops and elsewhere, with stand-ins for the first two."""

from __future__ import annotations

import json
import os
import stat
import sys
import types
from pathlib import Path
from typing import Any

import meristem
import pytest
from meristem import _page, _show
from plants import grown_small_tree, small_tree

TINY: dict[str, Any] = {"size": (40, 30), "samples": 1}


def size_of_png(png: bytes) -> tuple[int, int]:
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    return int.from_bytes(png[16:20], "big"), int.from_bytes(png[20:24], "big")


@pytest.fixture(autouse=True)
def no_surroundings(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Removes notebook and desktop, and sets the current and the temporary folder to the test's own."""
    monkeypatch.delitem(sys.modules, "IPython", raising=False)
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.chdir(tmp_path)


def add_desktop(monkeypatch: pytest.MonkeyPatch, folder: Path, script: str) -> None:
    """Simulates a desktop whose program for opening files is a shell script."""
    program = folder / "bin" / "xdg-open"
    program.parent.mkdir()
    program.write_text(f"#!/bin/sh\n{script}\n")
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("PATH", str(program.parent) + os.pathsep + os.environ["PATH"])
    monkeypatch.setenv("DISPLAY", ":0")


def test_a_still_is_written_to_a_path() -> None:
    assert grown_small_tree().show("tree.PNG", **TINY) == Path("tree.PNG")
    assert size_of_png(Path("tree.PNG").read_bytes()) == (40, 30)


def test_other_endings_save_the_plant(tmp_path: Path) -> None:
    plant = grown_small_tree()
    plant.save("saved.glb")
    assert plant.show(tmp_path / "shown.glb") == tmp_path / "shown.glb"
    assert Path("shown.glb").read_bytes() == Path("saved.glb").read_bytes()


def test_unknown_endings_and_options_of_pictures_elsewhere_are_refused() -> None:
    plant = grown_small_tree()
    with pytest.raises(meristem.InputError, match="'.xyz' is not a format that can be written"):
        plant.show("tree.xyz")
    with pytest.raises(ValueError, match="size, samples are for pictures .* not for 'tree.glb'"):
        plant.show("tree.glb", **TINY)
    with pytest.raises(meristem.MachineError, match="cannot write 'nowhere/tree.png': No such file"):
        plant.show("nowhere/tree.png", **TINY)
    assert os.listdir() == []


def test_a_texture_that_the_document_reads_is_not_written_over() -> None:
    grown_small_tree().show("bark.png", **TINY)
    before = Path("bark.png").read_bytes()
    content = small_tree()
    content["components"]["tree"]["texture"] = {"picture": "bark.png"}
    Path("tree.json").write_text(json.dumps(content))
    with pytest.raises(meristem.InputError, match="bark.png' would be overwritten, and it is read"):
        meristem.read("tree.json").grow().show("bark.png", **TINY)
    assert Path("bark.png").read_bytes() == before


def test_without_a_desktop_stills_are_written_beside_others(capsys: pytest.CaptureFixture[str]) -> None:
    plant = grown_small_tree()
    Path("small-tree.png").write_text("somebody's")
    assert plant.show(**TINY) == Path("small-tree-2.png")
    assert plant.show(**TINY) == Path("small-tree-3.png")
    assert Path("small-tree.png").read_text() == "somebody's"
    assert capsys.readouterr().out == "The picture is in small-tree-2.png\nThe picture is in small-tree-3.png\n"


def test_a_name_of_signs_alone_still_makes_a_file() -> None:
    plant = meristem.Document({**small_tree(), "name": "../*"}).grow()
    assert plant.show(**TINY) == Path("plant.png")


def without_the_view(monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulates a module that was built without node."""
    monkeypatch.setattr(_page, "_TEMPLATE", Path("nowhere"))


def with_the_view(monkeypatch: pytest.MonkeyPatch, folder: Path) -> None:
    """Simulates a module that was built with node."""
    template = folder / "bin" / "viewer.html"
    template.parent.mkdir(exist_ok=True)
    template.write_text("{{title}}, seen from {{look}}: {{packet}}")
    monkeypatch.setattr(_page, "_TEMPLATE", template)


def add_notebook(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """Simulates an IPython kernel. Returns the list of displayed objects; pictures are their bytes."""
    shown: list[Any] = []
    ipython = types.ModuleType("IPython")
    setattr(ipython, "get_ipython", lambda: types.SimpleNamespace(kernel=object()))
    display = types.ModuleType("IPython.display")
    setattr(display, "Image", lambda data, format: data)
    setattr(display, "display", shown.append)
    monkeypatch.setitem(sys.modules, "IPython", ipython)
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    return shown


def test_a_page_is_written_to_a_path(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    with_the_view(monkeypatch, tmp_path)
    assert grown_small_tree().show("tree.html", view=(30, 10)) == Path("tree.html")
    assert Path("tree.html").read_text().startswith("Small tree, seen from 30 10: ")
    with pytest.raises(ValueError, match="size, samples are for pictures .*; of them 'tree.html' takes the view"):
        grown_small_tree().show("tree.html", **TINY)


def test_a_desktop_opens_a_page(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    add_desktop(monkeypatch, tmp_path, f'cp "$1" {tmp_path}/opened')
    with_the_view(monkeypatch, tmp_path)
    path = grown_small_tree().show(view=(30, 10))
    assert path is not None and path.name == "small-tree.html"
    assert Path("opened").read_bytes() == path.read_bytes()


def test_a_desktop_opens_the_plant_where_there_are_no_pages(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    without_the_view(monkeypatch)
    add_desktop(monkeypatch, tmp_path, f'cp "$1" {tmp_path}/opened.glb')
    path = grown_small_tree().show()
    assert path is not None and path.name == "small-tree.glb"
    assert Path("opened.glb").read_bytes() == path.read_bytes()
    assert path.read_bytes()[:4] == b"glTF"


def test_a_desktop_without_a_program_for_plants_gets_a_still(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    add_desktop(monkeypatch, tmp_path, "exit 3")
    monkeypatch.setattr(_show, "_FAIR", TINY)
    assert grown_small_tree().show() == Path("small-tree.png")
    assert sorted(os.listdir()) == ["bin", "small-tree.png"]


def test_a_notebook_shows_the_plant_in_a_frame(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    shown = add_notebook(monkeypatch)
    with_the_view(monkeypatch, tmp_path)
    assert grown_small_tree().show(size=(300, 200), view=(30, 10)) is None
    [frame] = shown
    assert 'srcdoc="Small tree, seen from 30 10: ' in frame._repr_html_()
    assert 'width="300" height="200"' in frame._repr_html_()
    assert os.listdir() == ["bin"]


def test_a_notebook_shows_a_picture_where_there_are_no_pages_or_samples_are_asked_for(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    shown = add_notebook(monkeypatch)
    without_the_view(monkeypatch)
    assert grown_small_tree().show(size=(40, 30)) is None
    with_the_view(monkeypatch, tmp_path)
    assert grown_small_tree().show(**TINY) is None
    assert [size_of_png(png) for png in shown] == [(40, 30), (40, 30)]


def test_a_plant_is_a_picture_to_notebooks() -> None:
    width, height = size_of_png(grown_small_tree()._repr_png_())
    assert width == height >= 300


def test_a_document_is_a_table_of_its_variables_to_notebooks() -> None:
    lines = meristem.Document({**small_tree(), "description": "A *small*\none | two"})._repr_markdown_().splitlines()
    assert lines[0] == "**Small tree**, seed 5"
    assert lines[2] == r"A \*small\* one \| two"
    assert lines[-1] == "| `size` | 0.06 | 0.02 | 0.2 | m | Length of leaves. |"


def test_private_variables_stand_in_no_table() -> None:
    content = small_tree()
    content["variables"]["half"] = {"value": "size/2", "private": True}
    content["components"]["leaf"]["width"] = "half"
    assert "half" not in meristem.Document(content)._repr_markdown_()
