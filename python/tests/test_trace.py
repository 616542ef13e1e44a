# SPDX-License-Identifier: Apache-2.0
"""Growth step by step: traces, and plants at a step."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import meristem


def colonizing(**changes: Any) -> meristem.Document:
    tree = {
        "type": "colonize",
        "crown": {"ellipsoid": {"centre": [0, 1.2, 0], "radii": [0.6, 0.7, 0.6]}},
        "points": 90, "step": 0.06, "influence": 0.8, "kill": 0.16, "iterations": 18,
    }  # fmt: skip
    return meristem.Document({"meristem": 1, "seed": 4, "components": {"tree": {**tree, **changes}}})


def organizing(**changes: Any) -> meristem.Document:
    tree = {"type": "organize", "iterations": 9, "length": 0.1, "shedding": {"below": 0.3, "after": 2}}
    members = {name: value for name, value in {**tree, **changes}.items() if value is not None}
    return meristem.Document({"meristem": 1, "seed": 2, "components": {"tree": members}})


def same(a: meristem.Skeleton, b: meristem.Skeleton) -> bool:
    columns = all(np.array_equal(a[name], b[name]) for name in ("parent", "position", "radius", "axis", "order", "birth"))
    return columns and len(a) == len(b)


@pytest.mark.parametrize("make", [colonizing, organizing])
def test_a_step_equals_a_growth_with_no_more_iterations(make: Any) -> None:
    trace = make().grow(trace=True).trace
    assert trace is not None and trace.bytes > 0
    for step in (6, 2):
        assert same(trace.skeletons(step)[0], make(iterations=step).grow().stems[0].skeleton)
        assert same(make().grow(step=step).stems[0].skeleton, make(iterations=step).grow().stems[0].skeleton)


def test_points_are_columns_that_only_lose_free_points() -> None:
    trace = colonizing().grow(trace=True).trace
    assert trace is not None
    free = []
    for step in range(trace.steps + 1):
        points = trace.points(step)
        assert points["position"].shape == (90, 3)
        assert set(points["component"]) == {"tree"}
        used = points["state"] == "used"
        assert np.all((points["used_in"] > 0) == used) and points["used_in"].max() <= step
        free.append(np.count_nonzero(points["state"] == "free"))
    assert free[0] == 90 and free == sorted(free, reverse=True) and free[-1] < 85


def test_pulls_end_at_free_points() -> None:
    trace = colonizing().grow(trace=True).trace
    assert trace is not None
    points = trace.points(5)
    free = {tuple(position) for position in points["position"][points["state"] == "free"]}
    ends = trace.pulls(5)["end"]
    assert len(ends) > 0 and {tuple(end) for end in ends} <= free


def test_organizing_trees_tell_ways_and_losses() -> None:
    trace = organizing().grow(trace=True).trace
    assert trace is not None and trace.steps == 9 and trace.step == 9
    ways = trace.ways(5)
    assert np.allclose(np.linalg.norm(ways["end"] - ways["begin"], axis=1), 1, atol=1e-5)
    losses = [loss for step in range(10) for loss in trace.losses(step)]
    assert losses and all(loss["why"] == "components.tree.shedding" for loss in losses)
    assert all(loss["segments"].shape[1:] == (2, 3) for loss in losses)


def test_markers_are_taken() -> None:
    trace = organizing(light={"model": "markers"}, iterations=4, shedding=None).grow(trace=True).trace
    assert trace is not None
    assert np.count_nonzero(trace.markers(4)["state"] == "used") > 0


def test_nothing_is_recorded_unless_asked() -> None:
    assert colonizing().grow().trace is None
    with pytest.raises(ValueError, match="step must be 0 or more"):
        colonizing().grow(step=-1)
    trace = colonizing().grow(trace=True).trace
    assert trace is not None
    with pytest.raises(ValueError, match=f"step must be 0 to {trace.steps}"):
        trace.points(trace.steps + 1)


def test_points_are_a_table_of_a_growth_that_was_recorded(tmp_path: Path) -> None:
    colonizing().grow(trace=True).save(tmp_path / "tree.points.csv")
    assert len((tmp_path / "tree.points.csv").read_text().splitlines()) == 91
    with pytest.raises(meristem.InputError, match="trace=True"):
        colonizing().grow().save(tmp_path / "other.points.csv")
    assert not (tmp_path / "other.points.csv").exists()
