// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meristem/components/parts/operation_table.h"
#include "meristem/components/parts/organize_table.h"
#include "meristem/components/parts/skeleton_source.h"
#include "meristem/components/parts/training.h"
#include "meristem/graph/component.h"
#include "meristem/grow/organize/organize.h"
#include "meristem/plant/trim.h"

namespace meristem {

/// Self-organizing trees that grow metamer by metamer, by the competition of their buds for light and space.
struct Organize : GrowingComponent {
  OrganizeParameters growth;               ///< without operations
  std::optional<SkeletonSource> skeleton;  ///< existing wood; unset: only seeds
  OrganizeLight light;
  std::optional<Training> training;
  std::vector<AnyOperation> operations;
  std::vector<Vec3> roots{Vec3(0)};  ///< positions of the trees, in the component's frame
  int leaf_age = 1;
  double leaf_angle = radians(50);
  SurfaceOptions surface;
  TrimMode trim = TrimMode::cut;  ///< effect of a body around its stems
  /// The trees of `skeleton` in the component's frame, with all radii above 0.
  std::shared_ptr<const std::vector<Skeleton>> standing{};
};

ComponentType organize_component();

/// Returns true if `component` is a self-organizing tree whose `light.lean` is given but has no effect: the light of
/// the scene comes from straight above, so shade falls straight down in any case.
bool leans_in_vain(const Prototype& component, const Light& light);

}  // namespace meristem
