# SPDX-License-Identifier: Apache-2.0
"""The stages of a grass leaf, compared with closed forms, and on synthetic and measured leaves."""

from __future__ import annotations

import base64
import json
import pickle
from pathlib import Path
from typing import Any

import meristem
import numpy as np
import pytest
from data_sets import data_files
from meristem import grass

PIECES = 90


def arc_leaf(pieces: int = PIECES) -> grass.GrassLeaf:
    """A quarter of a circle, from the stem's direction to horizontal, with a width that falls linearly to zero."""
    angles = np.radians(90) * (np.arange(pieces) + 0.5) / pieces
    s = np.linspace(0, 1, pieces + 1)
    x = np.append(0, np.cumsum(np.sin(angles)) / pieces)
    y = np.append(0, np.cumsum(np.cos(angles)) / pieces)
    return grass.GrassLeaf(0.6, 0.05, s, x, y, 1 - s)


def straight_leaf(pieces: int = 10) -> grass.GrassLeaf:
    s = np.linspace(0, 1, pieces + 1)
    return grass.GrassLeaf(0.6, 0.05, s, 0 * s, s, 1 - s)


def write(folder: Path, text: str) -> Path:
    path = folder / "leaves.csv"
    path.write_text(text, encoding="utf-8")
    return path


# --- the leaf ---------------------------------------------------------------------------------------------------------


def test_a_leaf_knows_its_area_and_directions() -> None:
    leaf = arc_leaf()
    assert leaf.area == pytest.approx(0.6 * 0.05 / 2)
    assert leaf.angles == pytest.approx(np.arange(PIECES) + 0.5)
    assert leaf.inclination == pytest.approx(0.5)
    assert grass.widths_by_area(leaf) == pytest.approx(2 * leaf.r)
    assert len(leaf) == PIECES + 1


def test_its_arrays_are_read_only_and_outlive_it() -> None:
    leaf = arc_leaf()
    x = leaf.x
    with pytest.raises(ValueError):
        x[0] = 1
    del leaf
    assert x[-1] == pytest.approx(2 / np.pi, abs=1e-4)


def test_it_survives_pickling() -> None:
    leaf = arc_leaf()
    assert pickle.loads(pickle.dumps(leaf)) == leaf
    assert leaf != straight_leaf() and leaf != 1
    unseen = grass.aged(leaf, grass.MidribFamily(leaf), 0)
    assert pickle.loads(pickle.dumps(unseen)).length == 0


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"s": [0, 0.5]}, "go from 0 to 1"),
        ({"s": [0, 1, 1]}, "shape"),
        ({"x": [0, 1, 2]}, r"x must have shape \(2,\), not \(3,\)"),
        ({"y": [0, np.nan]}, r"y\[1\] is nan"),
        ({"length": 0.0}, "length above 0"),
        ({"r": [-1, 0]}, "at least 0"),
    ],
)
def test_wrong_numbers_are_refused_by_name(change: dict[str, Any], message: str) -> None:
    arguments = {"length": 1.0, "width": 0.1, "s": [0, 1], "x": [0, 0], "y": [0, 1], "r": [1, 0], **change}
    with pytest.raises(ValueError, match=message):
        grass.GrassLeaf(**arguments)


def test_a_resampled_leaf_keeps_length_and_shape() -> None:
    even = grass.resampled(arc_leaf(), 30)
    assert len(even) == 31 and even.length == 0.6
    assert np.hypot(np.diff(even.x), np.diff(even.y)) == pytest.approx(1 / 30)
    assert [even.x[-1], even.y[-1]] == pytest.approx([2 / np.pi] * 2, abs=1e-3)


# --- measured leaves --------------------------------------------------------------------------------------------------


def test_midribs_are_read_with_ranks_and_lines(tmp_path: Path) -> None:
    text = "rank,lindex,x,y\n1,0,0,0\n1,0,1,2\n1,0,2,3\n2,0,0,0\n2,0,0,1\n2,0,1,1\n2,0,2,1\n"
    first, second = grass.read_midribs(write(tmp_path, text))
    assert (first.rank, first.lindex, first.age, second.rank) == (1, 0, None, 2)
    assert first.points.tolist() == [[0, 0], [1, 2], [2, 3]]
    assert second.lines.tolist() == [5, 6, 7, 8]
    assert len(second) == 4


