// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// The skeleton without the branches whose first node is marked, nor what grows on them. A branch is a lateral axis;
/// marks on other nodes mean nothing, so stems stay. The column `shed` says how many tips were lost at each node that
/// stayed, on top of those lost there before. `marked` has one entry per node; axes and orders are assigned.
Skeleton shed_branches(const Skeleton& skeleton, std::span<const std::uint8_t> marked);

}  // namespace meristem
