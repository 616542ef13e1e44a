# SPDX-License-Identifier: Apache-2.0
"""The study of grass leaves, with few leaves and little light, of synthetic leaves and of measured ones."""

from __future__ import annotations

import csv
import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import meristem
import numpy as np
import pytest
from data_sets import linked
from meristem import grass

STUDIES = Path(__file__).resolve().parents[2] / "studies"
sys.path.insert(0, str(STUDIES))

from grass_study import ages, fits, forces, levels, light, measured, plants  # noqa: E402

FIGURES = ("fits", "errors", "ages", "levels", "triangles", "forces", "light", "plants")
HERE = Path(meristem.__file__).parents[1]
#: The synthetic leaves of the project under the names of the measured ones
SYNTHETIC = {
    measured.WHEAT_MIDRIBS: "grass/midribs.csv",
    measured.WHEAT_WIDTHS: "grass/widths.csv",
    measured.WHEAT_AGES: "grass/midribs_by_age.csv",
    measured.MAIZE: "grass/blades.json",
}


class Study(NamedTuple):
    folder: Path  #: has the files that the study has written
    leaves: int
    failures: list[tuple[str, str]]  #: the expectations that do not hold: how they begin, and a part of what was found
    ties: int  #: number of steps to the finest levels that may come no nearer


# Three measured midribs with few points turn sharply: a curve through them is longer than their chords.
TO_AND_FRO = ("wheat: length of midribs that turn to and fro", "23 of 26 within")
STUDIES_OF = ["synthetic"] if measured.missing_files(measured.FOLDER) else ["synthetic", "measured"]


def run_script(arguments: list[str], path: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-B", str(STUDIES / "grass_leaves.py"), *arguments]
    environment = {**os.environ, "PYTHONPATH": str(path)}
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=300)


@pytest.fixture(scope="module", params=STUDIES_OF)
def quick(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Study:
    """Runs a quick study."""
    folder = tmp_path_factory.mktemp("study")
    is_own = request.param == "synthetic"
    data = linked(tmp_path_factory.mktemp("data"), SYNTHETIC) if is_own else measured.FOLDER
    done = run_script(["--quick", "--data", str(data), "-o", str(folder)], HERE)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    # Smooth synthetic leaves need no more triangles than the second finest levels have.
    return Study(folder, 84, [], 2) if is_own else Study(folder, 463, [TO_AND_FRO], 0)


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


def test_a_quick_study_writes_its_files(quick: Study) -> None:
    assert len(read_rows(quick.folder / "fits.csv")) == quick.leaves
    assert len(read_rows(quick.folder / "levels.csv")) == len(levels.PIECES)
    assert len(read_rows(quick.folder / "light.csv")) == len(plants.FORMS) * 2 * len(light.LIGHTS)
    for name in FIGURES:
        assert (quick.folder / f"{name}.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n")


def test_all_expectations_hold_in_a_quick_study_but_for_known_ones(quick: Study) -> None:
    rows = read_rows(quick.folder / "expectations.csv")
    assert len(rows) > 12
    failed = [row for row in rows if row["holds"] != "True"]
    assert len(failed) == len(quick.failures), failed
    for row, (what, found) in zip(failed, quick.failures):
        assert row["what"].startswith(what) and found in row["found"]


def test_more_triangles_come_nearer(quick: Study) -> None:
    steps = np.diff([float(row["distance"]) for row in read_rows(quick.folder / "levels.csv")])
    assert np.all(steps <= 0) and np.all(steps[: len(steps) - quick.ties] < 0)


def test_curved_leaves_take_more_light_than_straight_erect_ones(quick: Study) -> None:
    taken = {(row["form"], row["stand"], row["light"]): float(row["taken"]) for row in read_rows(quick.folder / "light.csv")}
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
