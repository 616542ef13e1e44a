// SPDX-License-Identifier: Apache-2.0
// Requests for shade: the surface, the days and the hours.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/value.h"
#include "meristem/measure/shade.h"
#include "meristem/scene/light/clock.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// A request for shade from a command line or Python. Exactly one of the surfaces must not be null. facade_table,
/// panels_table and ground_table list their members.
struct ShadeRequest {
  Value facade{};         ///< an object of facade_table(), or null
  Value panels{};         ///< an object of panels_table(), or null
  Value ground{};         ///< an object of ground_table(), or null
  double spacing = 0.25;  ///< metres between points; smaller values give finer shares, and the time grows with the
                          ///< inverse square
  /// Days separated by commas: numbers of days of the year, dates (2026-06-21), and FROM:TO:STEP of either.
  std::string days{};
  /// Hours separated by commas: numbers, times (15:30), and FROM:TO:STEP of numbers.
  std::string hours = "0:23:1";
  std::optional<double> latitude{};    ///< degrees; unset: latitude of the scene
  std::optional<double> longitude{};   ///< degrees; if `utc_offset` is set as well, hours are clock time; unset:
                                       ///< longitude of the scene
  std::optional<double> utc_offset{};  ///< hours
};

/// A day of a request. Without a date, it is a day of any year.
struct ShadeDay {
  int day = 1;                         ///< day of the year
  std::optional<CalendarDate> date{};  ///< unset: a day of any year

  /// Returns the date, or the number of the day.
  std::string text() const { return date ? date_text(*date) : std::to_string(day); }
};

/// The meaning of a request in a scene.
struct ShadePlan {
  ShadeSurface surface;        ///< the surface whose shade is measured
  std::vector<ShadeDay> days;  ///< days, in their order
  std::vector<double> hours;   ///< hours of each day
  bool is_clock_time = false;  ///< false: true solar time
  /// Positions of the sun at all hours of each day, day by day, with the true solar hours.
  std::vector<SkyDirection> sun;
  std::vector<double> solar_hours;  ///< true solar hour of each of `sun`
};

/// Returns the table of a facade: a wall of an obstacle.
const ParameterTable& facade_table();
/// Returns the table of a field of solar panels.
const ParameterTable& panels_table();
/// Returns the table of a rectangle of ground.
const ParameterTable& ground_table();

/// Read the days in such a text, in their order. Throws InputError.
std::vector<ShadeDay> parse_shade_days(std::string_view text);
/// Reads hours, as parse_shade_days() reads days.
std::vector<double> parse_shade_hours(std::string_view text);

/// Returns the plan of a request. Throws one InputError with all errors. Each has a path that begins with facade,
/// panels, ground, spacing, days, hours, latitude, longitude or utc_offset.
ShadePlan plan_shade(const ShadeRequest& request, const Scene& scene);

}  // namespace meristem
