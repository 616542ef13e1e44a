// SPDX-License-Identifier: Apache-2.0
// Dates, hours shown by clocks, and the position of the sun at that time.
//
// Based on: The Astronomical Almanac, low-precision formulas for the Sun (0.01° between 1950 and 2050).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "meristem/scene/light/sun.h"

namespace meristem {

/// A day of the Gregorian calendar.
struct CalendarDate {
  int year = 2000;  ///< year of the Gregorian calendar
  int month = 1;    ///< from 1
  int day = 1;      ///< day of the month, from 1

  bool operator==(const CalendarDate&) const = default;
};

/// Parses a date such as "2026-06-21". Returns nothing for other texts, for days that do not exist, and for years
/// before 1900 or after 2100.
std::optional<CalendarDate> parse_date(std::string_view text);
std::string date_text(const CalendarDate& date);  ///< "2026-06-21"
/// Returns the day of the year, 1 for 1 January.
int day_of_year(const CalendarDate& date);
/// Returns the date `days` days later; earlier if negative.
CalendarDate later(const CalendarDate& date, int days);
/// Returns the number of days from one date to another.
int days_between(const CalendarDate& from, const CalendarDate& to);

/// Parses "15:30" or "15:30:20" and returns hours, 0 to 24. Returns nothing for other texts.
std::optional<double> parse_clock_hour(std::string_view text);
/// Returns "15:30", rounded to the nearest minute. `hour` must be at least 0. From 23:59:30 on, the result is "24:00".
std::string clock_hour_text(double hour);

/// The place of a clock: longitude and time zone.
struct ClockZone {
  double longitude = 0;   ///< radians, positive to the east
  double utc_offset = 0;  ///< hours ahead of universal time: 1 in central Europe in winter, 2 in summer

  bool operator==(const ClockZone&) const = default;
};

/// The position of the sun at a clock time.
struct ClockSun {
  SkyDirection position;        ///< position of the sun's centre, without refraction by the air
  double solar_hour = 12;       ///< true solar time, [0, 24)
  double declination = 0;       ///< radians
  double equation_of_time = 0;  ///< minutes that a sundial is ahead of a uniform clock
};

/// Returns the sun at `latitude` (radians, positive to the north) on a date at a clock hour.
ClockSun sun_by_clock(double latitude, const ClockZone& zone, const CalendarDate& date, double hour);

}  // namespace meristem
