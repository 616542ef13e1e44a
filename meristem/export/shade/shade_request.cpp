// SPDX-License-Identifier: Apache-2.0
// Reads requests for shade: parses days and hours, reads the surface with tables of parameters, and computes the sun's
// positions.
#include "meristem/export/shade/shade_request.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/table/reader.h"
#include "meristem/graph/table/table.h"

namespace meristem {
namespace {

constexpr std::size_t kMaxMoments = 100'000;
constexpr double kMaxPoints = 1'000'000;

struct FacadeParameters {
  std::string obstacle;
  FacadeSide side = FacadeSide::walls;
  std::optional<double> azimuth;
};

struct GroundAreaParameters {
  std::vector<Vec2> area;  // two corners [x, z]
  double height = 0;
};

struct PanelParameters {
  Vec3 position{0, 1, 0};
  double width = 1;
  double length = 1;
  double tilt = radians(30);
  double azimuth = kPi;
};

InputError error(std::string path, std::string message, std::string expected, std::string nearest = {}) {
  return InputError(Diagnostic{.message = std::move(message),
                               .expected = std::move(expected),
                               .nearest = std::move(nearest),
                               .path = std::move(path)});
}

/// Returns the finite number that a whole text represents.
std::optional<double> number_of(std::string_view text) {
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_all = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return is_all && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    std::string_view part = text.substr(begin, end == std::string_view::npos ? end : end - begin);
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
    parts.push_back(part);
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

/// Returns the number of steps from a beginning to an end. A last step that passes the end only by rounding counts.
std::size_t steps_between(double from, double to, double step, const char* path, std::string_view text) {
  const char* const wanted = "FROM:TO:STEP, with a step above 0 and an end that is not before the start";
  if (!(step > 0) || !(to >= from)) throw error(path, fmt::format("'{}' is not a row of numbers", text), wanted);
  const double steps = std::floor((to - from) / step + 1e-9);
  if (!(steps < static_cast<double>(kMaxMoments))) {
    throw error(path, fmt::format("'{}' has too many steps", text), fmt::format("at most {}", kMaxMoments));
  }
  return static_cast<std::size_t>(steps);
}

std::optional<ShadeDay> day_of(std::string_view text) {
  if (const auto date = parse_date(text)) return ShadeDay{day_of_year(*date), date};
  const auto number = number_of(text);
  if (!number || *number != std::floor(*number) || *number < 1 || *number > 366) return std::nullopt;
  return ShadeDay{static_cast<int>(*number), {}};
}

void add_days(std::string_view part, std::vector<ShadeDay>& days) {
  const std::vector<std::string_view> ends = parts_of(part, ':');
  const auto wrong = [&] {
    return error("days", fmt::format("'{}' is not a day", part),
                 "a day of the year (172), a date (2026-06-21), or FROM:TO:STEP of either");
  };
  if (ends.size() == 1) {
    const auto day = day_of(part);
    if (!day) throw wrong();
    days.push_back(*day);
    return;
  }
  if (ends.size() != 3) throw wrong();
  const auto from = day_of(ends[0]);
  const auto to = day_of(ends[1]);
  const auto step = number_of(ends[2]);
  if (!from || !to || !step || *step != std::floor(*step) || *step > 1e5 ||
      from->date.has_value() != to->date.has_value()) {
    throw wrong();
  }
  const int length = from->date ? days_between(*from->date, *to->date) : to->day - from->day;
  const std::size_t steps = steps_between(0, length, *step, "days", part);
  for (std::size_t k = 0; k <= steps; ++k) {
    const int more = static_cast<int>(k) * static_cast<int>(*step);
    if (!from->date) {
      days.push_back({from->day + more, {}});
    } else {
      const CalendarDate date = later(*from->date, more);
      days.push_back({day_of_year(date), date});
    }
  }
}

void add_hours(std::string_view part, std::vector<double>& hours) {
  const std::vector<std::string_view> ends = parts_of(part, ':');
  const auto is_hour = [](double hour) { return hour >= 0 && hour <= 24; };
  const auto wrong = [&] {
    return error("hours", fmt::format("'{}' is not an hour", part),
                 "0 to 24, a time (15:30), or FROM:TO:STEP (6:20:0.5)");
  };
  if (ends.size() == 3) {
    const auto from = number_of(ends[0]);
    const auto to = number_of(ends[1]);
    const auto step = number_of(ends[2]);
    if (!from || !to || !step || !is_hour(*from) || !is_hour(*to)) throw wrong();
    const std::size_t steps = steps_between(*from, *to, *step, "hours", part);
    for (std::size_t k = 0; k <= steps; ++k) hours.push_back(std::min(24.0, *from + static_cast<double>(k) * *step));
    return;
  }
  const auto hour = ends.size() == 2 ? parse_clock_hour(part) : number_of(part);
  if (!hour || !is_hour(*hour)) throw wrong();
  hours.push_back(*hour);
}

/// Reads a struct by its table.
template <class Parameters>
Parameters read_parameters(const ParameterTable& table, const Value& value, std::string_view name) {
  Parameters parameters;
  ParameterReader reader({}, SizeLimits());
  // A bare value gets the name of its row, so that the rules of the table apply.
  const Value whole = value.object() != nullptr ? value : Value(Value::Object{{table.shorthand, value}});
  const DocumentPath top;
  reader.read(table, &parameters, table.shorthand.empty() ? value : whole, DocumentPath(top, name));
  if (reader.error_count() > 0) throw InputError(reader.take_diagnostics());
  return parameters;
}

/// Obstacles may be named by number, which need not be a text.
Value with_text_names(const Value& value) {
  const auto as_text = [](const Value& name) {
    return name.number() != nullptr ? Value(fmt::format("{:.12g}", *name.number())) : name;
  };
  if (value.object() == nullptr) return as_text(value);
  Value copy = value;
  if (Value* obstacle = copy.find("obstacle")) *obstacle = as_text(*obstacle);
  return copy;
}

/// Returns the obstacles of that name, or the obstacle of that number.
std::vector<std::size_t> obstacles_called(const std::string& name, const Obstacles& obstacles) {
  const std::vector<Obstacle>& bodies = obstacles.bodies();
  std::vector<std::size_t> found;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].name == name) found.push_back(k);
    names.push_back(bodies[k].name.empty() ? std::to_string(k) : bodies[k].name);
  }
  if (!found.empty()) return found;
  const auto number = number_of(name);
  if (number && *number == std::floor(*number) && *number >= 0 && *number < static_cast<double>(bodies.size())) {
    return {static_cast<std::size_t>(*number)};
  }
  if (bodies.empty()) throw error("facade.obstacle", "the scene has no obstacles", "an obstacle in the scene");
  throw error("facade.obstacle", fmt::format("no obstacle is called '{}'", name),
              fmt::format("one of {}", fmt::join(names, ", ")), nearest_name(name, names));
}