def test_faults_of_a_file_have_its_name_and_line(tmp_path: Path) -> None:
    path = write(tmp_path, "x,y\n0,0\n1,high\n1,2\n")
    with pytest.raises(meristem.InputError) as caught:
        grass.read_midribs(path)
    [fault] = caught.value.diagnostics
    assert (fault.file, fault.line) == (str(path), 3)
    with pytest.raises(meristem.InputError, match="no such file"):
        grass.read_widths(tmp_path / "none.csv")


def test_points_that_are_repeated_are_left_out_with_a_warning(tmp_path: Path) -> None:
    with pytest.warns(UserWarning, match="leaves.csv:4: rank 2: the point of the midrib repeats"):
        [midrib] = grass.read_midribs(write(tmp_path, "rank,x,y\n2,0,0\n2,1,1\n2,1,1\n2,2,1\n"))
    assert midrib.points.tolist() == [[0, 0], [1, 1], [2, 1]]


def test_widths_from_the_tip_are_turned_with_a_warning(tmp_path: Path) -> None:
    for text in ("s,r\n1,0\n0.5,1\n0,0.8\n", "s,r\n0,0\n0.5,1\n1,0.8\n"):  # falling, and narrow first
        with pytest.warns(UserWarning, match="leaves.csv:2.*from the tip to the base"):
            [widths] = grass.read_widths(write(tmp_path, text))
        assert widths.points.tolist() == [[0, 0.8], [0.5, 1], [1, 0]]


def test_a_straight_leaf_is_fitted_as_it_is() -> None:
    s = np.linspace(0, 1, 9)
    fitted = grass.fit_leaf(3 * s, 4 * s, 6 * s, 0.5 * (1 - s), width_smoothing=0, pieces=8)
    assert fitted.midrib_length == pytest.approx(5) and fitted.polyline_length == pytest.approx(5)
    assert fitted.distance == pytest.approx(0, abs=1e-6)
    assert fitted.leaf.length == 6  # the blade's, if the positions of the widths are no shares
    assert fitted.leaf.width == pytest.approx(0.5)
    assert fitted.leaf.area == pytest.approx(6 * 0.5 / 2, rel=1e-6)
    assert fitted.leaf.inclination == pytest.approx(np.degrees(np.arctan2(3, 4)))
    assert not fitted.was_turned


def test_raised_smoothing_goes_farther_from_the_points() -> None:
    x = np.linspace(0, 1, 20)
    y = x + 0.02 * (-1.0) ** np.arange(20)
    widths = ([0, 0.5, 1], [1, 1, 0])
    distances = [grass.fit_leaf(x, y, *widths, smoothing=k, pieces=400).distance for k in (0, 0.003, 0.01)]
    assert distances[0] < 1e-3 < distances[1] < distances[2]


def test_points_that_are_no_leaf_name_their_row() -> None:
    with pytest.raises(meristem.InputError, match="row 2.*row before"):
        grass.fit_leaf([0, 1, 1, 2], [0, 1, 1, 2], [0, 0.5, 1], [1, 1, 0])
    with pytest.raises(meristem.InputError, match="row 1.*negative"):
        grass.fit_leaf([0, 1, 2], [0, 1, 1], [0, 0.5, 1], [1, -1, 0])
    with pytest.raises(ValueError, match=r"y must have shape \(3,\)"):
        grass.fit_leaf([0, 1, 2], [0, 1], [0, 0.5, 1], [1, 1, 0])
    with pytest.raises(TypeError, match="x must hold real numbers"):
        grass.fit_leaf(["a"], [0], [0, 0.5, 1], [1, 1, 0])
    with pytest.raises(ValueError, match="smoothing"):
        grass.fit_leaf([0, 1, 2], [0, 1, 1], [0, 0.5, 1], [1, 1, 0], smoothing=-1)


# --- age --------------------------------------------------------------------------------------------------------------


