// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// All trees as one skeleton, one after another, as Skeleton::append() joins two: axes are numbered on, and columns
/// that only some have are 0 on the others. Takes a look at each node once, however many trees there are.
Skeleton join_skeletons(std::vector<Skeleton> trees);

}  // namespace meristem
