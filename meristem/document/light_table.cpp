// SPDX-License-Identifier: Apache-2.0
// The rows of a scene's light, their rules, and the light that they describe. The sun is a single position, the
// positions of one day, or the positions of a season, which share its light.
#include "meristem/document/light_table.h"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "meristem/graph/table/table.h"
#include "meristem/scene/light/sampled_days.h"

namespace meristem {

namespace {

constexpr double kSeasonHours = 1;       // hours between the positions of a season, by default
constexpr double kMaxPositions = 10000;  // allows all hours of a year; growth traces shade for each position
constexpr std::size_t kMaxLamps = 1000;
constexpr int kDaysOfYear = 365;

/// Returns the days of a season. A season that ends before it begins continues into the next year.
std::vector<double> season_days(const SunParameters& sun) {
  const int first = sun.days[0];
  const bool goes_on = sun.days[1] < first;
  const int last = sun.days[1] + (goes_on ? kDaysOfYear : 0);
  const auto steps = static_cast<int>(std::floor((last - first) / sun.every_days));
  std::vector<double> days;
  for (int k = 0; k <= steps; ++k) {
    const double day = first + k * sun.every_days;
    days.push_back(goes_on && day > kDaysOfYear ? day - kDaysOfYear : day);
  }
  return days;
}

void check_positions(const SunParameters& sun, const DocumentPath& path, ParameterReader& reader) {
  // Compute in floating point, because the number may not fit into an integer.
  const double every = sun.every_hours.value_or(kSeasonHours);
  const double a_day = std::floor(sun.sample_hour / every) + std::floor((24 - sun.sample_hour) / every) + 1;
  const double days = sun.days.empty() ? 1 : static_cast<double>(season_days(sun).size());
  if (days * a_day <= kMaxPositions) return;
  const char* const name = sun.every_hours && a_day > days ? "every_hours" : "every_days";
  reader.add_error(DocumentPath(path, name), fmt::format("{:.12g} positions of the sun are too many", days * a_day),
                   fmt::format("at most {}: a longer '{}'", kMaxPositions, name));
}

/// Returns the day of the year that a day or a date gives, or nothing.
std::optional<double> day_of(const SunParameters& sun) {
  if (sun.day || sun.date.empty()) return sun.day;
  const std::optional<CalendarDate> date = parse_date(sun.date);
  return date ? std::optional<double>(day_of_year(*date)) : std::nullopt;
}

bool has_days(const SunParameters& sun) { return sun.day || !sun.days.empty() || !sun.date.empty(); }

void check_clock(const SunParameters& sun, const DocumentPath& path, ParameterReader& reader) {
  if (!sun.date.empty() && !parse_date(sun.date)) {
    reader.add_error(DocumentPath(path, "date"), fmt::format("'{}' is not a date", sun.date),
                     "a day from 1900 to 2100, such as \"2026-06-21\"");
  }
  if (!sun.time || (sun.longitude && sun.utc_offset)) return;
  reader.add_error(DocumentPath(path, "time"),
                   fmt::format("clock time needs {}", sun.longitude    ? "a 'utc_offset'"
                                                      : sun.utc_offset ? "a 'longitude'"
                                                                       : "a 'longitude' and a 'utc_offset'"),
                   R"(such as {"date": "2026-06-21", "time": "15:30", "longitude": 13.4, "utc_offset": 2})");
}

void check_sun(const SunParameters& sun, const DocumentPath& path, ParameterReader& reader) {
  check_clock(sun, path, reader);
  const bool by_place = sun.azimuth || sun.altitude;
  const bool by_day = has_days(sun);
  if (by_place == by_day) {
    return reader.add_error(path,
                            by_place ? "the sun is given both by its position and by a day" : "the sun has no position",
                            R"({"azimuth": 180, "altitude": 61} or {"day": 126, "hour": 9.5})");
  }
  if (by_place && !(sun.azimuth && sun.altitude)) {
    return reader.add_error(path, "the sun has only one of 'azimuth' and 'altitude'",
                            R"(both, as in {"azimuth": 180, "altitude": 61})");
  }
  if (sun.every_hours || !sun.days.empty()) check_positions(sun, path, reader);
}

const ParameterTable& sun_table() {
  static const ParameterTable table =
      Table<SunParameters>(
          "a sun",
          "Position of the sun: a direction, an hour of a day at the scene's latitude, a whole day, or a season.")
          .number("azimuth", &SunParameters::azimuth,
                  {.unit = Unit::degree, .min = -360, .max = 360, .usual = {0, 360}},
                  "Azimuth of the sun, from north (0) over east (90).")
          .number("altitude", &SunParameters::altitude, {.unit = Unit::degree, .min = -90, .max = 90, .usual = {0, 90}},
                  "Altitude of the sun above the horizon; raised, shorter shadows.")
          .number("day", &SunParameters::day, {.unit = Unit::day, .min = 1, .max = 366},
                  "Day of the year, from 1 for 1 January.")
          .integers("days", &SunParameters::days, 2, {.unit = Unit::day, .min = 1, .max = 366},
                    "First and last day of a season, which may extend into the next year.")
          .number("every_days", &SunParameters::every_days, {.unit = Unit::day, .min = 1, .max = 366, .usual = {1, 60}},
                  "Days from one sampled day of the season to the next; lowered, more positions of the sun and slower "
                  "growth.")
          .number(
              "every_hours", &SunParameters::every_hours,
              {.unit = Unit::hour, .min = 0, .max = 24, .usual = {0.25, 6}, .above_min = true},
              "Hours between sampled positions of the sun, for the light of a whole day; by default, 1 in a season.")
          .number(
              "sample_hour", &SunParameters::sample_hour, {.unit = Unit::hour, .min = 0, .max = 24},
              "One of the sampled hours, in true solar time; the others lie whole multiples of 'every_hours' before "
              "and after it.")
          .number("hour", &SunParameters::hour, {.unit = Unit::hour, .min = 0, .max = 24},
                  "Hour of the day in true solar time, with the sun highest at 12; for a whole day or season, the hour "
                  "that pictures show.")
          .text("date", &SunParameters::date, "Date of the day, such as \"2026-06-21\", in place of its number.")
          .number("time", &SunParameters::time, {.unit = Unit::hour, .min = 0, .max = 24},
                  "Time of the day as a clock shows it, such as \"15:30\", in place of the solar hour.")
          .number("longitude", &SunParameters::longitude, {.unit = Unit::degree, .min = -180, .max = 180},
                  "Longitude of the scene, east positive, which clock time needs.")
          .number("utc_offset", &SunParameters::utc_offset, {.unit = Unit::hour, .min = -14, .max = 14},
                  "Hours that the clock is ahead of universal time: 1 in central Europe, 2 in summer time there.")
          .never_with("day", {"days", "date"})
          .never_with("days", {"date"})
          .only_with("days", {"every_days"})
          .never_with("azimuth", {"every_hours", "hour", "sample_hour"})
          .only_where({{"every_hours"}, {"days"}}, {"sample_hour"})
          .only_with("date", {"time"})
          .never_with("time", {"hour"})
          .only_with("time", {"longitude", "utc_offset"})
          .check(check_sun);
  return table;
}

void check_lamp(const Lamp& lamp, const DocumentPath& path, ParameterReader& reader) {
  if (lamp.colour == Vec3(0)) {
    reader.add_error(DocumentPath(path, "colour"), "black light has no hue", "a colour other than black");
  }
  if (lamp.target == lamp.position) {
    reader.add_error(DocumentPath(path, "target"), "the lamp shines at its own position", "another point");
  }
}

const ParameterTable& lamp_table() {
  static const ParameterTable table =
      Table<Lamp>("a lamp", "A lamp that shines to all sides, or as a spot into a cone.")
          .vector("position", &Lamp::position, {.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-10, 10}},
                  "Position of the lamp.")
          .in_space(InSpace::position)
          .required()
          .number(
              "strength", &Lamp::strength, {.min = 0, .max = 1e6, .usual = {0.05, 10}, .above_min = true},
              "Strength of the lamp at a distance of one metre, relative to all directional light; it falls with the "
              "square of the distance.")
          .colour(
              "colour", &Lamp::colour,
              "Colour of the lamp's light in pictures, by default a warm white; only the hue counts, and the strength "
              "says how bright it is.")
          .vector("target", &Lamp::target, {.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-10, 10}},
                  "Point that the lamp shines at, which makes it a spot; by default, it shines to all sides.")
          .in_space(InSpace::position)
          .number("angle", &Lamp::angle, {.unit = Unit::degree, .min = 1, .max = 180, .usual = {10, 120}},
                  "Opening angle of a spot's cone, whose edge fades; raised, a wider spot of equal brightness.")
          .number(
              "radius", &Lamp::radius, {.unit = Unit::metre, .min = 0, .max = 100, .usual = {0.02, 2}},
              "Radius of the lamp in pictures; raised, its shadows have softer edges; by default, that of a fist. A "
              "spot is a disc that faces its target.")
          .only_with("target", {"angle"})
          .check(check_lamp);
  return table;
}

