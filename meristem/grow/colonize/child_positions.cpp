// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/child_positions.h"

namespace meristem {

void ChildPositions::add_node(NodeIndex parent) {
  const auto node = static_cast<NodeIndex>(youngest_child_.size());
  youngest_child_.push_back(kNoNode);
  elder_sibling_.push_back(kNoNode);
  if (parent == kNoNode) return;
  elder_sibling_[node] = youngest_child_[parent];
  youngest_child_[parent] = node;
}

bool ChildPositions::is_free(const Skeleton& skeleton, NodeIndex node, Vec3 position) const {
  const auto is_apart = [&](NodeIndex other) { return glm::distance(skeleton.position[other], position) >= closest_; };
  if (!is_apart(node)) return false;
  if (!skeleton.is_root(node) && !is_apart(skeleton.parent[node])) return false;
  for (NodeIndex child = youngest_child_[node]; child != kNoNode; child = elder_sibling_[child]) {
    if (!is_apart(child)) return false;
  }
  return true;
}

}  // namespace meristem
