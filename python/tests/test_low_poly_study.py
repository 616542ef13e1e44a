# SPDX-License-Identifier: Apache-2.0
"""The study of published low-poly trees must give the tables that the manual quotes."""

from __future__ import annotations

import csv
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import meristem
import pytest

ROOT = Path(__file__).resolve().parents[2]
TABLES = ROOT / "docs" / "manual" / "figures" / "low-poly-study"
PAGE = ROOT / "docs" / "manual" / "low-poly-study.md"
sys.path.insert(0, str(ROOT / "studies"))

import low_poly_trees as study  # noqa: E402
from low_poly_study import bodies, published  # noqa: E402


def rows_of(path: Path) -> list[list[str]]:
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.reader(file))


@pytest.fixture(scope="module")
def quick(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Runs a quick study and returns its folder."""
    folder = tmp_path_factory.mktemp("study")
    command = [sys.executable, "-B", str(ROOT / "studies" / "low_poly_trees.py"), "--quick", "-o", str(folder)]
    path = str(Path(meristem.__file__).parents[1])
    done = subprocess.run(command, env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    return folder


@pytest.mark.parametrize("name", ["trees", "parameters", "readings"])
def test_the_committed_tables_are_what_the_study_gives(quick: Path, name: str) -> None:
    assert rows_of(quick / f"{name}.csv") == rows_of(TABLES / f"{name}.csv")


def test_the_committed_series_begins_as_the_quick_one(quick: Path) -> None:
    series = rows_of(quick / "series.csv")
    assert len(series) == 1 + study.QUICK_ROWS
    assert rows_of(TABLES / "series.csv")[:len(series)] == series


def test_the_page_quotes_the_committed_series() -> None:
    page = PAGE.read_text(encoding="utf-8")
    for row in rows_of(TABLES / "series.csv")[1:]:
        counts = [f"{int(cell):,}" for cell in row[1:5]]
        ratios = [f"{float(cell):.2f}" for cell in row[5:]]
        assert f"| {row[0]} | {' | '.join(counts + ratios)} |" in page


def test_committed_counts_are_near_the_published_ones() -> None:
    for row, wanted in zip(rows_of(TABLES / "series.csv")[2:], published.SERIES[1:]):
        assert int(row[2]) == pytest.approx(wanted.trunk, rel=0.04)
        assert int(row[4]) == pytest.approx(wanted.crown, rel=0.04)


def test_a_hole_is_counted() -> None:
    text = bodies.read(bodies.SPRUCE)
    trunk = bodies.grow_bodies(text, {"surface.resolution": 30, "surface.crown.resolution": 10})["trunk"]
    assert bodies.count_open_edges(trunk) == 0
    assert bodies.count_open_edges(replace(trunk, triangles=trunk.triangles[1:])) == 3