void check_points(double area, double spacing) {
  const double points = area / (spacing * spacing);
  if (points <= kMaxPoints) return;
  throw error("spacing", fmt::format("{:.4g} points are too many", points),
              fmt::format("at most {}: a wider spacing than {:.4g} m", kMaxPoints, spacing));
}

ShadeSurface facade_of(const Value& value, const Scene& scene, double spacing) {
  const auto facade = read_parameters<FacadeParameters>(facade_table(), with_text_names(value), "facade");
  std::vector<ShadeSurface> surfaces;
  for (const std::size_t obstacle : obstacles_called(facade.obstacle, scene.obstacles)) {
    check_points(facade_area(scene.obstacles, obstacle, facade.side, facade.azimuth), spacing);
    surfaces.push_back(facade_surface(scene.obstacles, obstacle, facade.side, facade.azimuth, spacing));
  }
  ShadeSurface surface = surfaces.size() == 1 ? std::move(surfaces[0]) : joined(surfaces);
  if (surface.positions.empty()) {
    throw error("facade", fmt::format("no free face of '{}' looks to that side", facade.obstacle),
                "another side, or an azimuth");
  }
  return surface;
}

ShadeSurface panels_of(const Value& value, double spacing) {
  const auto panels = read_parameters<PanelParameters>(panels_table(), value, "panels");
  check_points(panels.width * panels.length, spacing);
  return panel_surface({panels.position, panels.width, panels.length, panels.tilt, panels.azimuth}, spacing);
}

