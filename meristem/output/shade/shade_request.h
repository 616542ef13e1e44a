// SPDX-License-Identifier: Apache-2.0
// Requests for shade: which surface, on which days, at which hours.
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

/// Shade as a command line or Python asks for it. Exactly one of the surfaces is not null; facade_table, panels_table
/// and ground_table say what is in them.
struct ShadeRequest {
  Value facade{};         ///< an object of facade_table(), or null
  Value panels{};         ///< an object of panels_table(), or null
  Value ground{};         ///< an object of ground_table(), or null
  double spacing = 0.25;  ///< metres between points; lowered, shares are finer and take longer by its square
  /// Days between commas: numbers of days of the year, dates (2026-06-21), and FROM:TO:STEP of either.
  std::string days{};
  /// Hours between commas: numbers, times (15:30), and FROM:TO:STEP of numbers.
  std::string hours = "0:23:1";
  std::optional<double> latitude{};    ///< degrees; unset: the scene's
  std::optional<double> longitude{};   ///< degrees; with `utc_offset` hours are clock time; unset: the scene's
  std::optional<double> utc_offset{};  ///< hours
};

/// A day of a request; without a date any year's.
struct ShadeDay {
  int day = 1;                 ///< day of the year
  std::optional<Date> date{};  ///< unset: the day of any year

  /// Returns the date, or the number of the day.
  std::string text() const { return date ? date_text(*date) : std::to_string(day); }
};

/// What a request means in a scene.
struct ShadePlan {
  ShadeSurface surface;        ///< the surface that is shaded
  std::vector<ShadeDay> days;  ///< days, in their order
  std::vector<double> hours;   ///< hours of each day
  bool is_clock_time = false;  ///< false: true solar time
  /// Positions of the sun at all hours of each day, one day after another, with the true solar hours.
  std::vector<SkyDirection> sun;
  std::vector<double> solar_hours;  ///< true solar hour of each of `sun`
};

/// Returns the rows of a facade: a wall that is shaded.
const ParameterTable& facade_table();
/// Returns the rows of a field of solar panels.
const ParameterTable& panels_table();
/// Returns the rows of a rectangle of ground.
const ParameterTable& ground_table();

/// The days and hours of such texts, in their order. Throw InputError.
std::vector<ShadeDay> parse_shade_days(std::string_view text);
/// Reads hours, as parse_shade_days() reads days.
std::vector<double> parse_shade_hours(std::string_view text);

/// The plan of a request. Throws one InputError with its faults, each at a path that begins with facade, panels,
/// ground, spacing, days, hours, latitude, longitude or utc_offset.
ShadePlan plan_shade(const ShadeRequest& request, const Scene& scene);

}  // namespace meristem