/// Returns the hour of pictures as text.
std::string shown_time(const SunParameters& sun) {
  return sun.time ? clock_hour_text(*sun.time) : fmt::format("{:.6g} h", sun.hour);
}

/// Returns the reason, as text, why the sun gives no light.
std::string reason_without_sun(const LightParameters& settings) {
  const SunParameters& sun = *settings.sun;
  if (!has_days(sun)) return "the sun is below the horizon";
  const double latitude = degrees(*settings.latitude);
  if (!sun.days.empty()) {
    return fmt::format("the sun does not rise from day {} to {} at latitude {:.6g}", sun.days[0], sun.days[1],
                       latitude);
  }
  const std::string day = sun.day ? fmt::format("day {:.6g}", *sun.day) : sun.date;
  if (sun.every_hours) return fmt::format("the sun does not rise on {} at latitude {:.6g}", day, latitude);
  return fmt::format("the sun is below the horizon at {} on {} at latitude {:.6g}", shown_time(sun), day, latitude);
}

std::string_view consequence_without_sun(const LightParameters& settings) {
  const bool has_sky = settings.sky > 0;
  if (settings.lamps.empty()) return has_sky ? "the sky gives all light" : "there is no light";
  return has_sky ? "sky and lamps give all light" : "the lamps give all light";
}

