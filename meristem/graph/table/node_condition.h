// SPDX-License-Identifier: Apache-2.0
// Conditions over the nodes of a skeleton, as in `where` and `shed`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/graph/table/selection.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// What such conditions may name: order, radius, u (share of the axis's length from its base), height (y), birth
/// (growth step), tip_distance (to the farthest tip beyond), rank (0 the leader, 1 its branches; where nobody knows
/// it, the order), inclination (degrees above the horizontal), metamer (number on its axis), bud_age (growth steps
/// since it grew), light, marked (1 on shoots that an operation has marked). Lengths in metres; 0 for what the model of
/// growth does not know.
const std::vector<std::string>& node_variables();

/// For every node 1 where the condition holds, else 0. `axes` are the skeleton's; `key` feeds random functions.
std::vector<std::uint8_t> nodes_where(const Skeleton& skeleton, const Axes& axes, const Condition& condition,
                                      RandomKey key);

/// Metres from a node's parent; 0 for roots.
float segment_length(const Skeleton& skeleton, NodeIndex node);
/// Metres from an axis's parent node to its tip.
float axis_length(const Skeleton& skeleton, std::span<const NodeIndex> nodes);

}  // namespace meristem
