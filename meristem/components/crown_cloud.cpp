// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/crown_cloud.h"

#include <algorithm>
#include <span>

#include "meristem/components/cloud.h"
#include "meristem/components/colonize.h"
#include "meristem/graph/component.h"
#include "meristem/graph/instances.h"

namespace meristem {

namespace {

/// Returns the points of the instance at a site, each relative to its root.
template <class Filled>
std::vector<Vec3> points_at(const Prototype& prototype, const Site& site, double time, const GrowContext& context) {
  Filled filled = *static_cast<const Filled*>(prototype.parameters.get());
  VaryingValues(prototype.varyings, std::span(&site, 1), time).apply(0, &filled);
  const RootsInCrowns trees{filled.crown, filled.points, filled.roots, filled.one_crown};
  std::vector<Vec3> points;
  for (const PointsOfRoot& of_root : points_of_roots(trees, site.key.child("points"), context))
    points.insert(points.end(), of_root.points.begin(), of_root.points.end());
  return points;
}

}  // namespace

std::optional<std::vector<Vec3>> crown_cloud(const Graph& graph, const Scene& scene, const std::string& id, double time,
                                             Progress& progress, Cache* cache, const GrowthView& view) {
  const auto prototype = std::ranges::find(graph.components, id, &Prototype::id);
  if (prototype == graph.components.end()) return std::nullopt;
  const bool is_tree = prototype->type->name == "colonize";
  if (!is_tree && prototype->type->name != "cloud") return std::nullopt;
  const InstanceQuery first{.component = id, .of = InstanceQuery::Of::instance};
  const auto found = find_instance(graph, scene, time, first, progress, cache, view);
  if (!found) return std::nullopt;
  Stand nobody;
  const Directions of_scene = scene.directions();
  const GrowContext context{scene, directions_at(found->site, of_scene), graph.limits, id, nobody, progress};
  return is_tree ? points_at<Colonize>(*prototype, found->site, time, context)
                 : points_at<Cloud>(*prototype, found->site, time, context);
}

}  // namespace meristem
