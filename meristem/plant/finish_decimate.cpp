// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/finish.h"

namespace meristem {
namespace {

std::vector<std::uint32_t> count_children(const Skeleton& skeleton) {
  std::vector<std::uint32_t> count(skeleton.node_count(), 0);
  for (const NodeIndex parent : skeleton.parent) {
    if (parent != kNoNode) ++count[parent];
  }
  return count;
}

}  // namespace

Skeleton decimate(const Skeleton& skeleton, double tolerance, double step) {
  const double limit = tolerance - step / 2;
  const std::vector<std::uint32_t> children = count_children(skeleton);
  std::vector<double> removed_length(skeleton.node_count(), 0);  // since the last kept node, this one included
  std::vector<NodeIndex> kept(skeleton.node_count());            // new index of the nearest kept node toward the root
  Skeleton result;
  for (const auto& [name, values] : skeleton.extra) result.extra[name];
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    // Drop an inner node while its stretch of removed nodes stays short.
    if (parent != kNoNode && children[node] == 1) {
      const double length = removed_length[parent] + glm::distance(skeleton.position[parent], skeleton.position[node]);
      if (length < limit) {
        removed_length[node] = length;
        kept[node] = kept[parent];
        continue;
      }
    }
    // Keep all others, under the nearest kept node before them.
    kept[node] =
        result.add_node(parent == kNoNode ? kNoNode : kept[parent], skeleton.position[node], skeleton.birth[node]);
    for (auto& [name, values] : result.extra) values.back() = skeleton.extra.find(name)->second[node];
  }
  return result;
}

}  // namespace meristem