/// Warns if the sun gives no light, in general or in pictures. A scene with lamps at a single hour of the night is
/// intended and gives no warning.
void warn_of_night(const LightParameters& settings, const DocumentPath& path, ParameterReader& reader,
                   const Scene& scene) {
  const SunParameters& sun = *settings.sun;
  const bool has_hours = sun.every_hours || !sun.days.empty();
  const bool has_lamps = !settings.lamps.empty();
  if (scene.light.sun.empty() && (has_hours || !has_lamps)) {
    reader.warn(path, fmt::format("{}, so {}", reason_without_sun(settings), consequence_without_sun(settings)));
  } else if (!scene.light.sun.empty() && scene.sun.altitude <= 0 && !has_lamps) {
    reader.warn(path, fmt::format("in pictures, at {}, the sun is below the horizon", shown_time(sun)));
  }
}

/// Returns the position of the sun in pictures.
SkyDirection shown_sun(const LightParameters& settings) {
  const SunParameters& sun = *settings.sun;
  if (sun.azimuth) return {*sun.azimuth, *sun.altitude};
  if (sun.time) {
    const ClockZone zone{*sun.longitude, *sun.utc_offset};
    return sun_by_clock(*settings.latitude, zone, *parse_date(sun.date), *sun.time).position;
  }
  if (const auto day = day_of(sun)) return sun_position(*settings.latitude, *day, sun.hour);
  const std::vector<double> days = season_days(sun);
  return sun_position(*settings.latitude, days[days.size() / 2], sun.hour);
}

/// Returns all positions of the sun. Their weights add up to 1.
std::vector<DirectionalLight> sun_positions(const LightParameters& settings, SkyDirection shown) {
  const SunParameters& sun = *settings.sun;
  const DaySamples samples{.every = sun.every_hours.value_or(kSeasonHours), .anchor = sun.sample_hour};
  if (!sun.days.empty()) {
    return sampled_days(*settings.latitude, season_days(sun), samples);
  }
  if (day_of(sun) && sun.every_hours) return sampled_days(*settings.latitude, {*day_of(sun)}, samples);
  if (shown.altitude <= 0) return {};
  return {DirectionalLight{.toward = unit_vector(shown)}};
}

}  // namespace

const ParameterTable& light_table() {
  static const ParameterTable table =
      Table<LightParameters>("a light", "The light of a scene.")
          .number("latitude", &LightParameters::latitude, {.unit = Unit::degree, .min = -90, .max = 90},
                  "Latitude of the scene, north positive; required for a sun with a day.")
          .object("sun", &LightParameters::sun, sun_table,
                  "Position of the sun; by default, light comes from the zenith.")
          .number("sky", &LightParameters::sky, {.min = 0, .max = 1},
                  "Share of the directional light that comes from the whole sky; the rest comes from the sun. Raised, "
                  "the sides of plants and the shade get more light.")
          .list("lamps", &LightParameters::lamps, lamp_table, "Lamps within the scene.")
          .only_where({{"sun.day"}, {"sun.days"}, {"sun.date"}}, {"latitude"});
  return table;
}

void check_light(const LightParameters& settings, const DocumentPath& path, ParameterReader& reader) {
  const std::optional<SunParameters>& sun = settings.sun;
  if (sun && has_days(*sun) && !settings.latitude) {
    reader.add_error(DocumentPath(path, "sun"), "a sun with a day needs a latitude", R"("latitude" in the scene)");
  }
  if (settings.lamps.size() > kMaxLamps) {
    reader.add_error(DocumentPath(path, "lamps"), fmt::format("{} lamps are too many", settings.lamps.size()),
                     fmt::format("at most {}", kMaxLamps));
  }
}

void light_scene(const LightParameters& settings, const DocumentPath& path, ParameterReader& reader, Scene& scene) {
  Light& light = scene.light;
  scene.latitude = settings.latitude;
  if (settings.sun) {
    if (settings.sun->time) scene.clock = ClockZone{*settings.sun->longitude, *settings.sun->utc_offset};
    scene.sun = shown_sun(settings);
    light.sun = sun_positions(settings, scene.sun);
    warn_of_night(settings, DocumentPath(path, "sun"), reader, scene);
  }
  for (DirectionalLight& position : light.sun) position.strength *= 1 - settings.sky;
  if (settings.sky == 1) light.sun.clear();
  if (settings.sky > 0) light.sky = even_sky(settings.sky);
  light.lamps = settings.lamps;
}

}  // namespace meristem
