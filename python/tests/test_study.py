# SPDX-License-Identifier: Apache-2.0
"""The study of growth in the light, with few clouds."""

from __future__ import annotations

import csv
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import meristem
import numpy as np
import pytest

STUDIES = Path(__file__).resolve().parents[2] / "studies"
sys.path.insert(0, str(STUDIES))

import space_colonization_light as study  # noqa: E402
from light_study import expectations, trees  # noqa: E402

FIGURES = ("inclination", "centroid", "lit-share", "inclination-b", "centroid-b", "lit-share-b", "gain", "expected")


def run_script(arguments: list[str], path: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-B", str(STUDIES / "space_colonization_light.py"), *arguments]
    return subprocess.run(command, env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True, timeout=300)


@pytest.fixture(scope="module")
def quick(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Runs a quick study and returns its folder."""
    folder = tmp_path_factory.mktemp("study")
    done = run_script(["--quick", "-o", str(folder)], str(Path(meristem.__file__).parents[1]))
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert "shift_scaled" in done.stdout and "expected" in done.stdout
    return folder


def read_rows(path: Path) -> list[dict[str, str]]:
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def mean_of(folder: Path, response: str, scene: str, strength: float, measure: str) -> float:
    [row] = [
        row
        for row in read_rows(folder / "means.csv")
        if (row["response"], row["scene"], float(row["strength"])) == (response, scene, strength)
    ]
    return float(row[measure])


def make_tree(seed: int, **measures: float) -> trees.Tree:
    plan = trees.Plan(trees.Treatment("shift", "A", 0), seed, 1)
    return trees.Tree(plan, {**dict.fromkeys(trees.MEASURES, 1.0), **measures})


def test_azimuths_are_averaged_on_the_circle() -> None:
    assert trees.circular_mean([350, 10, 30]) == pytest.approx(10)
    assert trees.circular_mean([0, 90], [1, np.sqrt(3)]) == pytest.approx(60)
    assert trees.circular_spread([40, 40]) == pytest.approx(0, abs=1e-6)
    # Unit vectors 120 degrees apart have a mean of length 1/2.
    assert trees.circular_spread([300, 60]) == pytest.approx(np.degrees(np.sqrt(2 * np.log(2))))


def test_the_mean_centroid_is_that_of_the_vectors() -> None:
    mean = trees.take_mean(
        [make_tree(0, centroid_azimuth=0, centroid_radius=3), make_tree(1, centroid_azimuth=90, centroid_radius=3**0.5)]
    )
    assert mean.measures["centroid_azimuth"] == pytest.approx(30)
    assert mean.measures["centroid_radius"] == pytest.approx((3 + 3**0.5) / 2)
    assert mean.spreads["height"] == 0


def test_bands_of_azimuths_reach_over_north() -> None:
    assert expectations.is_between(355, -30, 30, circular=True)
    assert not expectations.is_between(40, -30, 30, circular=True)
    assert not expectations.is_between(355, -30, 30, circular=False)


def test_a_quick_study_writes_its_files(quick: Path) -> None:
    treatments = 2 * sum(len(strengths) for strengths in study.QUICK_STRENGTHS.values())
    assert len(read_rows(quick / "trees.csv")) == study.QUICK_CLOUDS * treatments
    assert len(read_rows(quick / "means.csv")) == treatments
    assert {row["holds"] for row in read_rows(quick / "expectations.csv")} <= {"True", "False"}
    for name in FIGURES:
        assert (quick / f"{name}.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n")


def test_response_a_leans_trees_and_lights_them_less_in_the_open(quick: Path) -> None:
    altitudes = [mean_of(quick, "shift", "A", shift, "inclination_altitude") for shift in (0, 0.005, 0.010)]
    assert altitudes[0] > 85 and altitudes[0] > altitudes[1] > altitudes[2] > 60
    assert mean_of(quick, "shift", "A", 0.010, "inclination_azimuth") == pytest.approx(180, abs=15)
    assert mean_of(quick, "shift", "A", 0.010, "height") > 1.6 * mean_of(quick, "shift", "A", 0, "height")
    lit = [mean_of(quick, "shift", "A", shift, "lit_share_still") for shift in (0, 0.010)]
    assert 0.35 < lit[1] < lit[0] - 0.02 < 0.55


def test_response_a_flees_a_building_and_then_turns_to_the_sun(quick: Path) -> None:
    assert np.cos(np.radians(mean_of(quick, "shift", "B", 0.005, "inclination_azimuth"))) > 0
    assert np.cos(np.radians(mean_of(quick, "shift", "B", 0.010, "inclination_azimuth"))) < 0
    lit = [mean_of(quick, "shift", "B", shift, "lit_share_day") for shift in (0, 0.010)]
    assert 0.35 < lit[0] < lit[1] - 0.03 < 0.55


def test_scaled_clouds_give_trees_of_the_wanted_height(quick: Path) -> None:
    for scene in ("A", "B"):
        for shift in (0, 0.005, 0.010):
            assert mean_of(quick, "shift_scaled", scene, shift, "height") == pytest.approx(3.7, rel=0.03)


def test_response_b_gains_light_at_the_same_height(quick: Path) -> None:
    for response, scene, strength, measure in (
        ("limit", "A", 0.6, "lit_share_still"),
        ("drift", "B", 0.9, "lit_share_day"),
    ):
        gain = mean_of(quick, response, scene, strength, measure) - mean_of(quick, response, scene, 0, measure)
        assert 0.03 < gain < 0.15
        height = mean_of(quick, response, scene, 0, "height")
        assert mean_of(quick, response, scene, strength, "height") == pytest.approx(height, rel=0.02)


def test_without_strength_all_responses_grow_the_same_trees(quick: Path) -> None:
    for scene in ("A", "B"):
        plain = [
            tuple(row[name] for name in ("seed", *trees.MEASURES))
            for row in read_rows(quick / "trees.csv")
            if row["scene"] == scene and float(row["strength"]) == 0 and row["scale"] == "1"
        ]
        assert len(plain) == 4 * study.QUICK_CLOUDS
        assert len(set(plain)) == study.QUICK_CLOUDS


def test_another_number_of_threads_gives_the_same_bytes(quick: Path, tmp_path: Path) -> None:
    with ThreadPoolExecutor(3) as pool:
        treatments = study.list_treatments(study.QUICK_STRENGTHS)
        again = trees.grow_treatments(treatments, study.QUICK_CLOUDS, pool, lambda: None)
    study.write_trees(tmp_path / "trees.csv", again)
    assert (tmp_path / "trees.csv").read_bytes() == (quick / "trees.csv").read_bytes()


def test_without_the_module_the_script_says_how_to_get_it(tmp_path: Path) -> None:
    done = run_script([], str(tmp_path))
    assert done.returncode == 1
    assert "./dev python" in done.stderr and "Traceback" not in done.stderr


def test_numbers_of_threads_below_one_are_refused(tmp_path: Path) -> None:
    done = run_script(["--threads", "0", "-o", str(tmp_path)], str(Path(meristem.__file__).parents[1]))
    assert done.returncode == 2
    assert "at least 1" in done.stderr
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("script", ["cut_leader", "fit_plants", "grass_leaves", "space_colonization_light", "train_trees"])
@pytest.mark.parametrize("module", ["matplotlib", "numpy"])
def test_a_missing_module_is_named_with_its_package(tmp_path: Path, script: str, module: str) -> None:
    (tmp_path / f"{module}.py").write_text(f"raise ModuleNotFoundError('no {module}', name='{module}')\n")
    path = f"{tmp_path}{os.pathsep}{Path(meristem.__file__).parents[1]}"
    done = subprocess.run(
        [sys.executable, "-B", str(STUDIES / f"{script}.py")],
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 1
    assert f"apt-get install python3-{module}" in done.stderr and "./dev studies" in done.stderr
    assert "Traceback" not in done.stderr
