# SPDX-License-Identifier: Apache-2.0
"""The study of a scanned walnut, with few points: of the published walnut, and of a synthetic tree in its place."""

from __future__ import annotations

import csv
import os
import subprocess
import sys
from pathlib import Path

import meristem
import numpy as np
import pytest
from data_sets import linked

STUDIES = Path(__file__).resolve().parents[2] / "studies"
sys.path.insert(0, str(STUDIES))

from scan_study import coverage, walnut  # noqa: E402


def test_points_are_located_on_their_own_shoots() -> None:
    segments = walnut.Segments(
        np.array([[0, 0, 0], [0, 1, 0], [0, 1, 0]], np.float32),
        np.array([[0, 1, 0], [0, 2, 0], [1, 1, 0]], np.float32),
        np.array([0.1, 0.1, 0.02], np.float32), np.array([0, 0, 1], np.uint32), np.array([0, 0, 1], np.uint16),
    )  # fmt: skip
    scan = {
        "position": np.array([[0.1, 0.5, 0], [0.1, 1.7, 0], [0.5, 1.02, 0], [0.01, 1, 0]], np.float32),
        "shoot": np.array([0, 0, 1, 0]),
        "station": np.zeros(4, np.uint32),
    }
    located = coverage.locate(scan, segments)
    assert list(located.segment[:3]) == [0, 1, 2] and located.segment[3] in (0, 1)
    np.testing.assert_allclose(located.distance, [0.1, 0.1, 0.02, 0.01], atol=1e-6)


@pytest.mark.parametrize("tree", ["synthetic", "walnut"] if walnut.FILE.is_file() else ["synthetic"])
def test_quick_study(tree: str, tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": str(Path(meristem.__file__).parents[1])}
    if tree == "synthetic":
        data = linked(tmp_path / "data", {"trees/noylum2.mtg": "trees/sapling.mtg"})
        environment["MERISTEM_SHARED_DATA"] = str(data)
    command = [sys.executable, "-B", str(STUDIES / "scan_walnut.py"), "--quick", "-o", str(tmp_path)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    with open(tmp_path / "classes.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert {row["instrument"] for row in rows} == set(walnut.INSTRUMENTS)
    for name in ("shares.png", "thickness.png", "points.png"):
        assert (tmp_path / name).stat().st_size > 5000
