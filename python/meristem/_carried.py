# SPDX-License-Identifier: Apache-2.0
"""Sends documents to other machines with the contents of the files that they name."""

from __future__ import annotations

import atexit
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from ._core import Document, ScratchFolder, unpack_files

_kept: list[ScratchFolder] = []  #: until this process ends


class Carried:
    """Pickles a document with its files. Unpickling reads it as a Document again, from a folder of the worker."""

    def __init__(self, document: Document) -> None:
        self._document = document

    def __reduce__(self) -> tuple[Callable[..., Document], tuple[Any, ...]]:
        state: Callable[[], tuple[Any, ...]] = getattr(self._document, "__getstate__")
        text, file, overrides, seed, root = state()
        name, files = self._document.bundle()
        if len(files) == 1:  # it names no files; messages name it as on this machine
            return _read, (text, file, overrides, seed, root)
        return _unpacked, (name, files, overrides, seed, root)


def _read(text: str, file: str, overrides: dict[str, Any], seed: int | None, root: str) -> Document:
    return Document(text, file="" if file == "<python>" else file, set=overrides, seed=seed, root=root)


def _unpacked(
    name: str, files: list[tuple[str, bytes]], overrides: dict[str, Any], seed: int | None, root: str
) -> Document:
    scratch = ScratchFolder(tempfile.gettempdir(), "meristem-")
    atexit.register(shutil.rmtree, scratch.path, ignore_errors=True)
    _kept.append(scratch)
    folder = Path(scratch.path)
    unpack_files(files, folder)
    text = (folder / name).read_text(encoding="utf-8")
    return _read(text, str(folder / name), overrides, seed, str(folder) if root else "")
