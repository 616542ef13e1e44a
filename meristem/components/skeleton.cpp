// SPDX-License-Identifier: Apache-2.0
// The file becomes a skeleton once, when the document is read. An instance only moves the skeleton to its site.
#include "meristem/components/skeleton.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "meristem/components/parts/surface_table.h"
#include "meristem/plant/finish.h"
#include "meristem/plant/pipe_radii.h"

namespace meristem {

namespace {

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
  std::optional<Skeleton> skeleton = read_skeleton(plant.source, path, reader);
  if (!skeleton) return;
  fill_radii(*skeleton, {.tip_radius = plant.tip_radius, .exponent = plant.pipe_exponent});
  const SkeletonFinish& requested = plant.finish;
  if (requested.decimate > 0) *skeleton = decimate(*skeleton, requested.decimate, 0);
  if (requested.relax) relax_angles(*skeleton);
  if (requested.subdivide > 0) {
    const double wanted = total_length(*skeleton) / requested.subdivide + static_cast<double>(skeleton->node_count());
    if (wanted > static_cast<double>(reader.limits().nodes)) {
      const DocumentPath finish_row(path, "finish");
      return reader.add_limit_error(DocumentPath(finish_row, "subdivide"), "nodes", wanted, reader.limits().nodes,
                                    "nodes");
    }
    *skeleton = subdivide(*skeleton, requested.subdivide);
  }
  plant.skeleton = std::make_shared<const Skeleton>(std::move(*skeleton));
}

void expand(const SkeletonFromFile& plant, const Site& site, StemSink& stems) {
  Skeleton skeleton = *plant.skeleton;
  const float scale = glm::length(site.frame.heading());
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    skeleton.position[node] = site.frame.point(skeleton.position[node]);
    skeleton.radius[node] *= scale;
  }
  stems.add(std::move(skeleton), plant.surface, {.trim = plant.trim});
}

/// The parameter table of a finish in metres, because there is no growth step.
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
              .members(&SkeletonFromFile::source, skeleton_source_table())
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
      .minimum_counts =
          [](const SkeletonFromFile& plant, const KnownMembers&) {
            return MinimumCounts{.nodes = static_cast<double>(plant.skeleton->node_count())};
          },
  });
}

}  // namespace meristem
