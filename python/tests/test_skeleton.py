# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import gc
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

import meristem
from data_sets import data_files
from plants import grown_small_tree


class Digitised(NamedTuple):
    nodes: int
    axes: int
    height: float  #: metres


#: Digitised trees in cm, with diameters in mm: a synthetic one of the project, and a published walnut
KNOWN = {"sapling.mtg": Digitised(875, 334, 4.66), "noylum2.mtg": Digitised(6428, 1875, 7.95)}
TREES = data_files("trees/sapling.mtg", "trees/noylum2.mtg")
on_digitised_trees = pytest.mark.parametrize("file", TREES, ids=[file.name for file in TREES])


def forked() -> meristem.Skeleton:
    """A stem of one metre that forks into two branches of half a metre, at right angles."""
    position = [[0, 0, 0], [0, 1, 0], [0.5, 1, 0], [0, 1.5, 0]]
    return meristem.Skeleton([-1, 0, 1, 1], position, radius=[0.03, 0.03, 0.01, 0.02])


def test_columns_come_back_as_they_were_given() -> None:
    skeleton = meristem.Skeleton(
        np.array([-1, 0], dtype=np.int16),
        np.array([[0, 0, 0], [0, 1, 0]], dtype=">f8"),
        birth=[0, 3],
        extra={"light": [0.5, 1]},
    )
    assert skeleton.parent.tolist() == [-1, 0]
    assert skeleton.position.tolist() == [[0, 0, 0], [0, 1, 0]]
    assert skeleton.birth.tolist() == [0, 3]
    assert skeleton["light"].tolist() == [0.5, 1]
    assert skeleton.keys() == ["parent", "position", "radius", "axis", "order", "birth", "light"]
    assert "light" in skeleton and "shade" not in skeleton
    assert len(skeleton) == 2


def test_the_thickest_child_continues_its_axis() -> None:
    skeleton = forked()
    assert skeleton.axis.tolist() == [0, 0, 1, 0]
    assert skeleton.order.tolist() == [0, 0, 1, 0]


def test_skeletons_of_arrays_measure_as_they_should() -> None:
    measures = forked().measure()
    assert measures["length"] == pytest.approx(2)
    assert measures["height"] == pytest.approx(1.5)
    assert measures["axes"] == 2 and measures["tips"] == 2 and measures["forks"] == 1
    assert measures["branching_angle_mean"] == pytest.approx(90)
    assert measures["lit_share"] is None
    assert forked().tip_distance().tolist() == pytest.approx([1.5, 0.5, 0, 0])


def test_a_grown_skeleton_rebuilt_from_its_columns_has_the_same_hash() -> None:
    grown = grown_small_tree().stems[0].skeleton
    built = meristem.Skeleton(
        grown.parent, grown.position, radius=grown.radius, axis=grown.axis, order=grown.order, birth=grown.birth
    )
    assert built.hash == grown.hash
    assert built.measure() == grown.measure()


def test_lit_share_is_measured_in_a_scene() -> None:
    plant = grown_small_tree()
    assert plant.stems[0].skeleton.measure(scene=plant.document.scene)["lit_share"] == plant.measure()["lit_share"]


def test_stands_split_into_their_trees() -> None:
    stand = meristem.Skeleton([-1, 0, -1, 2], [[0, 0, 0], [0, 1, 0], [5, 0, 0], [5, 2, 0]])
    first, second = stand.trees()
    assert first.position.tolist() == [[0, 0, 0], [0, 1, 0]]
    assert second.position.tolist() == [[5, 0, 0], [5, 2, 0]]
    assert second.parent.tolist() == [-1, 0]
    assert stand.measure()["trees"] == 2


def test_empty_skeletons_are_no_trees() -> None:
    empty = meristem.Skeleton([], [])
    assert len(empty) == 0 and empty.bounds is None and empty.trees() == []
    assert empty.measure()["trees"] == 0
    assert len(meristem.tubes(empty).triangles) == 0


def test_bounds_hold_all_nodes() -> None:
    np.testing.assert_allclose(forked().bounds, [[-0.03, -0.03, -0.03], [0.51, 1.52, 0.03]], atol=1e-6)


def test_trees_keep_their_columns_when_the_stand_is_gone() -> None:
    tree = grown_small_tree().stems[0].skeleton.trees()[0]
    radius = tree.radius
    expected = radius.copy()
    del tree
    gc.collect()
    np.testing.assert_array_equal(radius, expected)