def test_a_young_leaf_shows_its_tip_and_is_straighter() -> None:
    leaf = arc_leaf()
    family = grass.MidribFamily(leaf)
    assert (family.first_age, family.last_age, family.piece_count) == (0, 1, PIECES)
    assert family.angles(0.5) == pytest.approx(leaf.angles / 2)
    young = grass.aged(leaf, family, 0.5)
    assert young.length == pytest.approx(0.3)
    assert young.r == pytest.approx(0.5 * leaf.r)  # the outer half of widths that fall linearly
    assert young.angles == pytest.approx(leaf.angles / 4, abs=0.3)
    assert grass.aged(leaf, family, 1).area == pytest.approx(leaf.area)


def test_a_family_of_several_ages_goes_through_each() -> None:
    family = grass.MidribFamily([(2, straight_leaf(30)), (4, arc_leaf(30)), (5, straight_leaf(30))])
    assert family.angles(3) == pytest.approx(family.angles(4) / 2)
    assert family.angles(4) == pytest.approx(arc_leaf(30).angles)
    with pytest.raises(ValueError, match="rise"):
        grass.MidribFamily([(2, arc_leaf()), (2, arc_leaf())])


def test_a_life_without_events_is_that_of_the_plain_leaf() -> None:
    leaf = arc_leaf()
    family = grass.MidribFamily(leaf)
    plain, own = grass.aged(leaf, family, 0.7), grass.lived(leaf, family, 0.7, 0.01)
    assert own.length == pytest.approx(plain.length)
    assert own.x == pytest.approx(plain.x, abs=1e-9) and own.r == pytest.approx(plain.r, abs=1e-9)


def test_rates_may_be_functions_of_a_leafs_life() -> None:
    leaf = arc_leaf()
    family = grass.MidribFamily(leaf)
    seen: list[tuple[float, float]] = []

    def late(time: float, visible: float) -> float:
        seen.append((time, visible))
        return 2.0 if time >= 0.5 else 1.0

    grown = grass.lived(leaf, family, 1, 0.125, length=late)
    assert grown.length == pytest.approx(0.6 * 1.5)
    assert seen[:2] == [(0, 0), (0.125, 0.125)] and len(seen) == 8
    assert grass.lived(leaf, family, 1, 0.1, bend=0).x == pytest.approx(0)
    assert grass.lived(leaf, family, 1, 0.1, width=1.2).width == pytest.approx(0.06)


def test_what_a_rate_raises_comes_out_and_wrong_rates_are_refused() -> None:
    leaf = arc_leaf()
    family = grass.MidribFamily(leaf)
    with pytest.raises(ZeroDivisionError):
        grass.lived(leaf, family, 1, 0.1, age=lambda time, visible: 1 / 0)
    with pytest.raises(TypeError, match="bend must be a number"):
        grass.lived(leaf, family, 1, 0.1, bend="much")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="age is nan"):
        grass.lived(leaf, family, 1, 0.1, age=lambda time, visible: float("nan"))
    with pytest.raises(ValueError, match="must be above 0"):
        grass.lived(leaf, family, 1, 0)


# --- turns and loads --------------------------------------------------------------------------------------------------


def test_a_kink_turns_all_beyond_by_degrees() -> None:
    bent = grass.turned(straight_leaf(), [(0.5, 0.5, 90)])
    assert [bent.x[-1], bent.y[-1]] == pytest.approx([0.5, 0.5])
    both = grass.turned(straight_leaf(), [(0.2, 0.2, 30), (0.6, 0.8, 60)])
    assert both.angles[[0, 4, 9]] == pytest.approx([0, 30, 90])
    with pytest.raises(ValueError, match="between two positions"):
        grass.turned(straight_leaf(), [(0.8, 0.2, 10)])


def test_an_inclined_leaf_keeps_its_form() -> None:
    leaf = grass.inclined(arc_leaf(), 40)
    assert leaf.inclination == pytest.approx(40)
    assert np.diff(leaf.angles) == pytest.approx(1)


def test_a_leaf_without_loads_stays_and_in_wind_it_yields() -> None:
    leaf = grass.resampled(arc_leaf(), 30)
    assert grass.loaded(leaf).angles == pytest.approx(leaf.angles, abs=1e-6)
    tips = [grass.loaded(leaf, wind=(wind, 0)).y[-1] for wind in (0, 0.1, 0.3)]
    assert tips[0] > tips[1] > tips[2]
    stiff = grass.loaded(leaf, wind=(0.3, 0), stiffness=10).y[-1]
    assert tips[0] > stiff > tips[2]


