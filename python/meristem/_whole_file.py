# SPDX-License-Identifier: Apache-2.0
"""Writes files that appear whole or not at all, like the files of the library."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ._core import ScratchFolder


@contextmanager
def whole_file(target: Path) -> Iterator[Path]:
    """Yields a path to write to, and renames the file to `target` unless an exception is raised.

    The file lies in a hidden folder beside the target. The next file that is written there removes the folder of a
    killed program.
    """
    target.parent.stat()  # the folder does not exist
    scratch = ScratchFolder(os.path.abspath(target.parent), ".meristem-")
    partial = Path(scratch.path) / target.name
    try:
        yield partial
        partial.replace(target)
    finally:
        shutil.rmtree(scratch.path, ignore_errors=True)