ShadeSurface ground_of(const Value& value, const Scene& scene, double spacing) {
  const auto ground = read_parameters<GroundAreaParameters>(ground_table(), value, "ground");
  const Vec2 size = glm::abs(ground.area[1] - ground.area[0]);
  check_points(double{size.x} * size.y, spacing);
  ShadeSurface surface = ground_surface(ground.area[0], ground.area[1], ground.height, scene.obstacles, spacing);
  if (surface.positions.empty()) throw error("ground", "obstacles stand on all of this ground", "another area");
  return surface;
}

ShadeSurface surface_of(const ShadeRequest& request, const Scene& scene) {
  const int given = !request.facade.is_null() + !request.panels.is_null() + !request.ground.is_null();
  if (given != 1) {
    throw InputError(Diagnostic{.message = given == 0 ? "no surface is given" : "more than one surface is given",
                                .expected = "one of facade, panels and ground"});
  }
  if (!(request.spacing > 0 && request.spacing <= 1000)) {
    throw error("spacing", fmt::format("the spacing cannot be {:.6g}", request.spacing),
                "metres above 0, at most 1000");
  }
  if (!request.facade.is_null()) return facade_of(request.facade, scene, request.spacing);
  if (!request.panels.is_null()) return panels_of(request.panels, request.spacing);
  return ground_of(request.ground, scene, request.spacing);
}

void check_within(const char* name, const std::optional<double>& value, double low, double high) {
  if (!value || (*value >= low && *value <= high)) return;
  throw error(name, fmt::format("it cannot be {:.6g}", *value), fmt::format("{:.6g} to {:.6g}", low, high));
}

double latitude_of(const ShadeRequest& request, const Scene& scene) {
  check_within("latitude", request.latitude, -90, 90);
  if (request.latitude) return radians(*request.latitude);
  if (scene.latitude) return *scene.latitude;
  throw error("latitude", "the scene has no latitude", "the latitude of the scene in degrees, north positive");
}

std::optional<ClockZone> zone_of(const ShadeRequest& request, const Scene& scene) {
  check_within("longitude", request.longitude, -180, 180);
  check_within("utc_offset", request.utc_offset, -14, 14);
  if (!request.longitude && !request.utc_offset) return scene.clock;
  ClockZone zone = scene.clock.value_or(ClockZone());
  if (request.longitude) zone.longitude = radians(*request.longitude);
  if (request.utc_offset) zone.utc_offset = *request.utc_offset;
  if (scene.clock || (request.longitude && request.utc_offset)) return zone;
  throw error(request.longitude ? "utc_offset" : "longitude", "clock time needs both a longitude and an offset",
              "the scene's longitude in degrees and the clock's hours ahead of universal time");
}

void set_times(const ShadeRequest& request, const Scene& scene, ShadePlan& plan) {
  const double latitude = latitude_of(request, scene);
  const std::optional<ClockZone> zone = zone_of(request, scene);
  plan.is_clock_time = zone.has_value();
  plan.days = parse_shade_days(request.days);
  plan.hours = parse_shade_hours(request.hours);
  if (plan.days.size() * plan.hours.size() > kMaxMoments) {
    throw error("days", fmt::format("{} days of {} hours are too many moments", plan.days.size(), plan.hours.size()),
                fmt::format("at most {}", kMaxMoments));
  }
  for (const ShadeDay& day : plan.days) {
    if (zone && !day.date) {
      throw error("days", fmt::format("day {} has no year, and hours are clock time here", day.day),
                  "a date such as 2026-06-21");
    }
    for (const double hour : plan.hours) {
      if (zone) {
        const ClockSun sun = sun_by_clock(latitude, *zone, *day.date, hour);
        plan.sun.push_back(sun.position);
        plan.solar_hours.push_back(sun.solar_hour);
      } else {
        plan.sun.push_back(sun_position(latitude, day.day, hour));
        plan.solar_hours.push_back(hour);
      }
    }
  }
}

}  // namespace

