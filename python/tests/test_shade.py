# SPDX-License-Identifier: Apache-2.0
"""Shade of facades, panels and ground."""

from __future__ import annotations

import datetime
import math
from typing import Any

import numpy as np
import pytest

import meristem


def street(**scene: Any) -> meristem.Plant:
    """Returns a ball of 1 m radius in front of the south wall of a house."""
    house = {"name": "house", "box": [[-4, 0, -8], [4, 6, 0]]}
    ball = {"type": "simple", "shape": "sphere", "size": [2, 2, 2], "segments": 64, "frame": {"translate": [0, 5, 4]}}
    content = {
        "meristem": 1,
        "scene": {"latitude": 50, "sun": {"day": 80}, "obstacles": [house], **scene},
        "components": {"ball": ball},
    }
    return meristem.Document(content).grow()


def test_the_balls_shadow_on_a_wall_is_its_disc_over_the_cosine() -> None:
    wall = meristem.shade(street(), facade={"obstacle": "house", "side": "south"}, days=80, hours=12, spacing=0.1)
    altitude = math.radians(wall["altitude"][0, 0])
    assert wall["area"] == pytest.approx(48)
    assert wall["shade"][0, 0] * 48 == pytest.approx(math.pi / math.cos(altitude), rel=0.02)
    assert wall["shade_without_plants"][0, 0] == 0
    assert wall["cosine"][0, 0] == pytest.approx(math.cos(altitude), rel=1e-5)


def test_arrays_are_days_by_hours_and_nan_by_night() -> None:
    shade = meristem.shade(street(), facade=0, days=[80, 172], hours=[0, 12.0, "15:30"], spacing=0.5)
    np.testing.assert_array_equal(shade["days"], [80, 172])
    np.testing.assert_array_equal(shade["hours"], [0, 12, 15.5])
    for name in ("shade", "shade_without_plants", "cosine", "direct", "altitude"):
        assert shade[name].shape == (2, 3)
    assert np.isnan(shade["shade"][:, 0]).all()
    assert not np.isnan(shade["shade"][:, 1:]).any()
    assert (shade["shade"][:, 1:] >= shade["shade_without_plants"][:, 1:]).all()
    assert shade["point_shade"].shape == shade["points"].shape[:1]


def test_the_ground_is_a_grid_from_south_to_north() -> None:
    shade = meristem.shade(street(), ground=[[-6, -10], [6, 6]], days="80", hours="9:15:1", spacing=1)
    assert shade["grid"].shape == (16, 12)
    assert np.isnan(shade["grid"]).sum() == 8 * 8
    assert np.isnan(shade["grid"][6:14, 2:10]).all()  # the house is in the north
    assert np.nanmean(shade["grid"]) == pytest.approx(shade["point_shade"].mean())
    assert np.nanmean(shade["grid"]) == pytest.approx(np.nanmean(shade["shade"]))


def test_clock_time_takes_dates_in_every_form() -> None:
    plant = street()
    zone: dict[str, Any] = {"longitude": 13.4, "utc_offset": 2, "hours": "15:30", "facade": "house", "spacing": 1}
    day = datetime.date(2026, 6, 21)
    found = [meristem.shade(plant, days=days, **zone) for days in ("2026-06-21", day, [day], np.array([day], "datetime64[D]"))]
    assert found[0]["solar_hours"][0, 0] == pytest.approx(14.36, abs=0.01)
    assert all(one["days"].tolist() == [day] for one in found)
    assert len({one["altitude"][0, 0] for one in found}) == 1


def test_the_same_on_any_number_of_threads() -> None:
    plant = street()
    results = [meristem.shade(plant, facade="house", days=80, hours="8:16:1", threads=threads) for threads in (1, 3)]
    for name in ("shade", "direct", "point_shade"):
        np.testing.assert_array_equal(results[0][name], results[1][name])


def test_wrong_requests_name_the_argument() -> None:
    plant = street()
    for message, arguments in (
        ("facade.obstacle: no obstacle is called 'hose'.*did you mean 'house'", {"facade": "hose", "days": 80}),
        ("panels.tilt", {"panels": {"position": [0, 1, 0], "tilt": 100}, "days": 80}),
        ("one of facade, panels and ground", {"days": 80}),
        ("days: 'june' is not a day", {"facade": 0, "days": "june"}),
        ("hours: '25' is not an hour", {"facade": 0, "days": 80, "hours": 25}),
        ("spacing", {"facade": 0, "days": 80, "spacing": -1}),
        ("latitude", {"facade": 0, "days": 80, "latitude": 100}),
    ):
        with pytest.raises(meristem.InputError, match=message):
            meristem.shade(plant, **arguments)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="days must be"):
        meristem.shade(plant, facade=0, days=[None])
    progress = meristem.Progress()
    progress.cancel()
    with pytest.raises(meristem.Cancelled):
        meristem.shade(plant, facade=0, days=80, progress=progress)


def test_a_scene_keeps_where_it_is_when_pickled() -> None:
    import pickle

    sun = {"date": "2026-06-21", "time": "15:30", "longitude": 13.4, "utc_offset": 2}
    scene = meristem.Scene({"latitude": 50, "sun": sun, "obstacles": [{"name": "a", "box": [[0, 0, 0], [1, 1, 1]]}]})
    copy = pickle.loads(pickle.dumps(scene))
    np.testing.assert_array_equal(copy.sun[0], scene.sun[0])
    assert pickle.dumps(copy) == pickle.dumps(scene)