@pytest.mark.parametrize(
    ("columns", "error", "message"),
    [
        ({"position": np.zeros((3, 2))}, ValueError, r"position must have shape \(n, 3\), not \(3, 2\)"),
        ({"position": np.zeros(3)}, ValueError, r"position must have shape \(n, 3\), not \(3,\)"),
        ({"position": [[0, 0, 0], [0, np.nan, 0], [0, 2, 0]]}, ValueError, r"position\[1, 1\] is nan"),
        ({"position": [[0, 0, 0], [0, 1e39, 0], [0, 2, 0]]}, ValueError, r"position\[1, 1\] is inf"),
        ({"position": [["a"] * 3] * 3}, TypeError, "position must hold real numbers, not <U1"),
        ({"position": np.zeros((3, 3), dtype=complex)}, TypeError, "position must hold real numbers, not complex128"),
        ({"parent": [-1, 0]}, ValueError, r"parent must have shape \(3,\), not \(2,\)"),
        ({"parent": [-1.0, 0.0, 1.0]}, TypeError, "parent must hold whole numbers, not float64"),
        ({"parent": [-1, 1, 0]}, ValueError, r"parent\[1\] is 1; a parent's index is smaller"),
        ({"parent": [-1, 0, 5]}, ValueError, r"parent\[2\] is 5; expected -1 to 2"),
        ({"parent": [-1, 0, -2]}, ValueError, r"parent\[2\] is -2; expected -1 to 2"),
        ({"parent": np.array([2**64 - 1, 0, 1], dtype=np.uint64)}, ValueError, r"parent\[0\] is 1844674407370955"),
        ({"radius": [1, -1, 1]}, ValueError, r"radius\[1\] is negative"),
        ({"radius": [1, 1]}, ValueError, r"radius must have shape \(3,\), not \(2,\)"),
        ({"axis": [0, 0, 0]}, ValueError, "axis and order are given together"),
        ({"axis": [0, 2, 1], "order": [0, 1, 1]}, ValueError, r"axis\[1\] is 2; axes are numbered from 0"),
        ({"axis": [0, 0, 0], "order": [0, 0, 70000]}, ValueError, r"order\[2\] is 70000; expected 0 to 65535"),
        ({"extra": {"radius": [1, 1, 1]}}, ValueError, "'radius' is not a further column"),
        ({"extra": {"light": [1, 2]}}, ValueError, r"light must have shape \(3,\), not \(2,\)"),
        ({"birth": [0, 1e300, 0]}, ValueError, "birth holds 1e\\+300, which is too large"),
    ],
)
def test_wrong_columns_are_refused(columns: dict[str, Any], error: type[Exception], message: str) -> None:
    good: dict[str, Any] = {"parent": [-1, 0, 1], "position": [[0, 0, 0], [0, 1, 0], [0, 2, 0]]}
    with pytest.raises(error, match=message):
        meristem.Skeleton(**{**good, **columns})


def test_unknown_columns_suggest_the_nearest() -> None:
    with pytest.raises(KeyError, match="no column 'radios'; did you mean 'radius'?"):
        forked()["radios"]


def test_tubes_enclose_the_wood() -> None:
    straight = meristem.Skeleton([-1, 0], [[0, 0, 0], [0, 2, 0]], radius=[0.1, 0.1])
    mesh = meristem.tubes(straight, sides=64, flare=0, cap="flat")
    assert mesh.volume == pytest.approx(np.pi * 0.1**2 * 2, rel=0.01)
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-5)
    with pytest.raises(meristem.InputError, match="cap: .*'square'.*pointed, round, flat"):
        meristem.tubes(straight, cap="square")  # type: ignore[arg-type]
    for wrong in ({"sides": 2}, {"sides": 65}, {"error": 2}, {"flare": 1e300}, {"uv_scale": float("inf")}):
        with pytest.raises(meristem.InputError):
            meristem.tubes(straight, **wrong)


def test_odd_skeletons_of_users_become_tubes() -> None:
    random = np.random.default_rng(1)
    for count in (1, 2, 30, 400):
        parent = [-1] + [int(random.integers(max(0, k - 5), k)) for k in range(1, count)]
        position = np.round(random.normal(size=(count, 3)), 1)  # some nodes have equal positions
        radius = np.where(random.random(count) < 0.2, 0, random.random(count) * 0.2)
        mesh = meristem.tubes(meristem.Skeleton(parent, position, radius=radius))
        assert np.isfinite(mesh.positions).all()


