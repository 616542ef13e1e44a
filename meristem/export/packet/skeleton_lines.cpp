// SPDX-License-Identifier: Apache-2.0
// Selects the nodes of skeletons to draw as lines. The minimum radius is the radius of the node at rank `max_nodes`,
// found by partial sorting.
#include "meristem/export/packet/skeleton_lines.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace meristem {

SkeletonLines skeleton_lines(const Skeleton& skeleton, float min_radius) {
  SkeletonLines lines;
  std::vector<std::uint32_t> number(skeleton.node_count(), kNoNode);  // index among the drawn nodes
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (skeleton.radius[node] < min_radius || (parent != kNoNode && number[parent] == kNoNode)) continue;
    number[node] = static_cast<std::uint32_t>(lines.positions.size());
    lines.positions.push_back(skeleton.position[node]);
    lines.orders.push_back(static_cast<std::uint8_t>(std::min<std::uint16_t>(skeleton.order[node], 255)));
    lines.radii.push_back(skeleton.radius[node]);
    if (parent != kNoNode) lines.segments.insert(lines.segments.end(), {number[parent], number[node]});
  }
  return lines;
}

float min_drawn_radius(const std::vector<const Skeleton*>& skeletons, std::size_t max_nodes) {
  std::vector<float> radii;
  for (const Skeleton* skeleton : skeletons)
    radii.insert(radii.end(), skeleton->radius.begin(), skeleton->radius.end());
  if (radii.size() <= max_nodes) return 0;
  if (max_nodes == 0) return std::numeric_limits<float>::infinity();
  const auto last = radii.begin() + static_cast<std::ptrdiff_t>(max_nodes - 1);
  std::nth_element(radii.begin(), last, radii.end(), std::greater<>());
  // Many more twigs may have this radius than fit. Then draw only thicker nodes.
  const float radius = *last;
  const auto as_thick =
      static_cast<std::size_t>(std::count_if(radii.begin(), radii.end(), [&](float other) { return other >= radius; }));
  return as_thick <= max_nodes + max_nodes / 4 ? radius
                                               : std::nextafter(radius, std::numeric_limits<float>::infinity());
}

}  // namespace meristem
