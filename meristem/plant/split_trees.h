// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// Returns one skeleton for each root, in the order of the roots. Axes are renumbered from 0; everything else is
/// unchanged. Returns a copy if the skeleton has one root.
std::vector<Skeleton> split_trees(const Skeleton& skeleton);

}  // namespace meristem
