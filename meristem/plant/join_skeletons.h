// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// Returns all trees as one skeleton, one after another, like repeated calls of Skeleton::append(). Axis numbers
/// continue from tree to tree. A column that a tree lacks is 0 on its nodes. Cost: linear in the nodes, for any number
/// of trees.
Skeleton join_skeletons(std::vector<Skeleton> trees);

}  // namespace meristem