const ParameterTable& facade_table() {
  static const ParameterTable table =
      Table<FacadeParameters>("a facade", "Faces of an obstacle whose shade is measured.")
          .text("obstacle", &FacadeParameters::obstacle,
                "Name of the obstacle, or its number in the scene's list, from 0.")
          .required()
          .choice("side", &FacadeParameters::side, {"walls", "north", "east", "south", "west", "roof", "all"},
                  "Faces of the obstacle: the walls that face a direction less than 45° away from this side, the roof, "
                  "or all faces.")
          .number("azimuth", &FacadeParameters::azimuth, {.unit = Unit::degree, .min = -360, .max = 360},
                  "Azimuth, from north (0) over east (90), that selects the walls facing less than 45° away from it.")
          .never_with("side", {"azimuth"})
          .shorthand("obstacle");
  return table;
}

const ParameterTable& panels_table() {
  constexpr NumberRange kSize{.unit = Unit::metre, .min = 0, .max = 1e4, .above_min = true};
  static const ParameterTable table =
      Table<PanelParameters>("a field of panels", "A flat rectangle whose shade is measured, such as solar panels.")
          .vector("position", &PanelParameters::position, {.unit = Unit::metre, .min = -1e5, .max = 1e5},
                  "Position of the middle of the field.")
          .required()
          .number("width", &PanelParameters::width, kSize, "Width of the field along the horizontal.")
          .number("length", &PanelParameters::length, kSize, "Length of the field up its slope.")
          .number("tilt", &PanelParameters::tilt, {.unit = Unit::degree, .min = 0, .max = 90},
                  "Tilt of the field against the ground: 0 lies flat, 90 stands upright.")
          .number("azimuth", &PanelParameters::azimuth, {.unit = Unit::degree, .min = -360, .max = 360},
                  "Azimuth that the field faces, from north (0) over east (90).");
  return table;
}

const ParameterTable& ground_table() {
  static const ParameterTable table =
      Table<GroundAreaParameters>("an area of ground", "A rectangle of ground whose shade is measured.")
          .points("area", &GroundAreaParameters::area, {.unit = Unit::metre, .min = -1e5, .max = 1e5},
                  "Two opposite corners [x, z] of the area.")
          .required()
          .number("height", &GroundAreaParameters::height, {.unit = Unit::metre, .min = -1e4, .max = 1e4},
                  "Height above y = 0 at which the shade is measured.")
          .check([](const GroundAreaParameters& ground, const DocumentPath& path, ParameterReader& reader) {
            const DocumentPath area(path, "area");
            if (ground.area.size() != 2) {
              return reader.add_error(area, fmt::format("the area has {} corners", ground.area.size()),
                                      "two opposite corners, such as [[-10, -10], [10, 10]]");
            }
            const Vec2 size = glm::abs(ground.area[1] - ground.area[0]);
            if (!(size.x > 0 && size.y > 0)) {
              reader.add_error(area, "the area has no width", "two corners that differ in x and z");
            }
          })
          .shorthand("area");
  return table;
}

std::vector<ShadeDay> parse_shade_days(std::string_view text) {
  std::vector<ShadeDay> days;
  for (const std::string_view part : parts_of(text, ',')) add_days(part, days);
  return days;
}

std::vector<double> parse_shade_hours(std::string_view text) {
  std::vector<double> hours;
  for (const std::string_view part : parts_of(text, ',')) add_hours(part, hours);
  return hours;
}

ShadePlan plan_shade(const ShadeRequest& request, const Scene& scene) {
  ShadePlan plan;
  set_times(request, scene, plan);
  plan.surface = surface_of(request, scene);
  const std::size_t points = plan.surface.positions.size();
  if (points > kMaxShadeRays / plan.sun.size()) {
    throw error("spacing", fmt::format("{} points under {} positions of the sun are too many", points, plan.sun.size()),
                fmt::format("at most {} rays: a wider spacing, or fewer days and hours", kMaxShadeRays));
  }
  return plan;
}

}  // namespace meristem
