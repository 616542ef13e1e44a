# SPDX-License-Identifier: Apache-2.0
"""Paths of the project's own test data, and of published data sets, which only some machines have."""

from __future__ import annotations

import os
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
OWN = PROJECT / "tests" / "data"
PUBLISHED = Path(os.environ.get("MERISTEM_SHARED_DATA", PROJECT.parent / "shared" / "data"))


def data_files(own: str, published: str) -> list[Path]:
    """Returns the project's own file, and the published one if this machine has it. Tests make the same claims about
    both."""
    return [OWN / own, *(path for path in [PUBLISHED / published] if path.is_file())]


def linked(folder: Path, names: dict[str, str]) -> Path:
    """Makes links in `folder` to files of the project under the names of published files. Returns the folder."""
    for published, own in names.items():
        (folder / published).parent.mkdir(parents=True, exist_ok=True)
        (folder / published).symlink_to(OWN / own)
    return folder