@on_digitised_trees
def test_digitised_trees_can_be_read(file: Path) -> None:
    tree = meristem.read_mtg(file, unit=0.01, diameter_unit=0.001)
    assert len(tree) == KNOWN[file.name].nodes
    assert tree.measure()["height"] == pytest.approx(KNOWN[file.name].height, abs=0.005)


@on_digitised_trees
def test_digitised_trees_come_back_from_files_of_ours(file: Path, tmp_path: Path) -> None:
    tree = meristem.read_mtg(file, unit=0.01, diameter_unit=0.001)
    tree.save_mtg(tmp_path / "tree.mtg")
    again = meristem.read_mtg(tmp_path / "tree.mtg")
    assert again.hash == tree.hash
    assert again.labels == tree.labels and len(again.labels) == KNOWN[file.name].axes
    again.save_mtg(tmp_path / "again.mtg", threads=1)
    assert (tmp_path / "again.mtg").read_bytes() == (tmp_path / "tree.mtg").read_bytes()
    assert tree["NFe"].dtype == np.float32


def test_grown_plants_come_back_from_mtg_files(tmp_path: Path) -> None:
    plant = grown_small_tree()
    plant.save(tmp_path / "tree.mtg")
    skeleton = plant.stems[0].skeleton
    assert meristem.read_mtg(tmp_path / "tree.mtg").hash == skeleton.hash
    skeleton.save_mtg(tmp_path / "skeleton.mtg")
    assert meristem.read_mtg(tmp_path / "skeleton.mtg").hash == skeleton.hash


def test_labels_name_the_metamers_that_bear_axes() -> None:
    columns: dict[str, Any] = {"axis": [0, 0, 1, 0], "order": [0, 0, 1, 0]}
    position = [[0, 0, 0], [0, 1, 0], [0.5, 1, 0], [0, 1.5, 0]]
    assert meristem.Skeleton([-1, 0, 1, 1], position, **columns).labels == ["main", "main.1"]
    numbered = meristem.Skeleton([-1, 0, 1, 1], position, **columns, extra={"metamer": [0, 7, 1, 8]})
    assert numbered.labels == ["main", "main.7"]


def test_columns_that_no_file_can_have_are_named(tmp_path: Path) -> None:
    skeleton = meristem.Skeleton([-1], [[0, 0, 0]], extra={"red light": [1]})
    with pytest.raises(meristem.InputError, match="a file cannot have the column 'red light'"):
        skeleton.save_mtg(tmp_path / "a.mtg")
    assert not list(tmp_path.iterdir())


def test_masked_numbers_are_refused() -> None:
    masked = np.ma.array([[0.0, 0, 0], [0, 999, 0]], mask=[[False] * 3, [False, True, False]])
    with pytest.raises(ValueError, match="position has masked numbers"):
        meristem.Skeleton([-1, 0], masked)
    whole = np.ma.array([[0.0, 0, 0], [0, 1, 0]])
    assert len(meristem.Skeleton([-1, 0], whole)) == 2


def test_rays_for_the_lit_share_are_bounded() -> None:
    for rays in (0, 2**40):
        with pytest.raises(ValueError, match=f"crown_rays is {rays}; expected 1 to 1000000000"):
            forked().measure(crown_rays=rays)


def test_sizes_and_ratios_are_floats_and_counts_whole() -> None:
    measures = meristem.Skeleton([-1, 0], [[0, 0, 0], [0, 2, 0]], radius=[0.5, 0.5]).measure(each=True)
    for values in (measures, measures["each"][0]):
        assert values["height"] == 2 and isinstance(values["height"], float)
        assert all(isinstance(length, float) for length in values["length_by_order"])
        assert values["slenderness"] == 2 and isinstance(values["slenderness"], float)
        assert values["nodes"] == 2 and isinstance(values["nodes"], int)
        assert values["order_histogram"] == [1] and isinstance(values["order_histogram"][0], int)


def test_mtg_files_that_cannot_be_read_say_where(tmp_path: Path) -> None:
    (tmp_path / "bad.mtg").write_text("CODE: FORM-A\n")
    with pytest.raises(meristem.InputError) as caught:
        meristem.read_mtg(tmp_path / "bad.mtg")
    assert caught.value.diagnostics[0].file.endswith("bad.mtg")
    with pytest.raises(ValueError, match="units must be above 0"):
        meristem.read_mtg("any.mtg", unit=-1)
