# SPDX-License-Identifier: Apache-2.0
"""Where the plants that are shipped stand."""

from __future__ import annotations

from pathlib import Path


def folder() -> str:
    """The folder of the shipped models: within the package, or the source tree's."""
    here = Path(__file__).resolve().parent
    installed = here / "models"
    return str(installed if installed.is_dir() else here.parents[1] / "models")
