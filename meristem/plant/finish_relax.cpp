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
  // Children before parents, so that every parent still stands at its old position when it is read. The source's
  // equation 3.21 takes half the distance times the vector to the parent; half the vector is meant.
  //
  // From where a node stood, its children are reached wherever they come to stand: at their old position or half way
  // there. So it is enough that each node moves only where it reaches them from its new one.
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
