# SPDX-License-Identifier: Apache-2.0
"""The folder of shipped plants."""

from __future__ import annotations

from pathlib import Path


def folder() -> str:
    """Returns the folder of the shipped models, in the package or in the source tree."""
    here = Path(__file__).resolve().parent
    installed = here / "models"
    return str(installed if installed.is_dir() else here.parents[1] / "models")
