# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import meristem


def test_at_noon_the_sun_stands_as_high_as_latitude_and_declination_say() -> None:
    latitude, day = np.linspace(-66, 66, 23)[:, np.newaxis], np.arange(1, 366, 13)
    azimuth, altitude = meristem.sun_position(latitude, day, 12)
    declination = meristem.declination(day)
    assert azimuth.shape == altitude.shape == (23, len(day))
    assert altitude == pytest.approx(90 - np.abs(latitude - declination))
    assert np.sin(np.radians(azimuth)) == pytest.approx(0, abs=1e-9)
    assert np.array_equal(np.cos(np.radians(azimuth)) < 0, latitude > declination)


def test_morning_and_afternoon_mirror_each_other() -> None:
    before = meristem.sun_position(48, 200, 12 - np.arange(12))
    after = meristem.sun_position(48, 200, 12 + np.arange(12))
    assert before[1] == pytest.approx(after[1])
    assert before[0] == pytest.approx(360 - after[0])


def test_the_declination_stays_between_the_tropics_and_peaks_at_midsummer() -> None:
    days = np.arange(1, 366)
    declination = meristem.declination(days)
    assert abs(declination).max() == pytest.approx(23.44, abs=0.05)
    assert abs(days[declination.argmax()] - 172) <= 2
    assert meristem.declination(172) == declination[171]


def test_the_sun_rises_and_sets_on_the_horizon() -> None:
    days = np.arange(1, 366, 30)
    sunrise, sunset = meristem.daylight(52, days)
    assert sunrise + sunset == pytest.approx(24)
    for hour in (sunrise, sunset):
        assert meristem.sun_position(52, days, hour)[1] == pytest.approx(0, abs=1e-9)


def test_polar_days_last_and_polar_nights_too() -> None:
    assert meristem.daylight(80, 172) == (0, 24)
    assert meristem.daylight(80, 355) is None
    sunrise, sunset = meristem.daylight([80, 0], 355)
    assert np.isnan([sunrise[0], sunset[0]]).all()
    assert (sunrise[1], sunset[1]) == pytest.approx((6, 18))


def test_numbers_give_numbers_and_arrays_their_common_shape() -> None:
    assert all(isinstance(angle, float) for angle in meristem.sun_position(50, 100, 9.5))
    azimuth, altitude = meristem.sun_position([40, 50], 100, [[9], [10], [11]])
    assert azimuth.shape == altitude.shape == (3, 2)
    assert (azimuth[2, 0], altitude[2, 0]) == meristem.sun_position(40, 100, 11)
    assert meristem.sun_position(50, [], 12)[0].shape == (0,)


def test_unit_vectors_point_north_east_and_up() -> None:
    east, south, up = meristem.unit_vector([90, 180, 0], [0, 0, 90])
    assert east == pytest.approx([1, 0, 0])
    assert south == pytest.approx([0, 0, 1])
    assert up == pytest.approx([0, 1, 0])
    assert meristem.unit_vector(10, 20).shape == (3,)
    assert meristem.unit_vector(np.arange(4), np.zeros((2, 1))).shape == (2, 4, 3)


@pytest.mark.parametrize(("arguments", "error", "message"), [
    ((95, 1, 1), ValueError, "latitude is 95; expected -90 to 90"),
    ((50, [1, 0], 1), ValueError, "day[1] is 0; expected 1 to 366"),
    ((50, 1, 24.5), ValueError, "hour is 24.5; expected 0 to 24"),
    ((50, 1, [1, np.nan]), ValueError, "hour[1] is nan"),
    (("north", 1, 1), TypeError, "latitude must hold real numbers, not <U5"),
    (([1, [2]], 1, 1), TypeError, "latitude cannot be read as an array"),
])
def test_what_is_no_time_or_place_is_refused(arguments: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error) as caught:
        meristem.sun_position(*arguments)
    assert str(caught.value) == message


def test_shapes_that_do_not_broadcast_are_refused() -> None:
    with pytest.raises(ValueError, match="cannot be broadcast"):
        meristem.sun_position([1, 2], [1, 2, 3], 12)
