# SPDX-License-Identifier: Apache-2.0
"""Installs the package with pip into a new virtual environment without an index, and uses it there."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from meristem import _core

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(_core.__file__).resolve().parents[2]  # the build tree that the tests run in

USE = """
import pathlib
import meristem
package = pathlib.Path(meristem.__file__).parent
document = meristem.read("oak", set={"age": 4}, seed=2)
assert pathlib.Path(document.file).parent == package / "models", document.file
assert "oak" in meristem.models()
assert document.grow(threads=1).node_count > 10
assert (package / "_core.pyi").is_file() and (package / "py.typed").is_file()
assert meristem.__version__ == __import__("importlib.metadata").metadata.version("meristem")
print(package)
"""


def run(*command: str | Path, folder: Path) -> str:
    # The environment of the tests must not affect the new environment.
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "PIP_"))}
    done = subprocess.run([str(word) for word in command], cwd=folder, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_pip_installs_offline(tmp_path: Path) -> None:
    environment, elsewhere = tmp_path / "environment", tmp_path / "elsewhere"
    elsewhere.mkdir()
    run(sys.executable, "-m", "venv", "--system-site-packages", environment, folder=elsewhere)
    python = environment / "bin" / "python"
    run(python, "-m", "pip", "install", "--no-index", "--no-cache-dir", "--config-settings", f"build-dir={BUILD}", ROOT,
        folder=elsewhere)
    assert str(environment) in run(python, "-c", USE, folder=elsewhere)
    run(python, "-m", "pip", "uninstall", "--yes", "meristem", folder=elsewhere)
    assert not list(environment.glob("lib/*/site-packages/meristem*"))
