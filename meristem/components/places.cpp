// SPDX-License-Identifier: Apache-2.0
// Places sites by a table, in an area, or along a line. Sites of an area are drawn at random one after another, and a
// site is kept if it keeps the distance to the earlier ones. The sites are therefore evenly distributed, but not in
// rows. If the area is too small for the requested number, there are fewer sites.
#include "meristem/components/places.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/math.h"
#include "meristem/shape/flat/cut_polygon.h"

namespace meristem {

namespace {

constexpr double kShareOfGrid = 0.7;  // default distance, as a share of the distance in a square grid
constexpr double kThrows = 40;        // trials per site of an area
constexpr double kMaxThrows = 200'000'000;
constexpr std::size_t kFewCorners = 1000;  // of polygons whose sites are counted before growth
constexpr double kRounding = 1e-6;         // rounding of a line's corners, as a share of its length

const ParameterTable& area_table() {
  static const ParameterTable table =
      Table<PlantedArea>("an area", "An area that is planted evenly at random.")
          .points("polygon", &PlantedArea::polygon, {.unit = Unit::metre, .min = -1e6, .max = 1e6, .fixed = true},
                  "Corners of the area in the plane of the ground as [x, z], at least three.")
          .together(PointsForm::polygon)
          .required()
          .number("density", &PlantedArea::density, {.min = 0, .max = 1e6, .usual = {0, 50}, .fixed = true},
                  "Number of sites per square metre; where obstacles stand or the distance is too large there are "
                  "fewer.")
          .number("distance", &PlantedArea::distance, {.unit = Unit::metre, .min = 0, .max = 1e5, .fixed = true},
                  "Least distance between two sites; by default, 0.7 of that in a square grid of this density.");
  return table;
}

const ParameterTable& line_table() {
  static const ParameterTable table =
      Table<PlantedLine>("a line", "A line along which children stand.")
          .points("points", &PlantedLine::points, {.unit = Unit::metre, .min = -1e6, .max = 1e6, .fixed = true},
                  "Corners of the line in the plane of the ground as [x, z], at least two.")
          .required()
          .number("spacing", &PlantedLine::spacing,
                  {.unit = Unit::metre, .min = 1e-3, .max = 1e5, .usual = {0.1, 20}, .fixed = true},
                  "Distance from site to site along the line.")
          .number("offset", &PlantedLine::offset,
                  {.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-10, 10}, .fixed = true},
                  "Distance of the sites to the right of the line, seen along it; negative: to the left.")
          .number("jitter", &PlantedLine::jitter,
                  {.unit = Unit::metre, .min = 0, .max = 1e4, .usual = {0, 2}, .fixed = true},
                  "Largest random offset of a site along the line and across it.");
  return table;
}

const ParameterTable& name_table() {
  static const ParameterTable table =
      Table<PlacedName>("a name", "What a text of a table stands for.")
          .text("component", &PlacedName::component, "Id of the component that stands where the table has this text.")
          .required()
          .shorthand("component");
  return table;
}

/// Returns twice the area of a polygon.
double doubled_area(const std::vector<Vec2>& ring) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const glm::dvec2 a(ring[k]), b(ring[(k + 1) % ring.size()]);
    sum += a.x * b.y - b.x * a.y;
  }
  return std::abs(sum);
}

