# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import gc
import pickle
from typing import Any, Callable

import numpy as np
import pytest
from numpy.typing import NDArray

import meristem
from plants import small_tree

LOW, HIGH = np.array([-1.0, 0.0, 2.0]), np.array([1.0, 3.0, 2.5])
SEASON = {"latitude": 51.5, "sun": {"days": [90, 270], "every_days": 30, "every_hours": 1}, "sky": 0.25}


def walled(**values: Any) -> meristem.Scene:
    """Returns a scene with a wall in the south, from LOW to HIGH."""
    return meristem.Scene({"obstacles": [{"box": [LOW, HIGH]}], **values})


def random_points(count: int, seed: int = 7) -> NDArray[np.float64]:
    """Returns random points around the wall that 32-bit numbers represent exactly, so that numpy uses equal numbers."""
    points = np.random.default_rng(seed).uniform([-2, -1, 1], [2, 4, 4], (count, 3))
    return points.astype(np.float32).astype(np.float64)


def ball(count: int = 400) -> NDArray[np.float64]:
    """Returns points in a ball of radius 1 around (0, 2, 0)."""
    points = np.random.default_rng(3).uniform(-1, 1, (3 * count, 3))
    points = points[np.linalg.norm(points, axis=1) < 1][:count]
    return np.asarray(points + [0, 2, 0])


