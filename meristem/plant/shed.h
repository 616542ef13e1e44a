// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// Returns the skeleton without the branches whose first node is marked, and without everything that grows on them. A
/// branch is a lateral axis. Marks on other nodes have no effect, so stems stay. The column `shed` counts the tips lost
/// at each remaining node, including earlier losses. `marked` has one entry per node. Axes and orders must be assigned.
Skeleton shed_branches(const Skeleton& skeleton, std::span<const std::uint8_t> marked);

}  // namespace meristem
