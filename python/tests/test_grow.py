# SPDX-License-Identifier: Apache-2.0
"""Space colonization into points from Python."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import meristem


def cloud(count: int = 600, centre: tuple[float, float, float] = (0, 2, 0)) -> NDArray[np.float64]:
    """Returns points in a ball of radius 1 that 32-bit numbers represent exactly."""
    points = np.random.default_rng(11).uniform(-1, 1, (3 * count, 3))
    points = points[np.linalg.norm(points, axis=1) < 1][:count] + centre
    return points.astype(np.float32).astype(np.float64)


def distances(points: NDArray[Any], others: NDArray[Any]) -> NDArray[np.float64]:
    """Returns the distance from each point to the nearest of the others."""
    apart = np.linalg.norm(points[:, np.newaxis] - others[np.newaxis], axis=2)
    nearest: NDArray[np.float64] = apart.min(axis=1)
    return nearest


def test_the_tree_reaches_its_points_and_stays_among_them() -> None:
    points = cloud()
    skeleton = meristem.colonize(points, kill=0.2, influence=0.6, finish={"relax": False})
    assert len(skeleton) > 200
    assert skeleton.parent[0] == -1 and np.all(skeleton.parent[1:] >= 0)
    assert skeleton.position[0].tolist() == [0, 0, 0]
    # All points are used up, except a few that are balanced between nodes.
    assert np.mean(distances(points, skeleton.position) <= 0.2) > 0.98
    in_crown = skeleton.position[skeleton.position[:, 1] > 1]
    assert distances(in_crown, points).max() <= 0.6


def test_segments_are_a_step_long() -> None:
    skeleton = meristem.colonize(cloud(), step=0.08, finish={"relax": False})
    children = np.flatnonzero(skeleton.parent >= 0)
    segments = skeleton.position[children] - skeleton.position[skeleton.parent[children]]
    assert np.linalg.norm(segments, axis=1) == pytest.approx(0.08, rel=1e-4)


def test_tips_have_the_tip_radius() -> None:
    skeleton = meristem.colonize(cloud(), tip_radius=0.002, pipe_exponent=2)
    tips = np.setdiff1d(np.arange(len(skeleton)), skeleton.parent)
    assert skeleton.radius[tips] == pytest.approx(0.002)
    assert skeleton.radius[0] == pytest.approx(0.002 * np.sqrt(len(tips)), rel=1e-4)


def test_a_document_with_the_same_points_grows_the_same(tmp_path: Path) -> None:
    points = cloud()
    file = tmp_path / "points.txt"
    np.savetxt(file, points)
    tree = {"type": "colonize", "points": {"file": str(file)}, "step": 0.04, "kill": 0.2, "bias": [0, 0.1, 0]}
    document = meristem.Document({"meristem": 1, "seed": 9, "components": {"tree": tree}})
    skeleton = meristem.colonize(points, step=0.04, kill=0.2, bias=(0, 0.1, 0), seed=9)
    assert document.grow().stems[0].skeleton.hash == skeleton.hash


def test_the_same_grows_on_any_number_of_threads() -> None:
    points = cloud(3000)
    skeletons = [meristem.colonize(points, kill=0.1, step=0.03, threads=threads) for threads in (1, 2)]
    assert skeletons[0].hash == skeletons[1].hash


def test_several_roots_share_the_points_as_one_skeleton() -> None:
    roots = np.array([[-0.5, 0, 0], [0.5, 0, 0], [0, 0, 0.5]])
    skeleton = meristem.colonize(cloud(), roots=roots, kill=0.15)
    trees = skeleton.trees()
    assert [tree.position[0].tolist() for tree in trees] == roots.tolist()
    assert min(len(tree) for tree in trees) > 10
    alone = meristem.colonize(cloud(), roots=roots[0], kill=0.15)
    assert len(trees[0]) < len(alone)


def test_no_branch_enters_an_obstacle() -> None:
    scene = meristem.Scene({"obstacles": [{"box": [[-2, 1.5, 0.1], [2, 2.5, 2]]}]})
    points = cloud()
    skeleton = meristem.colonize(points, scene=scene, finish={"relax": False}, kill=0.2)
    children = np.flatnonzero(skeleton.parent >= 0)
    position, parent = skeleton.position[children], skeleton.position[skeleton.parent[children]]
    assert not scene.inside(skeleton.position).any()
    assert not scene.crosses(parent, position).any()
    open_tree = meristem.colonize(points, finish={"relax": False}, kill=0.2)
    assert scene.inside(open_tree.position).sum() > 20


def test_a_shift_leads_away_from_a_wall() -> None:
    wall = {"box": [[0.6, 0, -3], [0.7, 6, 3]]}
    scene = meristem.Scene({"obstacles": [wall], "latitude": 50, "sun": {"day": 172, "every_hours": 2}})
    points = cloud(1500)
    still, shifted = (meristem.colonize(points, scene=scene, kill=0.15, light={"shift": shift}) for shift in (0, 0.4))
    assert shifted.position[:, 0].mean() < still.position[:, 0].mean() - 0.02


def test_shed_branches_are_gone() -> None:
    points = cloud()
    assert meristem.colonize(points).order.max() > 1
    assert meristem.colonize(points, shed="order > 1").order.max() == 1


def test_growing_is_cancelled_and_told() -> None:
    stages: list[str] = []
    meristem.colonize(cloud(), progress=lambda stage, share: stages.append(stage))
    assert "growing" in stages
    progress = meristem.Progress()
    progress.cancel()
    with pytest.raises(meristem.Cancelled):
        meristem.colonize(cloud(), progress=progress)


@pytest.mark.parametrize(("arguments", "path", "message"), [
    ({"step": 0}, "step", "out of range"),
    ({"kill": 0.7}, "kill", "is not below 'influence'"),
    ({"influence": np.inf}, "influence", "a number is inf"),
    ({"iterations": 2.5}, "iterations", "fraction 2.5"),
    ({"bias": [1, 2]}, "bias", "a list of 2"),
    ({"light": {"shfit": 1}}, "light.shfit", "not a parameter of a light response"),
    ({"finish": {"relax": 3}}, "finish.relax", "cannot be the number 3"),
    ({"shed": "height <"}, "shed", "the expression ends"),
    ({"seed": -1}, "seed", "out of range"),
    ({"roots": [1e6, 0, 0]}, "roots[0][0]", "out of range"),
])
def test_wrong_parameters_are_named(arguments: dict[str, Any], path: str, message: str) -> None:
    with pytest.raises(meristem.InputError) as caught:
        meristem.colonize(cloud(), **arguments)
    fault, = caught.value.diagnostics
    assert fault.path == path and message in fault.message


def test_what_obstacles_leave_no_room_for_is_refused() -> None:
    scene = meristem.Scene({"obstacles": [{"box": [[-2, 1, -2], [2, 3.5, 2]]}]})
    with pytest.raises(meristem.InputError, match=r"^points: the crown lies wholly inside obstacles"):
        meristem.colonize(cloud(), scene=scene)
    with pytest.raises(meristem.InputError, match=r"^roots: a root stands inside an obstacle, at \(0, 2, 0\)"):
        meristem.colonize(cloud(centre=(0, 8, 0)), roots=(0, 2, 0), scene=scene)


@pytest.mark.parametrize(("points", "roots", "error", "message"), [
    (np.empty((0, 3)), (0, 0, 0), ValueError, "points has no rows"),
    (np.zeros((4, 2)), (0, 0, 0), ValueError, "points must have shape (n, 3), not (4, 2)"),
    ([[0, np.inf, 0]], (0, 0, 0), ValueError, "points[0, 1] is inf"),
    ([["x", "y", "z"]], (0, 0, 0), TypeError, "points must hold real numbers, not <U1"),
    ([[0, 1, 0]], [], ValueError, "roots has no rows"),
    ([[0, 1, 0]], (0, 0), ValueError, "roots must have shape (n, 3), not (2,)"),
])
def test_wrong_arrays_are_refused(points: Any, roots: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error) as caught:
        meristem.colonize(points, roots=roots)
    assert str(caught.value) == message
