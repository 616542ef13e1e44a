// SPDX-License-Identifier: Apache-2.0
// Plans and makes the tubes of a stem. Deformed parts are planned with their deformed nodes, and their meshes are
// deformed after they were made.
#include "meristem/shape/stem/stem_tubes.h"

#include <span>

#include "meristem/base/deform/deformation.h"
#include "meristem/shape/detail/detail_budget.h"
#include "meristem/shape/detail/detail_plan.h"
#include "meristem/shape/tube/tubes.h"

namespace meristem {

TubePlan plan_stem(const Stem& stem, const StemLooks& looks, double share, bool is_quick) {
  std::vector<TubeWear> wears;
  wears.reserve(stem.parts.size());
  for (std::size_t k = 0; k < stem.parts.size(); ++k) wears.push_back({stem.parts[k].surface, looks.mesh_of_part[k]});
  const auto deformed =
      stem.undeformed != nullptr ? std::span<const Vec3>(stem.skeleton.position) : std::span<const Vec3>();
  if (is_quick && share < 1) {
    double all = 0;
    for (NodeIndex node = 0; node < stem.skeleton.node_count(); ++node) all += about_tube_triangles(stem, node);
    return plan_quick_tubes(stem.skeleton_of_surface(), wears, stem.part_of_axis, share * all, all, looks.mesh_of_axis,
                            deformed);
  }
  return plan_tubes(stem.skeleton_of_surface(), std::move(wears), stem.part_of_axis, share, looks.mesh_of_axis,
                    deformed);
}

std::vector<Mesh> make_stem_tubes(const TubePlan& plan, const StemLooks& looks, Progress& progress) {
  std::vector<Mesh> meshes = make_tubes(plan, progress);
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    const StemPart& look = *looks.first_part[k];
    if (look.deformation != nullptr) look.deformation->map(meshes[k], Vec3(0), Vec3(0), look.component);
  }
  return meshes;
}

}  // namespace meristem
