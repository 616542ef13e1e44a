// SPDX-License-Identifier: Apache-2.0
// Removes inner nodes of branches in one pass from the roots: each node knows the length removed since the last kept
// node on its branch. Based on: see finish.h.
#include "meristem/plant/finish.h"
#include "meristem/plant/further_columns.h"

namespace meristem {
namespace {

/// Returns the child of each node that has exactly one child, and kNoNode for other nodes.
std::vector<NodeIndex> only_children(const Skeleton& skeleton) {
  std::vector<NodeIndex> child(skeleton.node_count(), kNoNode);
  std::vector<std::uint8_t> has_more(skeleton.node_count(), 0);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent == kNoNode) continue;
    has_more[parent] = child[parent] != kNoNode || has_more[parent] != 0 ? 1 : 0;
    child[parent] = has_more[parent] != 0 ? kNoNode : node;
  }
  return child;
}

}  // namespace

Skeleton decimate(const Skeleton& skeleton, double tolerance, double step) {
  return decimate(skeleton, tolerance, step, [](Vec3, Vec3) { return true; });
}

Skeleton decimate(const Skeleton& skeleton, double tolerance, double step, IsOpen is_open, TrackedNodes* tracked) {
  const double limit = tolerance - step / 2;
  const std::vector<NodeIndex> only_child = only_children(skeleton);
  // Length removed since the last kept node, up to this node.
  std::vector<double> removed_length(skeleton.node_count(), 0);
  std::vector<NodeIndex> kept(skeleton.node_count());  // new index of the nearest kept node toward the root
  const auto end = skeleton.extra.find(kEndColumn);
  const auto stays = [&](NodeIndex node) {
    return (end != skeleton.extra.end() && end->second[node] != 0) ||
           (tracked != nullptr && !tracked->stays.empty() && tracked->stays[node] != 0);
  };
  if (tracked != nullptr) tracked->now.assign(skeleton.node_count(), kNoNode);
  Skeleton result;
  for (const auto& [name, values] : skeleton.extra) result.extra[name];
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    // Remove an inner node if the removed length stays short and the way past it is free.
    if (parent != kNoNode && only_child[node] != kNoNode && !stays(node)) {
      const double length = removed_length[parent] + glm::distance(skeleton.position[parent], skeleton.position[node]);
      if (length < limit && is_open(result.position[kept[parent]], skeleton.position[only_child[node]])) {
        removed_length[node] = length;
        kept[node] = kept[parent];
        continue;
      }
    }
    // Keep all other nodes and join each to the nearest kept node toward the root.
    kept[node] =
        result.add_node(parent == kNoNode ? kNoNode : kept[parent], skeleton.position[node], skeleton.birth[node]);
    result.radius.back() = skeleton.radius[node];
    result.axis.back() = skeleton.axis[node];
    result.order.back() = skeleton.order[node];
    for (auto& [name, values] : result.extra) values.back() = skeleton.extra.find(name)->second[node];
    if (tracked != nullptr) tracked->now[node] = kept[node];
  }
  return result;
}

}  // namespace meristem