def box_entry(origins: NDArray[np.float64], directions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Returns where rays first meet the wall's surface, in lengths of their directions, by the slab method."""
    with np.errstate(divide="ignore"):
        one, other = (LOW - origins) / directions, (HIGH - origins) / directions
    enter, leave = np.minimum(one, other).max(axis=1), np.maximum(one, other).min(axis=1)
    hit = np.where(enter >= 0, enter, leave)
    distance: NDArray[np.float64] = np.where((enter <= leave) & (leave >= 0), hit, np.inf)
    return distance


def test_without_values_the_light_comes_from_the_zenith() -> None:
    scene = meristem.Scene()
    directions, strengths = scene.sun
    assert directions.tolist() == [[0, 1, 0]] and strengths.tolist() == [1]
    assert len(scene.sky[0]) == len(scene.lamps[0]) == len(scene.obstacles) == 0
    assert scene.mean_direction.tolist() == [0, 1, 0]


def test_sun_and_sky_share_the_directional_light() -> None:
    scene = meristem.Scene(SEASON)
    (sun, sun_strengths), (sky, sky_strengths) = scene.sun, scene.sky
    assert len(sun) == len(sun_strengths) > 50 and len(sky) == len(sky_strengths) == 40
    assert np.linalg.norm(np.vstack([sun, sky]), axis=1) == pytest.approx(np.ones(len(sun) + 40))
    assert np.all(sun[:, 1] > 0)
    assert sun_strengths.sum() == pytest.approx(0.75) and sky_strengths.sum() == pytest.approx(0.25)


def test_the_sun_of_an_hour_stands_where_sun_position_says() -> None:
    scene = meristem.Scene({"latitude": 40, "sun": {"day": 100, "hour": 15.5}})
    expected = meristem.unit_vector(*meristem.sun_position(40, 100, 15.5))
    assert scene.sun[0] == pytest.approx(expected[np.newaxis])


def test_lamps_are_as_given() -> None:
    positions, strengths = meristem.Scene({"lamps": [{"position": [1, 2, 3], "strength": 0.5}]}).lamps
    assert positions.tolist() == [[1, 2, 3]] and strengths.tolist() == [0.5]


def test_by_night_there_is_no_sun() -> None:
    with pytest.warns(UserWarning, match="the sun does not rise on day 355 at latitude 80"):
        scene = meristem.Scene({"latitude": 80, "sun": {"day": 355, "every_hours": 1}})
    assert scene.sun[0].shape == (0, 3) and scene.sun[1].shape == (0,)
    assert scene.light_at([[0, 0, 0]]).tolist() == [0]


def test_light_arrives_past_the_wall_or_not_at_all() -> None:
    scene = walled(sun={"azimuth": 180, "altitude": 0.001}, lamps=[{"position": [0, 1, 1]}])
    behind, beside = [0, 1, -1], [5, 1, 1]
    light = scene.light_at([behind, beside])
    assert light == pytest.approx([1 / 2**2, 1 + 1 / 5**2])


def test_the_light_of_single_points_is_the_light_at_them() -> None:
    scene = walled(**SEASON)
    points = random_points(200)
    points = points[~scene.inside(points)]
    alone = np.array([scene.light_of_points(point[np.newaxis])[0] for point in points])
    assert alone == pytest.approx(scene.light_at(points))
    assert 0 < alone.min() < alone.max() == pytest.approx(1)


def test_points_dim_those_below_them() -> None:
    light = meristem.Scene().light_of_points([[0.0, 3.0, 0.0], [0.0, 1.5, 0.0], [0.0, 0.0, 0.0]], radius=0.2, k=0.5)
    assert light == pytest.approx(np.exp([0, -0.5, -1]))


def test_half_of_a_ball_is_lit() -> None:
    scene = meristem.Scene({**SEASON, "sky": 0})
    onto_surface = ball(4000) - [0, 2, 0]
    share, shares = scene.crown_light(onto_surface / np.linalg.norm(onto_surface, axis=1, keepdims=True))
    assert len(shares) == len(scene.sun[0])
    assert share == pytest.approx(shares.mean())
    assert shares == pytest.approx(0.5, abs=0.01)


def test_a_crown_is_lit_as_its_hull_and_as_a_skeleton_measures() -> None:
    scene, points = walled(**SEASON), ball()
    share, shares = scene.crown_light(points)
    # The hull of a hull has another order of triangles, and so other origins of rays.
    of_hull = scene.crown_light(meristem.convex_hull(points))
    assert share == pytest.approx(of_hull[0], abs=1e-3) and shares == pytest.approx(of_hull[1], abs=0.01)
    star = meristem.Skeleton([-1] + [0] * (len(points) - 1), points)
    assert star.measure(scene=scene)["lit_share"] == pytest.approx(share)
    assert 0 < share < meristem.Scene(SEASON).crown_light(points)[0]


def test_inside_is_between_the_walls() -> None:
    points = random_points(5000)
    expected = np.all((points > LOW) & (points < HIGH), axis=1)
    assert 50 < expected.sum() < 2500
    answer = walled().inside(points)
    assert answer.dtype == bool and np.array_equal(answer, expected)


def test_ways_cross_where_slabs_say() -> None:
    starts, ends = random_points(5000), random_points(5000, seed=8)
    expected = box_entry(starts, ends - starts) <= 1
    assert 500 < expected.sum() < 4500
    assert np.array_equal(walled().crosses(starts, ends), expected)


def test_rays_meet_what_slabs_say() -> None:
    origins, directions = random_points(5000), random_points(5000, seed=9) - [0, 1.5, 2.5]
    distances = box_entry(origins, directions) * np.linalg.norm(directions, axis=1)
    met, obstacles = walled().first_hit(origins, directions)
    assert 500 < np.isfinite(distances).sum() < 4500
    assert met == pytest.approx(distances, rel=1e-4, abs=1e-4)
    assert np.array_equal(obstacles, np.where(np.isfinite(distances), 0, -1))
    assert np.array_equal(walled().blocked(origins, directions), np.isfinite(distances))


def test_the_length_of_directions_means_nothing_and_within_is_in_metres() -> None:
    scene = walled()
    for length in (1e-6, 1, 1e6):
        ray = [0, 1, 0], [[0, 0, length]]
        assert [column.tolist() for column in scene.first_hit(*ray)] == [[2], [0]]
        assert [column.tolist() for column in scene.first_hit(*ray, within=1.9)] == [[np.inf], [-1]]
        assert scene.blocked(*ray, within=2).tolist() == [True]
        assert scene.blocked(*ray, 1.9).tolist() == [False]


def test_the_nearest_obstacle_is_named() -> None:
    boxes = [{"box": [[-1, -1, z], [1, 1, z + 1]]} for z in (6, 2, 4)]
    scene = meristem.Scene({"obstacles": boxes})
    distances, obstacles = scene.first_hit([[0, 0, z] for z in (0.0, 3.5, 10.0)], [0, 0, 1])
    assert distances.tolist() == [2, 0.5, np.inf] and obstacles.tolist() == [1, 2, -1]


def test_one_row_stands_for_all() -> None:
    scene, points = walled(), random_points(300)
    lamp = np.array([0.0, 5.0, 0.0])
    rows = np.tile(lamp, (300, 1))
    assert np.array_equal(scene.crosses(points, lamp), scene.crosses(points, rows))
    assert np.array_equal(scene.crosses(lamp, points), scene.crosses(rows, points))
    assert np.array_equal(scene.blocked(points, [[0, 1, 0]]), scene.blocked(points, np.tile([0, 1, 0], (300, 1))))


def test_obstacles_come_as_meshes() -> None:
    turned = {"box": [[0, 0, 0], [1, 2, 3]], "rotate": [0, 30, 0], "translate": [4, 0, 0]}
    mesh, = meristem.Scene({"obstacles": [turned]}).obstacles
    assert mesh.volume == pytest.approx(6, rel=1e-5)
    assert mesh.positions[:, 0].min() == pytest.approx(4)


def test_no_places_get_no_answers() -> None:
    scene, none = walled(**SEASON), np.empty((0, 3))
    for answer in (scene.inside(none), scene.light_at(none), scene.blocked(none, [0, 1, 0]), scene.light_of_points([])):
        assert answer.shape == (0,)


def test_answers_are_the_same_on_any_number_of_threads() -> None:
    scene, points = walled(**SEASON), random_points(3000)
    asked: list[Callable[..., NDArray[Any]]] = [scene.inside, scene.light_at, scene.light_of_points]
    for ask in asked:
        assert np.array_equal(ask(points, threads=1), ask(points, threads=2))
    one, two = (scene.first_hit(points, [0.3, 0.1, 1], threads=threads) for threads in (1, 2))
    assert np.array_equal(one[0], two[0]) and np.array_equal(one[1], two[1])
    crown_one, crown_two = (scene.crown_light(ball(), threads=threads)[1] for threads in (1, 2))
    assert np.array_equal(crown_one, crown_two)


def test_progress_is_told_and_cancels() -> None:
    told: list[tuple[str, float]] = []
    walled().inside(random_points(2000), progress=lambda stage, share: told.append((stage, share)))
    assert told[-1] == ("asking", 1)
    progress = meristem.Progress()
    progress.cancel()
    with pytest.raises(meristem.Cancelled):
        walled().inside(random_points(10), progress=progress)


def test_a_document_has_the_same_scene() -> None:
    content = small_tree()
    scene, other = meristem.Document(content).scene, meristem.Scene(content["scene"])
    assert np.array_equal(scene.sun[0], other.sun[0]) and np.array_equal(scene.sun[1], other.sun[1])


def test_scenes_and_their_light_outlive_where_they_come_from() -> None:
    directions, strengths = meristem.Document({**small_tree(), "scene": SEASON}).scene.sun
    gc.collect()
    fresh = meristem.Scene(SEASON).sun
    assert np.array_equal(directions, fresh[0]) and np.array_equal(strengths, fresh[1])
    assert not directions.flags.writeable and not strengths.flags.writeable


def test_pickled_scenes_answer_the_same() -> None:
    spot = {"position": [0, 4, 0], "strength": 0.3, "target": [1, 0, 0], "angle": 70, "radius": 0.2}
    scene = walled(**SEASON, lamps=[{**spot, "colour": "#ff8800"}])
    copy = pickle.loads(pickle.dumps(scene))
    points = random_points(500)
    assert np.array_equal(copy.inside(points), scene.inside(points))
    assert np.array_equal(copy.light_at(points), scene.light_at(points))
    assert repr(copy) == repr(scene)
    assert repr(scene).endswith("of the sun, 40 patches of sky, 1 lamp, 1 obstacle>")


@pytest.mark.parametrize(("values", "path", "message"), [
    ({"sun": {"day": 400}}, "scene.sun.day", "out of range"),
    ({"sun": {"dya": 4}}, "scene.sun.dya", "not a parameter of a sun"),
    ({"sun": {"day": 40}}, "scene.sun", "needs a latitude"),
    ({"sky": object()}, "scene.sky", "of type object"),
    ({"obstacles": [{"mesh": "no.obj"}]}, "scene.obstacles[0].mesh", "no such file"),
    ([1, 2], "scene", "cannot be a list of 2"),
])
def test_faults_come_with_their_places_in_the_scene(values: Any, path: str, message: str) -> None:
    with pytest.raises(meristem.InputError) as caught:
        meristem.Scene(values)
    fault, = caught.value.diagnostics
    assert fault.path == path and message in fault.message
    assert (fault.file, fault.line) == ("", 0)


@pytest.mark.parametrize(("points", "error", "message"), [
    ([1, 2, 3], ValueError, "points must have shape (n, 3), not (3,)"),
    (np.zeros((2, 2)), ValueError, "points must have shape (n, 3), not (2, 2)"),
    ([["a", "b", "c"]], TypeError, "points must hold real numbers, not <U1"),
    (np.zeros((1, 3), complex), TypeError, "points must hold real numbers, not complex128"),
    ([[0, 0, 0], [0, np.nan, 0]], ValueError, "points[1, 1] is nan"),
])
def test_wrong_points_are_refused(points: Any, error: type[Exception], message: str) -> None:
    scene = walled()
    asked: list[Callable[..., NDArray[Any]]] = [scene.inside, scene.light_at, scene.light_of_points]
    for ask in asked:
        with pytest.raises(error) as caught:
            ask(points)
        assert str(caught.value) == message


def test_wrong_rays_are_refused() -> None:
    scene, origins = walled(), np.zeros((3, 3))
    refused: list[tuple[tuple[Any, ...], str]] = [
        ((origins, np.ones((2, 3))), "origins has 3 rows and directions has 2; expected as many, or one for all"),
        ((origins, [[1, 0, 0], [0, 0, 0], [0, 0, 1]]), "directions[1] is a zero vector"),
        ((origins, [1, 0, 0], -1), "within must be at least 0 metres"),
        ((origins, [1, 0, 0], np.nan), "within must be at least 0 metres"),
        ((origins, [1, 0]), "directions must have shape (n, 3), not (2,)"),
    ]
    for arguments, message in refused:
        for ask in (scene.first_hit, scene.blocked):
            with pytest.raises(ValueError) as caught:
                ask(*arguments)
            assert str(caught.value) == message


def test_other_wrong_arguments_are_refused() -> None:
    scene = walled()
    refused: list[tuple[Callable[[], object], str]] = [
        (lambda: scene.light_of_points([[0, 0, 0]], radius=0), "radius must be above 0 metres"),
        (lambda: scene.light_of_points([[0, 0, 0]], k=-1), "k must be at least 0"),
        (lambda: scene.crown_light(np.eye(3)), "crown lies in one plane, so it has no hull"),
        (lambda: scene.crown_light(ball(), rays=0), "rays must be at least 1"),
        (lambda: scene.inside(ball(), threads=-1), "threads must be 0 (all cores) to 1024"),
    ]
    for call, message in refused:
        with pytest.raises(ValueError) as caught:
            call()
        assert str(caught.value) == message
