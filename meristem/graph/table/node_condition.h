// SPDX-License-Identifier: Apache-2.0
// Conditions over the nodes of a skeleton, as in `where` and `shed`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/graph/table/selection.h"
#include "meristem/plant/skeleton.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// Returns the variables of such conditions: order, radius, u (share of the axis's length from its base), height (y),
/// birth (growth step), tip_distance (to the farthest tip beyond), rank (0 for the leader, 1 for its branches; the
/// order if unknown), inclination (degrees above the horizontal), metamer (number on its axis), bud_age (growth steps
/// since the node grew), light, marked (1 on shoots that an operation has marked), fruit (1 where a lateral bud bears),
/// wound (radius of an open wound). Lengths are in metres. A quantity that the model of growth does not compute is 0.
const std::vector<std::string>& node_variables();

/// Returns for every node 1 if the condition holds, else 0. `axes` are the skeleton's; `key` seeds random functions. If
/// the skeleton has no light of its own, `light` is that of light_at_nodes() in `scene`; without a scene it is 0.
std::vector<std::uint8_t> nodes_where(const Skeleton& skeleton, const SkeletonAxes& axes,
                                      const SiteCondition& condition, RandomKey key, const Scene* scene = nullptr);

/// Returns the distance from a node's parent, metres. Returns 0 for roots.
float segment_length(const Skeleton& skeleton, NodeIndex node);
/// Returns the length of an axis from its parent node to its tip, metres.
float axis_length(const Skeleton& skeleton, std::span<const NodeIndex> nodes);

}  // namespace meristem
