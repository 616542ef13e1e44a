# SPDX-License-Identifier: Apache-2.0
"""The study of grass leaves, with few leaves and little light. Some tests need the measured leaves."""

from __future__ import annotations

import csv
import os
import subprocess
import sys
from pathlib import Path

import meristem
import numpy as np
import pytest
from meristem import grass

STUDIES = Path(__file__).resolve().parents[2] / "studies"
sys.path.insert(0, str(STUDIES))

from grass_study import ages, fits, forces, levels, light, measured, plants  # noqa: E402

FIGURES = ("fits", "errors", "ages", "levels", "triangles", "forces", "light", "plants")
HERE = Path(meristem.__file__).parents[1]
needs_measured = pytest.mark.skipif(
    bool(measured.missing_files(measured.FOLDER)),
    reason="the measured data is not here; MERISTEM_SHARED_DATA may name its folder",
)


def run_script(arguments: list[str], path: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-B", str(STUDIES / "grass_leaves.py"), *arguments]
    environment = {**os.environ, "PYTHONPATH": str(path)}
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=300)


@pytest.fixture(scope="module")
def quick(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Runs a quick study and returns its folder."""
    folder = tmp_path_factory.mktemp("study")
    done = run_script(["--quick", "-o", str(folder)], HERE)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return folder


def read_rows(path: Path) -> list[dict[str, str]]:
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def arc(angle: float, pieces: int = 40) -> grass.GrassLeaf:
    """A leaf that bends evenly from the stem's direction to `angle`."""
    s = np.linspace(0, 1, pieces + 1)
    return grass.turned(grass.GrassLeaf(1, 0.05, s, 0 * s, s, 1 - s), [(0, 1, angle)])


# --- measures ---------------------------------------------------------------------------------------------------------


def test_only_turns_that_are_taken_back_count_as_to_and_fro() -> None:
    leaf = arc(120)
    assert fits.to_and_fro(leaf.x, leaf.y) == pytest.approx(0, abs=1e-6)
    zigzag = np.array([0.0, 1, 0, 1, 0])
    assert fits.to_and_fro(zigzag, np.arange(5.0)) == pytest.approx(180)


def test_an_age_between_arcs_comes_back_in_directions() -> None:
    forms = [ages.Form(age, arc(30.0 * age)) for age in range(5)]
    errors = ages.leave_out(1, forms)
    assert [error.age for error in errors] == [1, 2, 3]
    assert max(error.most for error in errors) < 1e-9 < min(error.nearest for error in errors)


def test_the_hausdorff_distance_of_a_half_circle_and_its_chord_is_the_radius() -> None:
    leaf = arc(180, 400)
    chord = grass.reduced(leaf, pieces=1)
    assert levels.hausdorff(leaf, chord) == pytest.approx(1 / np.pi, rel=1e-3)
    assert levels.hausdorff(leaf, leaf) == pytest.approx(0, abs=1e-12)


def test_a_turn_that_was_asked_for_is_found() -> None:
    turns = forces.find_turns([grass.inclined(arc(0), 20)])
    assert [turn.wanted for turn in turns] == list(forces.TURNS)
    assert max(turn.error for turn in turns) < forces.AGREES


def test_lights_give_one_on_level_ground() -> None:
    for make_rays in light.LIGHTS.values():
        for rays in (make_rays(), light.thin_out(make_rays(), 4)):
            assert sum(ray.strength * np.sin(np.radians(ray.altitude)) for ray in rays) == pytest.approx(1)


def test_a_straight_form_keeps_length_widths_and_its_angle() -> None:
    leaf = plants.full_grown().blades[5]
    for form in (plants.ERECT, plants.CHORD):
        straight = plants.FORMS[form](leaf)
        assert straight.area == pytest.approx(leaf.area, rel=1e-9)
        assert np.ptp(straight.angles) == pytest.approx(0, abs=1e-6)
    assert plants.FORMS[plants.ERECT](leaf).inclination == pytest.approx(leaf.inclination)


def test_a_leaf_alone_takes_light_by_how_it_stands() -> None:
    band = grass.GrassLeaf(0.5, 0.1, [0, 0.5, 1], [0, 0.5, 1], [0, 0, 0], [1, 1, 1])  # horizontal, with constant width
    plant = plants.Plant("bare", [band, band], 0.5, 20)
    zenith = [light.Ray(0, 90, 1)]
    taken = light.measure_light(plant, plants.CURVED, plants.ONE, zenith)
    assert taken.plants == 1
    assert taken.efficiency[1] == pytest.approx(1, abs=1e-3)
    slanted = plants.Plant("bare", [plants.turn_straight(band, 60)] * 2, 0.5, 20)
    taken = light.measure_light(slanted, plants.CURVED, plants.ONE, zenith)
    assert taken.efficiency[1] == pytest.approx(np.sin(np.radians(60)), abs=1e-3)


# --- the whole study --------------------------------------------------------------------------------------------------


@needs_measured
def test_a_quick_study_writes_its_files(quick: Path) -> None:
    assert len(read_rows(quick / "fits.csv")) == 463
    assert len(read_rows(quick / "levels.csv")) == len(levels.PIECES)
    assert len(read_rows(quick / "light.csv")) == len(plants.FORMS) * 2 * len(light.LIGHTS)
    for name in FIGURES:
        assert (quick / f"{name}.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n")


@needs_measured
def test_all_expectations_but_one_hold_in_a_quick_study(quick: Path) -> None:
    rows = read_rows(quick / "expectations.csv")
    assert len(rows) > 12
    [failed] = [row for row in rows if row["holds"] != "True"]
    # Three midribs with few points turn sharply: a curve through them is longer than their chords.
    assert failed["what"].startswith("wheat: length of midribs that turn to and fro")
    assert "23 of 26 within" in failed["found"]


@needs_measured
def test_more_triangles_come_nearer(quick: Path) -> None:
    distances = [float(row["distance"]) for row in read_rows(quick / "levels.csv")]
    assert np.all(np.diff(distances) < 0)


@needs_measured
def test_curved_leaves_take_more_light_than_straight_erect_ones(quick: Path) -> None:
    taken = {(row["form"], row["stand"], row["light"]): float(row["taken"]) for row in read_rows(quick / "light.csv")}
    for stand in (plants.ALONE.name, plants.FIELD.name):
        for name in light.LIGHTS:
            assert taken[plants.CURVED, stand, name] > taken[plants.ERECT, stand, name]


def test_without_the_data_the_script_says_where_it_is_from(tmp_path: Path) -> None:
    done = run_script(["--data", str(tmp_path / "none"), "-o", str(tmp_path / "out")], HERE)
    assert done.returncode == 1
    assert "openalea-incubator/adel" in done.stderr and "--data" in done.stderr and "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()


def test_without_the_module_the_script_says_how_to_get_it(tmp_path: Path) -> None:
    done = run_script([], tmp_path)
    assert done.returncode == 1
    assert "./dev python" in done.stderr and "Traceback" not in done.stderr
