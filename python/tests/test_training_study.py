# SPDX-License-Identifier: Apache-2.0
"""The study of trained trees, with few trees."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

STUDIES = Path(__file__).resolve().parents[2] / "studies"
sys.path.insert(0, str(STUDIES))

import train_trees as study  # noqa: E402
from training_study import bud, cordon, espalier, pole, trees, vase  # noqa: E402

SEEDS = range(4)


def test_a_pole_holds_stems_nearer_to_it(tmp_path: Path) -> None:
    stems = pole.study_poles(SEEDS)
    assert len(stems) == len(trees.SETS) * len(pole.WEIGHTS) * len(SEEDS)
    for name in trees.SETS:
        free, light, heavy = (pole.mean_distance(stems, name, weight) for weight in pole.WEIGHTS)
        assert heavy < light < free
    study.write_rows(tmp_path / "poles.csv", stems)
    assert (tmp_path / "poles.csv").read_text().splitlines()[0] == "set,weight,seed,metamers,mean,largest"


def test_a_cut_leader_shares_its_metamers_out() -> None:
    vases = vase.study_vases(SEEDS)
    assert vases
    assert np.mean([v.share_cut for v in vases]) < np.mean([v.share for v in vases])
    assert all(0 < v.share_cut <= 1 and v.height_cut > 0 for v in vases)


def test_a_branch_cut_to_a_low_bud_goes_lower() -> None:
    branches = bud.study_buds(range(8))
    assert branches
    assert np.mean([b.stretch - b.stretch_cut for b in branches]) > 5
    for branch in branches:
        assert 1 <= branch.above and branch.shoot.startswith("main.")


def test_an_espalier_has_two_arms_a_layer() -> None:
    for arms in espalier.study_arms(SEEDS):
        assert (arms.left, arms.right) == (espalier.LAYERS, espalier.LAYERS)
        assert arms.inclination < 7 and arms.off_plane < 3


def test_upkeep_holds_an_espalier() -> None:
    def metamers(upkeep: str, iterations: int) -> int:
        return trees.count_metamers(espalier.grow_espalier(1, iterations, upkeep))

    assert abs(metamers("spurs and limit", 25) / metamers("spurs and limit", 17) - 1) < 0.05
    assert metamers("shoots cut to 2", 25) > 1.5 * metamers("shoots cut to 2", 15)


def test_light_across_a_cordon_branches_it() -> None:
    cordons = cordon.study_cordons(SEEDS)
    above, along = (cordon.mean_of(cordons, light, "metamers") for light in ("shade from above", "shade along the light"))
    assert along > above


def test_metamers_beyond_each_node_are_counted() -> None:
    skeleton = trees.grow_skeleton(trees.SLIM, 10, 1)
    beyond = trees.count_beyond(skeleton)
    assert beyond[0] == len(skeleton)
    children = trees.find_children(skeleton)
    for node, own in children.items():
        assert beyond[node] == 1 + sum(beyond[child] for child in own)
