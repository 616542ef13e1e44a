// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// Sets `axis` and `order` of a skeleton whose branches are given by the brackets of a word. The child that does not
/// begin a branch continues its parent's axis. If all children begin branches, the child with the largest radius
/// continues it (ties: the straightest, then the lowest index). All other children start an axis of the next order.
/// `begins_branch` has one entry per node.
void assign_apical_axes(Skeleton& skeleton, const std::vector<std::uint8_t>& begins_branch);

}  // namespace meristem
