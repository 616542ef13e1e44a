# SPDX-License-Identifier: Apache-2.0
"""Scans of plants, and tables of cylinders."""

from __future__ import annotations

from pathlib import Path

import meristem
import numpy as np
import pytest
from plants import grown_small_tree, small_tree

COARSE = {"kind": "terrestrial", "step": 0.5}


def test_points_lie_where_their_stations_measured_them() -> None:
    plant = grown_small_tree()
    stations = [[0, 1, 6], [5, 1.5, -3]]
    scan = plant.scan(instrument={**COARSE, "noise": 0}, stations=stations, ground=True)
    np.testing.assert_allclose(scan["stations"], stations, rtol=1e-6)
    assert scan["position"].shape == (len(scan["range"]), 3) and len(scan["range"]) > 100
    distance = np.linalg.norm(scan["position"] - scan["stations"][scan["station"]], axis=1)
    np.testing.assert_allclose(distance, scan["range"], rtol=1e-5)
    assert set(scan["kind"]) == {"ground", "wood", "organ"}
    assert (scan["return"] <= scan["returns"]).all()
    on_ground = scan["kind"] == "ground"
    assert (scan["shoot"][on_ground] == -1).all() and (scan["label"][on_ground] == "").all()
    assert (scan["tree"][~on_ground] == 0).all()


def test_labels_are_those_of_the_tables() -> None:
    plant = grown_small_tree()
    table = plant.skeleton_table()
    order_of = dict(zip(table["axis"], table["order"]))
    scan = plant.scan(instrument={**COARSE, "noise": 0, "rays": 1})
    wood = scan["kind"] == "wood"
    assert {order_of[shoot] for shoot in scan["shoot"][wood]} == set(scan["order"][wood])
    skeleton = plant.stems[0].skeleton
    assert all(skeleton.labels[shoot] == label for shoot, label in set(zip(scan["shoot"], scan["label"])))
    leaves = scan["kind"] == "organ"
    organs = plant.organs
    near = np.linalg.norm(scan["position"][leaves] - organs.position[scan["instance"][leaves]], axis=1)
    assert near.max() < 0.3, "points lie on the leaves that they name"


def test_obstacles_are_seen_and_hide_the_plant() -> None:
    wall = {"name": "wall", "box": [[-9, 0, 2], [9, 9, 2.2]]}
    plant = meristem.Document({**small_tree(), "scene": {"obstacles": [wall]}}).grow()
    stations = [[0, 1, 8]]
    assert set(plant.scan(instrument=COARSE, stations=stations)["kind"]) == {"obstacle"}
    assert set(plant.scan(instrument=COARSE, stations=stations, obstacles=False)["kind"]) == {"wood", "organ"}
    assert np.abs(plant.scan(instrument=COARSE)["stations"][:, [0, 2]]).max() < 5, "around the plant, not the wall"


def test_scans_are_repeatable_and_have_a_seed() -> None:
    plant = grown_small_tree()
    one, same = (plant.scan(instrument=COARSE, around=1, threads=threads) for threads in (1, 3))
    other = plant.scan(instrument=COARSE, around=1, seed=99)
    np.testing.assert_array_equal(one["range"], same["range"])
    assert not np.array_equal(one["range"], other["range"])


def test_files_have_the_points(tmp_path: Path) -> None:
    plant = grown_small_tree()
    count = plant.save_scan(tmp_path / "a.csv", instrument=COARSE, around=1)
    lines = (tmp_path / "a.csv").read_text().splitlines()
    assert len(lines) == count + 1 == len(plant.scan(instrument=COARSE, around=1)["range"]) + 1
    with pytest.raises(meristem.InputError, match=".las"):
        plant.save_scan(tmp_path / "a.laz")


def test_faults_name_their_key() -> None:
    plant = grown_small_tree()
    with pytest.raises(meristem.InputError, match="instrument: 'lidar' is not a value"):
        plant.scan(instrument="lidar")
    with pytest.raises(meristem.InputError, match="stations"):
        plant.scan(instrument="drone", stations=[[0, 0, 0]])
    with pytest.raises(meristem.InputError, match="instrument.noise"):
        plant.scan(instrument={"noise": -1})


@pytest.mark.parametrize("ending", [".qsm.csv", ".trees.txt", ".csv"])
def test_tables_of_cylinders_come_back(tmp_path: Path, ending: str) -> None:
    plant = grown_small_tree()
    plant.save(tmp_path / f"a{ending}")
    skeleton = plant.stems[0].skeleton
    again = meristem.read_skeleton(tmp_path / f"a{ending}", at_origin=False)
    assert len(again) == len(skeleton)
    if ending != ".qsm.csv":
        np.testing.assert_array_equal(again.parent, skeleton.parent)
        np.testing.assert_allclose(again.position, skeleton.position, atol=1e-6)
    np.testing.assert_allclose(again.measure()["length"], skeleton.measure()["length"], rtol=1e-5)
    with pytest.raises(ValueError, match="up is"):
        meristem.read_skeleton(tmp_path / f"a{ending}", up="x")