def test_the_load_for_a_turn_gives_that_turn() -> None:
    leaf = grass.resampled(grass.inclined(straight_leaf(), 20), 40)
    factor = grass.load_for_turn(leaf, 1, 25, wind=(1, 0))
    turn = grass.loaded(leaf, wind=(factor, 0)).angles[-1] - leaf.angles[-1]
    assert turn == pytest.approx(25, rel=0.01)
    with pytest.raises(ValueError, match="no such load"):
        grass.load_for_turn(leaf, 1, 25)


# --- reduction --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("pieces", [1, 2, 7, 40])
def test_a_reduced_leaf_keeps_its_area_and_some_of_its_points(pieces: int) -> None:
    leaf = arc_leaf()
    plain = grass.reduced(leaf, pieces=pieces)
    assert len(plain) == pieces + 1
    assert plain.area == pytest.approx(leaf.area, rel=1e-12)
    assert set(plain.s) <= set(leaf.s)


def test_coarser_levels_keep_points_of_finer_ones() -> None:
    order = grass.reduction_order(arc_leaf())
    assert len(order) == PIECES - 1 and sorted(order.points) == list(range(1, PIECES))
    assert np.all(np.diff(order.errors) >= 0)
    levels = [set(grass.points_kept(order, pieces)) for pieces in (2, 4, 8, 16)]
    assert all(coarse < fine for coarse, fine in zip(levels, levels[1:]))
    assert grass.reduced(arc_leaf(), points=grass.points_kept(order, 8)) == grass.reduced(arc_leaf(), pieces=8)


def test_an_error_bounds_what_goes() -> None:
    order = grass.reduction_order(arc_leaf())
    kept = grass.points_within(order, 0.01)
    assert order.errors[PIECES - len(kept)] <= 0.01 < order.errors[PIECES - len(kept) + 1]
    assert len(grass.reduced(arc_leaf(), error=0.01)) == len(kept)


def test_a_reduction_is_told_in_one_way() -> None:
    for arguments in ({}, {"pieces": 3, "error": 0.1}):
        with pytest.raises(TypeError, match="one of pieces, error and points"):
            grass.reduced(arc_leaf(), **arguments)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="at least 1 piece"):
        grass.reduced(arc_leaf(), pieces=0)
    with pytest.raises(ValueError, match=f"end with {PIECES}"):
        grass.reduced(arc_leaf(), points=[0, 5])
    with pytest.raises(ValueError, match=r"points\[2\] does not rise"):
        grass.reduced(arc_leaf(), points=[0, 5, 5, PIECES])


# --- the blade --------------------------------------------------------------------------------------------------------


def test_a_plain_blade_has_the_leafs_area_and_a_point_at_its_tip() -> None:
    leaf = straight_leaf(10)
    mesh = grass.make_grass_blade(leaf)
    assert len(mesh.triangles) == 4 * 10 - 2
    assert mesh.area == pytest.approx(leaf.area, rel=1e-6)
    assert mesh.positions[-1] == pytest.approx([0, 0.6, 0], abs=1e-6)


def test_twist_and_fold_turn_sections_by_degrees() -> None:
    s = np.linspace(0, 1, 11)
    band = grass.GrassLeaf(0.6, 0.05, s, 0 * s, s, 0 * s + 1)
    twisted = grass.make_grass_blade(band, twist=90).positions
    ends = [twisted[2] - twisted[0], twisted[-1] - twisted[-3]]
    assert ends[0] @ ends[1] == pytest.approx(0, abs=1e-6)
    held = grass.make_grass_blade(band, twist=90, twist_along=[[0, 0], [0.5, 0], [1, 1]]).positions
    assert held[:15] == pytest.approx(grass.make_grass_blade(band).positions[:15])
    folded = grass.make_grass_blade(band, fold=60).positions
    assert np.linalg.norm(folded[2] - folded[0]) == pytest.approx(0.05 * np.cos(np.radians(60)), rel=1e-5)


