# SPDX-License-Identifier: Apache-2.0
"""The effects of operations on trees, in Python."""

from __future__ import annotations

from typing import Any

import meristem
import numpy as np
import pytest


def done_document(**parameters: Any) -> dict[str, Any]:
    cut = {"do": "cut", "at": 10, "shoots": "rank == 1 && length > 0.2", "above": 2}
    tree = {"type": "organize", "iterations": 10, "length": 0.1, "operations": [cut], **parameters}
    return {"meristem": 1, "components": {"tree": tree}}


def grow(**parameters: Any) -> meristem.Plant:
    return meristem.Document(done_document(**parameters), seed=1).grow()


def test_records_tell_where_what_was_cut() -> None:
    plant = grow()
    records = plant.operations
    count = len(records["shoot"])
    assert count > 0
    assert set(records["act"]) == {"cut"} and set(records["operation"]) == {"components.tree.operations[0]"}
    assert records["position"].shape == (count, 3) and records["bud"].shape == (count, 3)
    assert np.all(records["metamers"] >= 1) and np.all(records["length"] > 0) and np.all(records["wood"] > 0)
    assert np.allclose(np.linalg.norm(records["bud"], axis=1), 1, atol=1e-5)
    # Each record is at the end of a remaining metamer, and agrees with the columns of the skeleton.
    skeleton = plant.stems[0].skeleton
    labels = np.array(skeleton.labels)[skeleton.axis]
    for k in range(count):
        [node] = np.flatnonzero((labels == records["shoot"][k]) & (skeleton["metamer"] == records["metamer"][k]))
        assert np.allclose(skeleton.position[node], records["position"][k], atol=1e-5)
        assert skeleton["cut_at"][node] == 10
        bark = records["position"][k] + skeleton.radius[node] * records["bud"][k]
        assert np.allclose(records["bud_position"][k], bark, atol=1e-5)
        assert 0 < records["diameter"][k] <= 2 * skeleton.radius[node] + 1e-6
        assert skeleton["cut_metamers"][node] == records["metamers"][k]


def test_a_plan_is_what_would_be_done() -> None:
    planned, done, wild = grow(plan=True), grow(), grow(operations=[])
    for name, column in planned.operations.items():
        assert np.array_equal(column, done.operations[name]), name
    assert np.array_equal(planned.stems[0].skeleton.position, wild.stems[0].skeleton.position)
    assert len(planned.stems[0].skeleton) == len(done.stems[0].skeleton) + done.operations["metamers"].sum()


def test_documents_plan_with_rules() -> None:
    tree = {"type": "organize", "iterations": 10, "length": 0.1}
    document = meristem.Document({"meristem": 1, "components": {"tree": tree}}, seed=1)
    rule = {"do": "cut", "shoots": "rank == 1 && length > 0.2", "above": 2}
    before, after, done = document.plan([rule]), document.plan([rule], done=True), grow()
    assert np.array_equal(before.operations["shoot"], done.operations["shoot"])
    assert np.array_equal(before.stems[0].skeleton.position, document.grow().stems[0].skeleton.position)
    for name, column in done.skeleton_table().items():
        assert np.array_equal(after.skeleton_table()[name], column), name
    plan_cut = before.stems[0].skeleton["plan_cut"]
    assert set(plan_cut) == {0, 1} and np.sum(plan_cut == 1) == before.operations["metamers"].sum()
    # Without rules, the document's own operations are planned, with the values that were set.
    own = meristem.Document(done_document(), seed=1)
    assert np.array_equal(own.plan().operations["position"], done.operations["position"])
    assert len(own.set({"tree.operations": []}).plan().operations["shoot"]) == 0


def test_wrong_rules_are_faults() -> None:
    document = meristem.Document(done_document(), seed=1)
    with pytest.raises(meristem.InputError, match=r"operations\[1\].do"):
        document.plan([{"do": "prune", "shoots": "rank == 1"}])
    with pytest.raises(meristem.InputError, match="rules cannot be"):
        document.plan({"do": "cut"})  # type: ignore[arg-type]
    with pytest.raises(meristem.InputError, match="no trees"):
        meristem.Document({"meristem": 1, "components": {"box": {"type": "simple"}}}).plan()


def test_trees_that_nobody_prunes_have_no_records() -> None:
    records = grow(operations=[]).operations
    assert len(records["shoot"]) == 0 and records["position"].shape == (0, 3)
