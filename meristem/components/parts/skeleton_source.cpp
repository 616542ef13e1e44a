// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/skeleton_source.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "meristem/base/read_file.h"
#include "meristem/graph/table/table.h"
#include "meristem/plant/mtg/mtg_skeleton.h"

namespace meristem {

namespace {

/// Returns true if the text begins like an MTG file: with its section CODE, after comments and blanks.
bool begins_as_mtg(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    const std::size_t first = line.find_first_not_of(" \t\r");
    at = end + 1;
    if (first == std::string_view::npos || line[first] == '#') continue;
    return line.substr(first).starts_with("CODE");
  }
  return false;
}

SkeletonFile load(const std::string& path, const SizeLimits& limits) {
  const std::string text = read_file(path, limits.file_bytes);
  SkeletonFile file{.path = path, .mtg = {}, .table = {}};
  if (path.ends_with(".mtg") || begins_as_mtg(text)) {
    file.mtg = read_mtg(text, path, limits);
  } else {
    file.table = read_node_table(text, path, limits);
  }
  return file;
}

/// Restores coordinates of a file with y up, because skeleton_of(MtgTree) assumes z up.
void turn_back(Skeleton& skeleton) {
  for (Vec3& position : skeleton.position) position = Vec3(position.x, -position.z, position.y);
}

Skeleton skeleton_of_mtg(const SkeletonSource& plant, const SizeLimits& limits) {
  const MtgFeatures& features = plant.features;
  const MtgGeometry geometry{.position = {features.x, features.y, features.z},
                             .diameter = features.diameter,
                             .scale = plant.scale,
                             .length_unit = plant.unit,
                             .diameter_unit = plant.diameter_unit.value_or(plant.unit)};
  Skeleton skeleton = skeleton_of(*plant.file->mtg, plant.file->path, geometry, limits).skeleton;
  if (plant.up == UpAxis::y) turn_back(skeleton);
  if (plant.at_origin && skeleton.node_count() > 0) {
    const Vec3 root = skeleton.position[0];
    for (Vec3& position : skeleton.position) position -= root;
  }
  return skeleton;
}

Skeleton skeleton_of_table(const SkeletonSource& plant) {
  const NodeTable& table = plant.file->table;
  const bool is_y_up = plant.up == UpAxis::file ? table.is_y_up : plant.up == UpAxis::y;
  return skeleton_of(table,
                     {.unit = plant.unit,
                      .radius_factor = plant.diameter_unit.value_or(plant.unit) / plant.unit,
                      .is_y_up = is_y_up,
                      .begins_at_origin = plant.at_origin},
                     plant.file->path);
}

const ParameterTable& features_table() {
  static const ParameterTable table =
      Table<MtgFeatures>("MTG features", "Features of an MTG that hold the geometry of its entities.")
          .text("x", &MtgFeatures::x, "Name of the feature with the coordinate to the east.")
          .text("y", &MtgFeatures::y, "Name of the feature with the coordinate to the north.")
          .text("z", &MtgFeatures::z, "Name of the feature with the height.")
          .text("diameter", &MtgFeatures::diameter,
                "Name of the feature with the diameters; by default, TopDia or TopDiameter.");
  return table;
}

}  // namespace

std::optional<Skeleton> read_skeleton(const SkeletonSource& plant, const DocumentPath& path, ParameterReader& reader) {
  if (!plant.file) return std::nullopt;
  try {
    return plant.file->mtg ? skeleton_of_mtg(plant, reader.limits()) : skeleton_of_table(plant);
  } catch (const InputError& error) {
    for (const Diagnostic& found : error.diagnostics()) {
      std::string where = plant.file.path;
      if (found.line > 0) where += ":" + std::to_string(found.line);
      reader.add_error(DocumentPath(path, "file"), "'" + where + "': " + found.message, found.expected, found.nearest);
    }
  }
  return std::nullopt;
}

void fill_radii(Skeleton& skeleton, const PipeModel& model) {
  if (std::ranges::all_of(skeleton.radius, [](float radius) { return radius > 0; })) return;
  const std::vector<float> pipes = pipe_radii(skeleton.parent, {}, model);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    float& radius = skeleton.radius[node];
    if (radius > 0) continue;
    radius = pipes[node];
    if (!skeleton.is_root(node)) radius = std::min(radius, skeleton.radius[skeleton.parent[node]]);
  }
}

const ParameterTable& skeleton_source_table() {
  static const ParameterTable table =
      Table<SkeletonSource>("a skeleton file", "A plant from a file of its skeleton.")
          .file("file", &SkeletonSource::file, &load,
                "File of the skeleton: an MTG, or a table of nodes, cylinders (TreeQSM) or trees (treetools).")
          .required()
          .number("unit", &SkeletonSource::unit,
                  {.min = 0, .max = 1e6, .usual = {0.001, 1}, .above_min = true, .fixed = true},
                  "Metres that a coordinate of 1 in the file means: 0.01 where it is in centimetres.")
          .number("diameter_unit", &SkeletonSource::diameter_unit,
                  {.min = 0, .max = 1e6, .usual = {0.001, 1}, .above_min = true, .fixed = true},
                  "Metres that a radius or diameter of 1 in the file means; by default, as 'unit'.")
          .choice("up", &SkeletonSource::up, {"file", "y", "z"},
                  "Axis of the file that points up: file is y in tables that Meristem has written and z in all "
                  "others.")
          .boolean("at_origin", &SkeletonSource::at_origin,
                   "Whether the first root moves to the component's origin; otherwise, coordinates are as in the "
                   "file.")
          .integer("scale", &SkeletonSource::scale, {.min = 1, .max = 1000, .usual = {1, 5}, .fixed = true},
                   "Scale of an MTG whose entities are the nodes; by default, the finest.")
          .object("features", &SkeletonSource::features, features_table,
                  "Features of an MTG that hold the geometry of its entities.");
  return table;
}

}  // namespace meristem