bool is_within(const std::vector<Vec2>& ring, double x, double z) {
  bool inside = false;
  for (std::size_t k = 0, last = ring.size() - 1; k < ring.size(); last = k++) {
    const glm::dvec2 a(ring[k]), b(ring[last]);
    if ((a.y > z) != (b.y > z) && x < a.x + (b.x - a.x) * (z - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

double length_of(const std::vector<Vec2>& line) {
  double sum = 0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    const glm::dvec2 step(line[k] - line[k - 1]);
    sum += std::sqrt(step.x * step.x + step.y * step.y);
  }
  return sum;
}

double sites_of(const PlantedArea& area) { return std::floor(area.density * doubled_area(area.polygon) / 2 + 0.5); }
// Tolerate rounding: corners are floats, so a line of 12.4 m may be slightly shorter or longer than a step of 12.4 m.
double sites_of(const PlantedLine& line) {
  const double steps = length_of(line.points) / line.spacing;
  return std::floor(steps + 1e-9 + kRounding * steps) + 1;
}

void check(const Places& places, const DocumentPath& path, ParameterReader& reader) {
  const auto require_few = [&](const char* name, double count) {
    if (count > static_cast<double>(kMaxRows)) {
      reader.add_error(DocumentPath(path, name), fmt::format("{:.0f} sites are too many", count),
                       fmt::format("at most {}", kMaxRows));
    }
  };
  if (places.area) {
    const DocumentPath area(path, "area");
    if (places.area->polygon.size() < 3 || doubled_area(places.area->polygon) == 0) {
      reader.add_error(DocumentPath(area, "polygon"), "the polygon encloses nothing",
                       "at least three corners [x, z] around an area");
    } else {
      require_few("area", sites_of(*places.area));
    }
  }
  if (places.line) {
    const DocumentPath line(path, "line");
    if (places.line->points.size() < 2 || length_of(places.line->points) == 0) {
      reader.add_error(DocumentPath(line, "points"), "the line has no length", "at least two different points [x, z]");
    } else {
      require_few("line", sites_of(*places.line));
    }
  }
  if (!places.table || places.choose.empty()) return;
  const TextTable& table = places.table->table;
  const TextTable::Column* column = table.find(places.choose);
  const DocumentPath choose(path, "choose");
  if (column == nullptr) {
    const std::vector<std::string> names = table.names();
    const std::string nearest = reader.nearest(places.choose, names);
    reader.add_error(choose, fmt::format("'{}' has no column '{}'", places.table->file, places.choose),
                     nearest.empty() ? fmt::format("one of {}", fmt::join(names, ", ")) : "", nearest);
    return;
  }
  if (column->has_numbers()) {
    reader.add_error(choose, fmt::format("the column '{}' of '{}' has numbers", places.choose, places.table->file),
                     "a column of texts, each the id of a component or one of 'names'");
    return;
  }
  for (const auto& [text, name] : places.names) {
    if (std::ranges::find(column->distinct, text) != column->distinct.end()) continue;
    const std::string nearest = reader.nearest(text, column->distinct);
    reader.add_name_error(DocumentPath(DocumentPath(path, "names"), text),
                          fmt::format("the column '{}' of '{}' has no '{}'", places.choose, places.table->file, text),
                          nearest.empty() ? "a text of that column" : "", nearest);
  }
}

/// Returns the component ids for the texts of the column `choose`, by text number.
std::vector<PlacedComponent> placed(const Places& places) {
  std::vector<PlacedComponent> components;
  if (!places.table || places.choose.empty()) return components;
  const TextTable::Column* column = places.table->table.find(places.choose);
  if (column == nullptr) return components;
  for (const std::string& text : column->distinct) {
    const auto named = std::ranges::find(places.names, text, &std::pair<std::string, PlacedName>::first);
    const bool is_named = named != places.names.end();
    components.push_back(
        {.id = is_named ? named->second.component : text,
         .hint = is_named ? "" : fmt::format(", or \"names\": {{\"{}\": ...}} with the id of one", text)});
  }
  return components;
}

/// Returns true if expressions may use a column with this name.
bool is_free(const std::string& name) {
  const auto known = site_variables();
  return is_identifier(name) && !is_builtin_name(name) && std::find(known.begin(), known.end(), name) == known.end();
}

GivenNames gives(const Places& places) {
  GivenNames given;
  if (!places.table) return given;
  for (const TextTable::Column& column : places.table->table.columns) {
    if (!is_free(column.name)) continue;
    if (column.has_numbers()) {
      given.names.push_back(column.name);
    } else {
      given.refused.emplace_back(
          column.name, fmt::format("is a column of texts: '{}' stands in line {} of '{}'", column.text(column.odd_row),
                                   places.table->table.lines[column.odd_row], places.table->file));
    }
  }
  return given;
}

/// The position of one child in the component's frame.
struct Place {
  Vec3 position{0};
  double turn = 0;  // radians about y
  double scale = 1;
};

Frame frame_of(const Place& place) {
  const auto sine = static_cast<float>(math::sin(place.turn)), cosine = static_cast<float>(math::cos(place.turn));
  Frame frame;
  frame.axes = Mat3(Vec3(cosine, 0, -sine), Vec3(0, 1, 0), Vec3(sine, 0, cosine)) * static_cast<float>(place.scale);
  frame.origin = place.position;
  return frame;
}

std::vector<Place> table_places(const Places& places, const Site& site, const InstanceContext& instance) {
  const PlaceTable& table = *places.table;
  const bool is_far = table.ground == PlaceTable::Ground::degrees;
  const DVec3 origin(places.origin_x.value_or(is_far ? table.middle.x : 0),
                     places.origin_y.value_or(is_far ? table.middle.y : 0), 0);
  std::vector<Place> all(table.table.row_count());
  for (std::size_t row = 0; row < all.size(); ++row) {
    all[row].position = table.position(row, origin);
    if (table.rotation != nullptr) all[row].turn = table.rotation->numbers[row] * kPi / 180;
    if (table.scale != nullptr) all[row].scale = table.scale->numbers[row];
    const Vec3 at = site.frame.point(all[row].position + Vec3(0, 1e-3F, 0));
    if (!instance.scene().obstacles.contain(at)) continue;
    throw InputError(
        Diagnostic{.message = fmt::format("line {} of '{}' stands within an obstacle, at ({:.4g}, {:.4g}, {:.4g})",
                                          table.table.lines[row], table.file, at.x, at.y, at.z),
                   .expected = "a position outside all obstacles",
                   .path = "components." + instance.component()});
  }
  return all;
}

/// Points of a plane with a minimum distance, stored in a grid of squares.
class Spaced {
 public:
  explicit Spaced(double distance) : distance_(distance) {}

  bool add(double x, double z) {
    if (distance_ <= 0) return true;
    const auto column = static_cast<std::int64_t>(std::floor(x / distance_));
    const auto row = static_cast<std::int64_t>(std::floor(z / distance_));
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dz = -1; dz <= 1; ++dz) {
        const auto found = squares_.find(square(column + dx, row + dz));
        if (found == squares_.end()) continue;
        for (const glm::dvec2 other : found->second) {
          const glm::dvec2 away = glm::dvec2(x, z) - other;
          if (away.x * away.x + away.y * away.y < distance_ * distance_) return false;
        }
      }
    }
    squares_[square(column, row)].push_back({x, z});
    return true;
  }

 private:
  static std::uint64_t square(std::int64_t column, std::int64_t row) {
    return static_cast<std::uint64_t>(column) << 32U ^ (static_cast<std::uint64_t>(row) & 0xffffffffU);
  }

  double distance_;
  std::unordered_map<std::uint64_t, std::vector<glm::dvec2>> squares_;
};

/// Returns the minimum distance of two sites, metres.
double distance_of(const PlantedArea& area) {
  return area.distance.value_or(area.density > 0 ? kShareOfGrid / std::sqrt(area.density) : 0);
}

/// Returns the bounding box of an area: the lower corner, and the size.
std::pair<glm::dvec2, glm::dvec2> box_of(const PlantedArea& area) {
  glm::dvec2 low(area.polygon[0]), high(area.polygon[0]);
  for (const Vec2 corner : area.polygon) {
    low = glm::min(low, glm::dvec2(corner));
    high = glm::max(high, glm::dvec2(corner));
  }
  return {low, high - low};
}

/// Returns the share of the bounding box that lies in the area.
double filled_share(const PlantedArea& area) {
  const glm::dvec2 size = box_of(area).second;
  return doubled_area(area.polygon) / 2 / (size.x * size.y);
}

std::vector<Place> area_places(const PlantedArea& area, RandomKey key, const InstanceContext& instance) {
  const auto [low, size] = box_of(area);
  const double wanted = sites_of(area);
  const auto throws = static_cast<std::uint64_t>(std::min(kThrows * wanted / filled_share(area), kMaxThrows));
  Spaced spaced(distance_of(area));
  std::vector<Place> all;
  for (std::uint64_t k = 0; k < throws && static_cast<double>(all.size()) < wanted; ++k) {
    if (k % 4096 == 0) instance.progress().check();
    const double x = low.x + size.x * key.uniform(k, 0U);
    const double z = low.y + size.y * key.uniform(k, 1U);
    if (is_within(area.polygon, x, z) && spaced.add(x, z)) all.push_back({Vec3(DVec3(x, 0, z)), 0, 1});
  }
  return all;
}

/// Returns the sites of a line. The x axis of each site points along the line.
std::vector<Place> line_places(const PlantedLine& line, RandomKey key) {
  const auto count = static_cast<std::uint64_t>(sites_of(line));
  std::vector<Place> all;
  all.reserve(count);
  std::size_t segment = 1;
  double before = 0;  // metres along the line to the segment
  for (std::uint64_t k = 0; k < count; ++k) {
    const double at = static_cast<double>(k) * line.spacing;
    glm::dvec2 step;
    double length = 0;
    for (;; ++segment) {
      step = glm::dvec2(line.points[segment]) - glm::dvec2(line.points[segment - 1]);
      length = std::sqrt(step.x * step.x + step.y * step.y);
      if (at <= before + length || segment + 1 == line.points.size()) break;
      before += length;
    }
    const glm::dvec2 along = step / std::max(length, 1e-12);
    const glm::dvec2 right(-along.y, along.x);
    const double moved = line.jitter * (2 * key.uniform(k, 0U) - 1), aside = line.jitter * (2 * key.uniform(k, 1U) - 1);
    const glm::dvec2 point =
        glm::dvec2(line.points[segment - 1]) + (at - before + moved) * along + (line.offset + aside) * right;
    all.push_back({Vec3(DVec3(point.x, 0, point.y)), math::atan2(-along.y, along.x), 1});
  }
  return all;
}

std::vector<const TextTable::Column*> given_columns(const Places& places) {
  std::vector<const TextTable::Column*> columns;
  for (const std::string& name : gives(places).names) columns.push_back(places.table->table.find(name));
  return columns;
}

void expand(const Places& places, const Site& site, const InstanceContext& instance, SiteSink& sites) {
  sites.no_children();
  const RandomKey key = site.key.child("places");
  std::vector<Place> all = places.table  ? table_places(places, site, instance)
                           : places.area ? area_places(*places.area, key, instance)
                                         : line_places(*places.line, key);
  // Remove sites inside obstacles, except sites of a table.
  if (!places.table) {
    std::erase_if(all, [&](const Place& place) {
      return instance.scene().obstacles.contain(site.frame.point(place.position + Vec3(0, 1e-3F, 0)));
    });
  }
  sites.expect(all.size());
  const auto count = static_cast<std::uint32_t>(all.size());
  const std::vector<double> turns = sites.per_child(places.turn, count), sizes = sites.per_child(places.size, count);
  const std::vector<const TextTable::Column*> given = given_columns(places);
  std::vector<double> numbers(given.size());
  const TextTable::Column* chosen =
      places.table && !places.choose.empty() ? places.table->table.find(places.choose) : nullptr;
  for (std::uint32_t k = 0; k < count; ++k) {
    if (k % 4096 == 0) instance.progress().check();
    all[k].turn += turns[k];
    all[k].scale *= sizes[k];
    const Frame frame = frame_of(all[k]);
    for (std::size_t c = 0; c < given.size(); ++c) numbers[c] = given[c]->numbers[k];
    sites.add(frame);
    sites.give(numbers, false);
    if (places.table) sites.from_row(k, false);
    if (chosen == nullptr) continue;
    sites.add_named(chosen->texts[k], site.frame * frame, 0, 0, kNoNode);
    sites.give(numbers, true);
    sites.from_row(k, true);
  }
}

/// Returns the number of sites of an area that are certain to be found, except by an unlikely chance. As long as the
/// circles around the sites cover less than half of the area, every second point within it is a site.
double fewest_sites(const PlantedArea& area) {
  // Parts that a polygon covers twice lie outside, so its area is not known.
  if (area.polygon.size() > kFewCorners || crosses_itself({area.polygon.begin(), area.polygon.end()})) return 0;
  const double wanted = sites_of(area), distance = distance_of(area), surface = doubled_area(area.polygon) / 2;
  const double free = distance > 0 ? std::floor(surface / (2 * kPi * distance * distance)) : wanted;
  const double found = std::min(kThrows * wanted, kMaxThrows * filled_share(area)) / 4;
  return std::min({wanted, free, std::floor(found)});
}

MinimumCounts minimum_counts(const Places& places, const KnownMembers& known) {
  if (places.size.varying || known.varies(member_of(places, &Places::size))) return {};  // sizes may be 0
  MinimumCounts counts{.child_scale = places.size.plain};
  if (!places.table) {
    counts.shuns_obstacles = true;
    counts.children = places.area ? fewest_sites(*places.area) : sites_of(*places.line);
    return counts;
  }
  const TextTable& table = places.table->table;
  counts.children = static_cast<double>(table.row_count());
  if (places.table->scale != nullptr && table.row_count() > 0) {
    counts.child_scale *= std::ranges::min(places.table->scale->numbers);
  }
  const TextTable::Column* const chosen = places.choose.empty() ? nullptr : table.find(places.choose);
  if (chosen == nullptr) return counts;
  counts.named.resize(chosen->distinct.size());
  for (const std::uint32_t text : chosen->texts) ++counts.named[text];
  return counts;
}

}  // namespace

