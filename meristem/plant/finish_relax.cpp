// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <utility>
#include <vector>

#include "meristem/plant/finish.h"

namespace meristem {

void relax_angles(Skeleton& skeleton) {
  relax_angles(skeleton, [](Vec3, Vec3) { return true; });
}

void relax_angles(Skeleton& skeleton, IsOpen is_open) {
  // Children before parents, so that every parent still has its old position when a child reads it. Equation 3.21 of
  // the source takes half the distance times the vector to the parent, but it means half the vector.
  //
  // Obstacles: the way from a node's old position to each child is free, both to the child's old position and to its
  // new one. It is therefore enough to test the ways to the children from the node's new position. A node that fails
  // the test keeps its position.
  std::vector<Vec3> moved(skeleton.position);
  std::vector<std::uint8_t> stays(skeleton.node_count(), 0);
  const auto relaxed = [&](std::size_t node, NodeIndex parent) {
    return 0.5F * (skeleton.position[node] + skeleton.position[parent]);
  };
  for (std::size_t node = skeleton.node_count(); node-- > 0;) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent == kNoNode) continue;
    if (stays[node] == 0) moved[node] = relaxed(node, parent);
    const NodeIndex above = skeleton.parent[parent];
    if (above != kNoNode && stays[parent] == 0 && !is_open(relaxed(parent, above), moved[node])) stays[parent] = 1;
  }
  skeleton.position = std::move(moved);
}

}  // namespace meristem
