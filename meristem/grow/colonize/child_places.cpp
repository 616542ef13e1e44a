// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/child_places.h"

namespace meristem {

void ChildPlaces::add_node(NodeIndex parent) {
  const auto node = static_cast<NodeIndex>(youngest_child_.size());
  youngest_child_.push_back(kNoNode);
  elder_sibling_.push_back(kNoNode);
  if (parent == kNoNode) return;
  elder_sibling_[node] = youngest_child_[parent];
  youngest_child_[parent] = node;
}

bool ChildPlaces::is_free(const Skeleton& skeleton, NodeIndex node, Vec3 place) const {
  const auto is_apart = [&](NodeIndex other) { return glm::distance(skeleton.position[other], place) >= closest_; };
  if (!is_apart(node)) return false;
  if (!skeleton.is_root(node) && !is_apart(skeleton.parent[node])) return false;
  for (NodeIndex child = youngest_child_[node]; child != kNoNode; child = elder_sibling_[child]) {
    if (!is_apart(child)) return false;
  }
  return true;
}

}  // namespace meristem
