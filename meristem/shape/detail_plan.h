// SPDX-License-Identifier: Apache-2.0
// What of a plant a level of detail shows, and how coarsely.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/detail.h"
#include "meristem/shape/detail_budget.h"
#include "meristem/shape/tube/tube_plan.h"

namespace meristem {

/// The tubes of one skeleton with a `share` of their triangles, above 0; from 1 on all. With less they have fewer
/// sides, then fewer rings, and then the thinnest axes, with what stands on them, are left out until the share is met;
/// the thickest axis stays. Wears and meshes of the axes and where nodes come to lie are as in TubePlan.
TubePlan plan_tubes(const Skeleton& skeleton, const std::vector<TubeWear>& wears,
                    const std::vector<std::uint32_t>& wear_of_axis, double share,
                    const std::vector<std::uint32_t>& mesh_of_axis = {}, std::span<const Vec3> deformed = {});

/// Like plan_tubes, with about `triangles` triangles where all tubes have about `all`. Axes that are too thin to be
/// among these triangles are left out before rings are planned, so the cost beyond a pass over the nodes grows with
/// `triangles`.
TubePlan plan_quick_tubes(const Skeleton& skeleton, const std::vector<TubeWear>& wears,
                          const std::vector<std::uint32_t>& wear_of_axis, double triangles, double all,
                          const std::vector<std::uint32_t>& mesh_of_axis = {}, std::span<const Vec3> deformed = {});

/// What is shown of a plant's organs.
struct OrganDetail {
  std::vector<std::shared_ptr<const Mesh>> meshes;  ///< of each prototype
  std::vector<std::uint8_t> shown;                  ///< 1 or 0 of each organ; empty: all are
  std::vector<float> scale;                         ///< of each prototype's organs, about their middle; empty: 1

  bool shows(std::size_t organ) const { return shown.empty() || shown[organ] != 0; }
};

/// Beyond level 0 organs have coarser meshes (coarsen.h), down to those of two triangles. Where that does not suffice,
/// of each component with many organs an even choice is shown, larger, so that their area in all stays unless they
/// would have to be more than three times as long. A level shows no organ that one before does not. `budget` is that
/// of the plant at this level. A quick detail chooses organs first, and makes the meshes of the chosen ones coarser.
OrganDetail plan_organs(const Plant& plant, const Detail& detail, const DetailBudget& budget);

}  // namespace meristem
