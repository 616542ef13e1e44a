// SPDX-License-Identifier: Apache-2.0
// Clock time: dates, hours as clocks show them, and where the sun stands then.
//
// Based on: The Astronomical Almanac, low-precision formulas for the Sun (0.01° between 1950 and 2050).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "meristem/scene/light/sun.h"

namespace meristem {

/// A day of the Gregorian calendar.
struct Date {
  int year = 2000;
  int month = 1;  ///< from 1
  int day = 1;    ///< day of the month, from 1

  bool operator==(const Date&) const = default;
};

/// "2026-06-21"; nothing for other texts, days that no month has, and years before 1900 or after 2100.
std::optional<Date> parse_date(std::string_view text);
std::string date_text(const Date& date);  ///< "2026-06-21"
/// From 1 for 1 January.
int day_of_year(const Date& date);
/// The date this number of days later, or earlier.
Date later(const Date& date, int days);
/// Days from one date to another.
int days_between(const Date& from, const Date& to);

/// "15:30" or "15:30:20" in hours, 0 to 24; nothing for other texts.
std::optional<double> parse_clock_hour(std::string_view text);
std::string clock_hour_text(double hour);  ///< "15:30", to the nearest minute

/// What a clock needs to know of its position on the earth.
struct ClockZone {
  double longitude = 0;   ///< radians, east positive
  double utc_offset = 0;  ///< hours that the clock is ahead of universal time: 1 in central Europe, 2 in its summer

  bool operator==(const ClockZone&) const = default;
};

/// The sun as a clock's time gives it.
struct ClockSun {
  SkyDirection position;        ///< position of the sun's centre, without the air's refraction
  double solar_hour = 12;       ///< true solar time, [0, 24)
  double declination = 0;       ///< radians
  double equation_of_time = 0;  ///< minutes that a sundial is ahead of a clock that runs evenly
};

/// Where the sun stands at `latitude` (radians, north positive) on a date at a clock's hour.
ClockSun sun_by_clock(double latitude, const ClockZone& zone, const Date& date, double hour);

}  // namespace meristem
