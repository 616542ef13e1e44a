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

/// Trees that organize themselves, metamer by metamer, in the competition of their buds for light and room.
struct Organize : GrowingComponent {
  OrganizeParameters growth;               ///< without its operations
  std::optional<SkeletonSource> skeleton;  ///< what stands already; unset: seeds alone
  OrganizeLight light;
  std::optional<Training> training;
  std::vector<AnyOperation> operations;
  std::vector<Vec3> roots{Vec3(0)};  ///< where the trees stand, in the component's frame
  int leaf_age = 1;
  double leaf_angle = radians(50);
  Surface surface;
  TrimMode trim = TrimMode::cut;  ///< what a body around its stems does to them
  /// The trees of `skeleton`, in the component's frame, with all radii above 0.
  std::shared_ptr<const std::vector<Skeleton>> standing{};
};

ComponentType organize_component();

}  // namespace meristem
