# SPDX-License-Identifier: Apache-2.0
"""Documents that place plants of other documents, in Python."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import meristem

TWIG: dict[str, Any] = {
    "meristem": 1,
    "variables": {"age": {"value": 2, "min": 1, "max": 9}},
    "components": {"stem": {"type": "tree", "length": "age"}, "leaf": {"type": "leaf"}},
    "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": 5}],
}
GARDEN: dict[str, Any] = {
    "meristem": 1,
    "components": {
        "trees": {"type": "places", "table": "trees.csv", "choose": "kind"},
        "oak": {"type": "document", "file": "twig.json", "set": {"age": "years"}, "seed": 1},
    },
}


@pytest.fixture
def garden(tmp_path: Path) -> Path:
    (tmp_path / "twig.json").write_text(json.dumps(TWIG))
    (tmp_path / "trees.csv").write_text("x,y,kind,years\n0,0,oak,2\n5,1,oak,4\n9,2,oak,2\n")
    (tmp_path / "garden.json").write_text(json.dumps(GARDEN))
    return tmp_path / "garden.json"


def test_stems_and_organs_are_those_of_all_places(garden: Path) -> None:
    plant = meristem.read(garden).grow()
    assert [stem.component for stem in plant.stems] == ["oak.stem"] * 3
    assert len(plant.organs) == 15
    assert plant.node_count == sum(len(stem.skeleton) for stem in plant.stems)


def test_meshes_have_a_frame_for_each_place(garden: Path) -> None:
    plant = meristem.read(garden).grow()
    leaves = [part for part in plant.meshes if part.component == "oak.leaf"]
    frames = np.concatenate([part.frames for part in leaves])
    assert frames.shape == (15, 4, 3)
    assert sum(len(part) for part in leaves) == 15
    highest = max((part.mesh.positions @ frame[:3] + frame[3])[:, 1].max() for part in plant.meshes for frame in part.frames)
    assert plant.bounds is not None
    assert plant.bounds[1][1] == pytest.approx(highest, abs=1e-4)


def test_measures_count_each_place(garden: Path) -> None:
    plant = meristem.read(garden).grow()
    measures = plant.measure(each=True)
    assert measures["leaf_count"] == 15
    assert [tree["row"] for tree in measures["each"]] == [0, 2, 1]
    light = plant.organ_light()
    for name in ("component", "instance", "tree", "position"):
        np.testing.assert_array_equal(light[name], getattr(plant.organs, name))
    areas = np.bincount(light["tree"], weights=light["area"])
    np.testing.assert_allclose(areas, [tree["leaf_area"] for tree in measures["each"]], rtol=1e-9)


def test_shipped_models_are_found_by_name(tmp_path: Path) -> None:
    path = tmp_path / "garden.json"
    fir = {"type": "document", "file": "low-poly-fir", "seed": 1}
    path.write_text(json.dumps({"meristem": 1, "components": {"fir": fir}}))
    alone = meristem.read("low-poly-fir", seed=1).grow()
    assert meristem.read(path).grow().triangle_count == alone.triangle_count


def test_a_table_that_names_no_component_is_a_fault(garden: Path) -> None:
    (garden.parent / "trees.csv").write_text("x,y,kind,years\n0,0,oak,2\n5,1,oka,4\n")
    with pytest.raises(meristem.InputError, match="did you mean 'oak'"):
        meristem.read(garden)


def test_steps_and_traces_are_those_of_the_placed_plants(tmp_path: Path) -> None:
    tree = {"type": "colonize", "crown": {"sphere": {"centre": [0, 1, 0], "radius": 0.5}}, "points": 60,
            "step": 0.06, "influence": 0.8, "kill": 0.16, "iterations": 18}  # fmt: skip
    (tmp_path / "tree.json").write_text(json.dumps({"meristem": 1, "components": {"stem": tree}}))
    row = {"type": "places", "line": {"points": [[0, 0], [4, 0]], "spacing": 4}}
    garden = {
        "meristem": 1,
        "components": {"row": row, "oak": {"type": "document", "file": "tree.json", "seed": 3}},
        "links": [["row", "oak"]],
    }
    (tmp_path / "row.json").write_text(json.dumps(garden))
    document = meristem.read(tmp_path / "row.json")
    alone = meristem.read(tmp_path / "tree.json", seed=3).grow(step=7)
    at_7 = document.grow(step=7, trace=True)
    assert [len(stem.skeleton.position) for stem in at_7.stems] == [len(alone.stems[0].skeleton.position)] * 2
    assert at_7.trace is not None and at_7.trace.steps == 18
    points = at_7.trace.points()
    assert set(points["component"]) == {"oak.stem"}
    assert len(points["position"]) == 120
    np.testing.assert_allclose(points["position"][60:] - points["position"][:60], [[4, 0, 0]] * 60, atol=1e-6)
    assert at_7.trace.skeletons() == []
