// SPDX-License-Identifier: Apache-2.0
// Plans which parts of a plant a level of detail shows, and how coarsely.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/detail/detail.h"
#include "meristem/shape/detail/detail_budget.h"
#include "meristem/shape/tube/tube_plan.h"

namespace meristem {

/// Plans the tubes of one skeleton with a `share` of their triangles, above 0. From 1 on, the plan has all triangles.
/// With less, tubes get fewer sides, then fewer rings, and then the thinnest axes are left out with everything on them,
/// until the share is met. The thickest axis stays. Surfaces and meshes of the axes and deformed positions of nodes are
/// as in TubePlan.
TubePlan plan_tubes(const Skeleton& skeleton, const std::vector<TubeWear>& wears,
                    const std::vector<std::uint32_t>& wear_of_axis, double share,
                    const std::vector<std::uint32_t>& mesh_of_axis = {}, std::span<const Vec3> deformed = {});

/// Like plan_tubes, with about `triangles` triangles if all tubes have about `all`. Axes that are too thin for these
/// triangles are left out before rings are planned. The cost beyond one pass over the nodes therefore grows with
/// `triangles`.
TubePlan plan_quick_tubes(const Skeleton& skeleton, const std::vector<TubeWear>& wears,
                          const std::vector<std::uint32_t>& wear_of_axis, double triangles, double all,
                          const std::vector<std::uint32_t>& mesh_of_axis = {}, std::span<const Vec3> deformed = {});

/// The organs of a plant that are shown.
struct OrganDetail {
  std::vector<std::shared_ptr<const Mesh>> meshes;  ///< for each prototype
  std::vector<std::uint8_t> shown;                  ///< for each organ 1 or 0; empty: all are shown
  std::vector<float> scale;                         ///< for each prototype, a scale of its organs about their middle;
                                                    ///< empty: 1

  bool shows(std::size_t organ) const { return shown.empty() || shown[organ] != 0; }
};

/// Plans the organs of a level. Beyond level 0, organs get coarser meshes (coarsen.h), down to two triangles. If this
/// is not sufficient, an even choice of the organs is shown for each component with many organs. The shown organs are
/// enlarged so that the total area stays, but to at most three times the length. A level shows no organ that the level
/// before does not show. `budget` is the plant's budget at this level. A quick detail chooses the organs first and then
/// coarsens only their meshes.
OrganDetail plan_organs(const Plant& plant, const MeshDetail& detail, const DetailBudget& budget);

}  // namespace meristem
