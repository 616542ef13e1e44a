// SPDX-License-Identifier: Apache-2.0
// A skeleton as lines to draw, the thickest first where there are too many.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

struct SkeletonLines {
  std::vector<Vec3> positions;          ///< of the nodes that are drawn
  std::vector<std::uint32_t> segments;  ///< two nodes each: the lower and the upper end
  std::vector<std::uint8_t> orders;     ///< of each node, at most 255
  std::vector<float> radii;             ///< of each node
};

/// Nodes at least this thick whose ancestors all are too.
SkeletonLines skeleton_lines(const Skeleton& skeleton, float least_radius);

/// The radius from which on the skeletons together have at most about `most_nodes`; 0 where all may be drawn.
float least_drawn_radius(const std::vector<const Skeleton*>& skeletons, std::size_t most_nodes);

}  // namespace meristem
