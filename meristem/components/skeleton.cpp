// SPDX-License-Identifier: Apache-2.0
// A file becomes a skeleton once, when the document is read; an instance only moves it to its site.
#include "meristem/components/skeleton.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "meristem/base/read_file.h"
#include "meristem/components/parts/surface_table.h"
#include "meristem/plant/finish.h"
#include "meristem/plant/mtg/mtg_skeleton.h"
#include "meristem/plant/pipe_radii.h"

namespace meristem {

namespace {

/// MTG files begin with their section CODE, after comments and blanks.
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

SkeletonFile load(const std::string& path, const Limits& limits) {
  const std::string text = read_file(path, limits.file_bytes);
  SkeletonFile file{.path = path, .mtg = {}, .table = {}};
  if (path.ends_with(".mtg") || begins_as_mtg(text)) {
    file.mtg = read_mtg(text, path, limits);
  } else {
    file.table = read_node_table(text, path, limits);
  }
  return file;
}

/// Coordinates that skeleton_of(MtgTree) has turned to y up, as they are where y is up in the file.
void turn_back(Skeleton& skeleton) {
  for (Vec3& position : skeleton.position) position = Vec3(position.x, -position.z, position.y);
}

Skeleton skeleton_of_mtg(const SkeletonFromFile& plant, const Limits& limits) {
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

Skeleton skeleton_of_table(const SkeletonFromFile& plant) {
  const NodeTable& table = plant.file->table;
  const bool is_y_up = plant.up == UpAxis::file ? table.is_y_up : plant.up == UpAxis::y;
  Skeleton skeleton = skeleton_of(table, {.unit = plant.unit, .is_y_up = is_y_up, .begins_at_origin = plant.at_origin},
                                  plant.file->path);
  const auto thicker = static_cast<float>(plant.diameter_unit.value_or(plant.unit) / plant.unit);
  for (float& radius : skeleton.radius) radius *= thicker;
  return skeleton;
}

/// Nodes without a radius get that of the pipe model, but none thicker than what bears them.
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

double total_length(const Skeleton& skeleton) {
  double length = 0;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (!skeleton.is_root(node)) {
      length += glm::distance(skeleton.position[node], skeleton.position[skeleton.parent[node]]);
    }
  }
  return length;
}

void prepare(SkeletonFromFile& plant, const DocumentPath& path, ParameterReader& reader) {
  if (!plant.file) return;
  const DocumentPath file_row(path, "file");
  try {
    Skeleton skeleton = plant.file->mtg ? skeleton_of_mtg(plant, reader.limits()) : skeleton_of_table(plant);
    fill_radii(skeleton, {.tip_radius = plant.tip_radius, .exponent = plant.pipe_exponent});
    const SkeletonFinish& wished = plant.finish;
    if (wished.decimate > 0) skeleton = decimate(skeleton, wished.decimate, 0);
    if (wished.relax) relax_angles(skeleton);
    if (wished.subdivide > 0) {
      const double wanted = total_length(skeleton) / wished.subdivide + static_cast<double>(skeleton.node_count());
      if (wanted > static_cast<double>(reader.limits().nodes)) {
        const DocumentPath finish_row(path, "finish");
        return reader.fault_limit(DocumentPath(finish_row, "subdivide"), "nodes", wanted, reader.limits().nodes,
                                  "nodes");
      }
      skeleton = subdivide(skeleton, wished.subdivide);
    }
    plant.skeleton = std::make_shared<const Skeleton>(std::move(skeleton));
  } catch (const InputError& error) {
    for (const Diagnostic& found : error.diagnostics()) {
      std::string where = plant.file.path;
      if (found.line > 0) where += ":" + std::to_string(found.line);
      reader.fault(file_row, "'" + where + "': " + found.message, found.expected, found.nearest);
    }
  }
}

void expand(const SkeletonFromFile& plant, const Site& site, Emitter& out) {
  Skeleton skeleton = *plant.skeleton;
  const float scale = glm::length(site.frame.heading());
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    skeleton.position[node] = site.frame.point(skeleton.position[node]);
    skeleton.radius[node] *= scale;
  }
  out.stem(std::move(skeleton), plant.surface, nullptr, plant.trim);
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

/// A finish that counts in metres, as no step of a growth is known.
const ParameterTable& metre_finish_table() {
  static const ParameterTable table =
      Table<SkeletonFinish>("a skeleton finish", "What is done to the skeleton after reading, in this order.")
          .number("decimate", &SkeletonFinish::decimate,
                  {.unit = Unit::metre, .min = 0, .max = 1000, .usual = {0, 0.5}, .fixed = true},
                  "Spacing to which the nodes along branches are thinned; 0 keeps all.")
          .boolean("relax", &SkeletonFinish::relax,
                   "Whether each node moves half way to its parent, which softens the angles of forks.")
          .number(
              "subdivide", &SkeletonFinish::subdivide,
              {.unit = Unit::metre, .min = 0, .max = 1000, .usual = {0, 0.5}, .fixed = true},
              "Spacing of the final nodes along smooth curves through the branches; 0 keeps the nodes as they are.");
  return table;
}

}  // namespace

ComponentType skeleton_component() {
  return define_component<SkeletonFromFile>({
      .traits = {.name = "skeleton",
                 .doc = "A plant that was measured or grown elsewhere, from a file of its skeleton.",
                 .material = {.colour = {0.40F, 0.34F, 0.28F}, .roughness = 0.95F},
                 .makes_stems = true,
                 .has_twigs = true,
                 .stance = BranchStance::on_axis},
      .parameters =
          Table<SkeletonFromFile>("a skeleton", "A plant from a file of its skeleton.")
              .file("file", &SkeletonFromFile::file, &load,
                    "File of the skeleton: an MTG, or a table of nodes, cylinders (TreeQSM) or trees (treetools).")
              .required()
              .number("unit", &SkeletonFromFile::unit,
                      {.min = 0, .max = 1e6, .usual = {0.001, 1}, .above_min = true, .fixed = true},
                      "Metres that a coordinate of 1 in the file means: 0.01 where it is in centimetres.")
              .number("diameter_unit", &SkeletonFromFile::diameter_unit,
                      {.min = 0, .max = 1e6, .usual = {0.001, 1}, .above_min = true, .fixed = true},
                      "Metres that a radius or diameter of 1 in the file means; by default, as 'unit'.")
              .choice("up", &SkeletonFromFile::up, {"file", "y", "z"},
                      "Axis of the file that points up: file is y in tables that Meristem has written and z in all "
                      "others.")
              .boolean("at_origin", &SkeletonFromFile::at_origin,
                       "Whether the first root moves to the component's origin; otherwise, coordinates are as in the "
                       "file.")
              .integer("scale", &SkeletonFromFile::scale, {.min = 1, .max = 1000, .usual = {1, 5}, .fixed = true},
                       "Scale of an MTG whose entities are the nodes; by default, the finest.")
              .object("features", &SkeletonFromFile::features, features_table,
                      "Features of an MTG that hold the geometry of its entities.")
              .number(
                  "tip_radius", &SkeletonFromFile::tip_radius,
                  {.unit = Unit::metre, .min = 0, .max = 10, .usual = {0.0005, 0.01}, .above_min = true, .fixed = true},
                  "Radius of the tips where the file has no radii; raised, all such wood gets thicker.")
              .number("pipe_exponent", &SkeletonFromFile::pipe_exponent,
                      {.min = 0.5, .max = 10, .usual = {2, 3}, .fixed = true},
                      "Exponent of the pipe model where the file has no radii; raised, the trunk gets thinner.")
              .object("finish", &SkeletonFromFile::finish, metre_finish_table,
                      "What is done to the skeleton after reading: nodes removed, forks softened, curves smoothed.")
              .object("surface", &SkeletonFromFile::surface, surface_table, "How the skeleton becomes a surface.")
              .choice("trim", &SkeletonFromFile::trim, trim_modes(), kTrimDoc)
              .only_where({{"surface.style", {"tubes"}}}, {"texture"})
              .without(names_off_stems(), kWhyOffStems)
              .prepare(prepare),
      .expand = expand,
  });
}

}  // namespace meristem
