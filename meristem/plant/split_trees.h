// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// One skeleton for each root, in the order of the roots; axes are numbered anew from 0, all else stays. A skeleton
/// with one root comes back as a copy.
std::vector<Skeleton> split_trees(const Skeleton& skeleton);

}  // namespace meristem
