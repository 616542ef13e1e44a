// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/graph/placement.h"

namespace meristem {

/// Passes the sites that place_along() returns to `receive`, one after another in lists of at most about 65,536 sites.
/// Few sites are in memory at once, however many a stem bears. Throws as place_along() does.
void place_in_parts(const Skeleton& skeleton, const BranchPlacement& placement, const PlacementContext& context,
                    FunctionRef<void(std::vector<Site>)> receive);

}  // namespace meristem
