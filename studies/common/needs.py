# SPDX-License-Identifier: Apache-2.0
"""The modules that the studies need in addition to Python, and how to install them."""

from __future__ import annotations

import importlib
import sys

REMEDIES = {
    "numpy": "Install it, on Debian with 'apt-get install python3-numpy'.",
    "matplotlib": "It draws the figures. Install it, on Debian with 'apt-get install python3-matplotlib'.",
    "meristem": "Build it with './dev python' and run\nPYTHONPATH=build/release/python /usr/bin/python3 {script}",
}


def need_modules(script: str) -> None:
    """Ends the program with instructions if a module that `script` needs is missing."""
    for name in REMEDIES:
        try:
            importlib.import_module(name)
        except ModuleNotFoundError as missing:
            # An installed module may itself miss another one.
            absent = (missing.name or "").partition(".")[0]
            if absent not in REMEDIES:
                raise
            remedy = REMEDIES[absent].format(script=script)
            sys.exit(f"The Python module '{absent}' is not found. {remedy}\n'./dev studies' installs and builds all of it.")
