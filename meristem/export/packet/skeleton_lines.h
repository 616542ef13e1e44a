// SPDX-License-Identifier: Apache-2.0
// A skeleton as lines to draw, only the thickest if there are too many.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

struct SkeletonLines {
  std::vector<Vec3> positions;          ///< positions of the drawn nodes
  std::vector<std::uint32_t> segments;  ///< two nodes each: the lower and the upper end
  std::vector<std::uint8_t> orders;     ///< for each node, at most 255
  std::vector<float> radii;             ///< for each node
};

/// Returns the nodes that are at least this thick and whose ancestors all are as well.
SkeletonLines skeleton_lines(const Skeleton& skeleton, float min_radius);

/// Returns a radius. At most about `max_nodes` nodes of the skeletons together are at least this thick. Returns 0 if
/// all nodes may be drawn.
float min_drawn_radius(const std::vector<const Skeleton*>& skeletons, std::size_t max_nodes);

}  // namespace meristem