def test_waves_and_displacements_move_what_they_should() -> None:
    leaf = straight_leaf()
    plain = grass.make_grass_blade(leaf).positions
    wavy = grass.make_grass_blade(leaf, waves={"number": 3, "depth": 0.3, "right": 90}).positions
    moved = np.abs(wavy - plain).max(axis=1)
    assert moved[1::3][:10] == pytest.approx(0) and moved.max() > 1e-3
    lifted = grass.make_grass_blade(leaf, displace=lambda s, u: (0, 0, s)).positions
    assert (lifted - plain)[3:6] == pytest.approx(np.tile([0.005, 0, 0], (3, 1)), abs=1e-6)
    with pytest.raises(meristem.InputError, match="did you mean 'depth'"):
        grass.make_grass_blade(leaf, waves={"dept": 0.3})
    with pytest.raises(ZeroDivisionError):
        grass.make_grass_blade(leaf, displace=lambda s, u: (1 / 0, 0, 0))
    with pytest.raises(ValueError, match="even number"):
        grass.make_grass_blade(leaf, across=3)


def test_sheath_and_ligule_are_strips_of_radius_one() -> None:
    sheath = grass.make_sheath(40).positions
    assert sheath[:, 1].min() == -1 and sheath[:, 1].max() == 0
    assert np.hypot(sheath[:, 0], sheath[:, 2]).max() == pytest.approx(1)
    assert grass.make_ligule().positions[:, 1].max() == pytest.approx(1)


# --- the measured leaves ----------------------------------------------------------------------------------------------


def blades_of(path: Path) -> list[tuple[np.ndarray[Any, np.dtype[np.float64]], ...]]:
    """Returns x, y, s and r of each leaf."""

    def array(stored: dict[str, Any]) -> np.ndarray[Any, np.dtype[np.float64]]:
        return np.frombuffer(base64.b64decode(stored["__ndarray__"]), dtype="<f8").reshape(stored["shape"])

    by_rank = json.loads(path.read_text(encoding="utf-8"))
    return [tuple(map(array, leaf)) for leaves in by_rank.values() for leaf in leaves]


@pytest.mark.parametrize("path", data_files("grass/blades.json", "grass/simpleleavesdb.json"))
def test_all_blades_are_fitted_within_the_bounds(path: Path) -> None:
    leaves = blades_of(path)
    assert len(leaves) == {"blades.json": 12, "simpleleavesdb.json": 13}[path.name]
    for x, y, s, r in leaves:
        fitted = grass.fit_leaf(x, y, s, r)
        polyline = np.hypot(np.diff(x), np.diff(y)).sum()
        assert fitted.polyline_length == pytest.approx(polyline)
        assert fitted.distance < 0.007 * polyline
        assert fitted.midrib_length == pytest.approx(polyline, rel=0.01)
        assert fitted.leaf.length == s[-1]
        assert fitted.leaf.area == pytest.approx(np.trapz(r, s), rel=0.02)
        assert fitted.leaf.r.min() >= 0 and fitted.leaf.r.max() == 1
        assert len(grass.make_grass_blade(grass.reduced(fitted.leaf, pieces=8)).triangles) in (30, 32)


WIDTHS = {"midribs.csv": "widths.csv", "So99.csv": "SRSo.csv"}


@pytest.mark.parametrize("path", data_files("grass/midribs.csv", "grass/So99.csv"))
def test_all_leaves_go_through_all_stages(path: Path) -> None:
    midribs = grass.read_midribs(path)
    widths = {curve.rank: curve.points.T for curve in grass.read_widths(path.parent / WIDTHS[path.name])}
    assert len(midribs) == {"midribs.csv": 72, "So99.csv": 450}[path.name]
    for midrib in midribs:
        fitted = grass.fit_leaf(*midrib.points.T, *widths[midrib.rank])
        if len(midrib) >= 12:
            assert fitted.distance < 0.015 * fitted.polyline_length
        young = grass.aged(fitted.leaf, grass.MidribFamily(fitted.leaf), 0.8)
        mesh = grass.make_grass_blade(grass.reduced(grass.loaded(young, wind=(0.1, 0)), pieces=12), twist=30)
        assert np.isfinite(mesh.positions).all()
