# SPDX-License-Identifier: Apache-2.0
"""The study of planted values, with two of them."""

from __future__ import annotations

import csv
import os
import subprocess
import sys
from pathlib import Path

import meristem

STUDIES = Path(__file__).resolve().parents[2] / "studies"
sys.path.insert(0, str(STUDIES))

import fit_plants as study  # noqa: E402
from fit_study.problems import PLANTINGS, PROBLEMS, QUICK, Found, plant  # noqa: E402


def run_script(arguments: list[str], path: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-B", str(STUDIES / "fit_plants.py"), *arguments]
    return subprocess.run(command, env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True, timeout=300)


def test_a_quick_study_finds_what_was_planted(tmp_path: Path) -> None:
    done = run_script(["--quick", "-o", str(tmp_path)], str(Path(meristem.__file__).parents[1]))
    assert (done.returncode, done.stderr) == (0, "")
    with open(tmp_path / "expectations.csv", newline="", encoding="utf-8") as file:
        assert {row["holds"] for row in csv.DictReader(file)} == {"True"}
    with open(tmp_path / "fits.csv", newline="", encoding="utf-8") as file:
        assert len(list(csv.DictReader(file))) == 4 * len(QUICK)
    assert (tmp_path / "found.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n")


def test_twenty_plantings_of_four_variables_cover_all_growth_systems() -> None:
    assert len(PROBLEMS) * PLANTINGS == 20
    assert {problem.system for problem in PROBLEMS} == {"colonize", "organize", "lsystem", "p-graph", "grassleaf"}
    for problem in PROBLEMS:
        assert len(problem.variables) == 4 and len(problem.measures) >= 4
        assert plant(problem, 0) == plant(problem, 0) != plant(problem, 1)


def test_expectations_tell_what_does_not_hold() -> None:
    def found(error: float, growths: int) -> Found:
        return Found("bush", "colonize", 0, "branches", 1, 1, error, growths, 0.1, "growths")

    holds = [finding.holds for finding in study.check([found(0.01, 90), found(0.2, 90), found(0.3, 90)], 100)]
    assert holds == [False, False, True]
    assert all(finding.holds for finding in study.check([found(0.01, 90), found(0.02, 90)], 100))
    assert not study.check([found(0.01, 101)], 100)[-1].holds


def test_without_the_module_the_script_says_how_to_get_it(tmp_path: Path) -> None:
    done = run_script([], str(tmp_path))
    assert done.returncode == 1
    assert "./dev python" in done.stderr and "Traceback" not in done.stderr
