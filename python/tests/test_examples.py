# SPDX-License-Identifier: Apache-2.0
"""Runs each example in a separate folder, as a user would."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

import meristem

EXAMPLES = sorted((Path(__file__).resolve().parents[1] / "examples").glob("*.py"))


def test_there_are_examples() -> None:
    assert EXAMPLES


@pytest.mark.parametrize("example", EXAMPLES, ids=[example.stem for example in EXAMPLES])
def test_the_example_runs_and_prints(example: Path, tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": str(Path(meristem.__file__).parents[1]), "MPLBACKEND": "Agg"}
    run = subprocess.run([sys.executable, "-B", str(example)], cwd=tmp_path, env=environment,
                         capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert run.stdout.strip()
    assert run.stderr == ""
