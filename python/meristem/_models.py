# SPDX-License-Identifier: Apache-2.0
"""The plants that are shipped."""

from __future__ import annotations

from pathlib import Path


def folder() -> str:
    """The folder of the shipped models: within the package, or the source tree's."""
    here = Path(__file__).resolve().parent
    installed = here / "models"
    return str(installed if installed.is_dir() else here.parents[1] / "models")


def models() -> list[str]:
    """The names of the shipped models, which read() takes, in alphabetical order."""
    return sorted(path.stem for path in Path(folder()).glob("*.json"))