ComponentType places_component() {
  return define_component<Places>({
      .traits = {.name = "places",
                 .doc = "Sites on the ground: the rows of a table, evenly at random in an area, or along a line.",
                 .has_geometry = false,
                 .bears_plants = true},
      .parameters =
          Table<Places>("places", "Sites on the ground.")
              .text_file("table", &Places::table, read_place_table,
                         "CSV file with one row per site: 'x' and 'z', 'x' and 'y' (north), or 'lon' and 'lat'; also "
                         "'height', 'rotation', 'scale'. Expressions of children can use all columns of numbers.")
              .object("area", &Places::area, area_table, "Area in which the sites lie evenly at random.")
              .object("line", &Places::line, line_table, "Line along which the sites lie.")
              .number("origin_x", &Places::origin_x, {.min = -1e9, .max = 1e9, .usual = {-1000, 1000}, .fixed = true},
                      "Value of the table's 'x' or 'lon' at this component's origin; by default, 0 for 'x' and the "
                      "middle of the column for 'lon'.")
              .number("origin_y", &Places::origin_y, {.min = -1e9, .max = 1e9, .usual = {-1000, 1000}, .fixed = true},
                      "Value of the table's 'y', 'z' or 'lat' at this component's origin; by default, 0 for 'y' and "
                      "'z' and the middle of the column for 'lat'.")
              .text("choose", &Places::choose,
                    "Column of the table whose text is the id of the component that stands at the row's site.")
              .map("names", &Places::names, name_table,
                   "Ids of components for those texts of the column that are not ids themselves.")
              .per_child(
                  "turn", &Places::turn, {.unit = Unit::degree, .min = -36000, .max = 36000, .usual = {0, 360}},
                  "Turn of each child about the vertical, on top of the table's 'rotation' or the line's direction.")
              .per_child("size", &Places::size, {.min = 0, .max = 1e4, .usual = {0, 2}},
                         "Scale of each child, on top of the table's 'scale'.")
              .one_of({"table", "area", "line"})
              .only_with("table", {"origin_x", "origin_y", "choose"})
              .only_with("choose", {"names"})
              .check(check),
      .expand = expand,
      .placed = placed,
      .gives = gives,
      .minimum_counts = minimum_counts,
  });
}

}  // namespace meristem
