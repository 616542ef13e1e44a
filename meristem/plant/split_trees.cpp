// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/split_trees.h"

#include <cstdint>

namespace meristem {

std::vector<Skeleton> split_trees(const Skeleton& skeleton) {
  std::vector<Skeleton> trees;
  std::vector<std::uint32_t> tree(skeleton.node_count());       // index of each node's tree
  std::vector<NodeIndex> renumbered(skeleton.node_count());     // index of each node in its tree
  std::vector<AxisIndex> axes(skeleton.node_count(), kNoNode);  // new number of each old axis
  std::vector<AxisIndex> axis_count;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent == kNoNode) {
      tree[node] = static_cast<std::uint32_t>(trees.size());
      Skeleton& made = trees.emplace_back();
      for (const auto& [name, values] : skeleton.extra) made.extra[name];
      axis_count.push_back(0);
    } else {
      tree[node] = tree[parent];
    }
    Skeleton& to = trees[tree[node]];
    const NodeIndex added =
        to.add_node(parent == kNoNode ? kNoNode : renumbered[parent], skeleton.position[node], skeleton.birth[node]);
    renumbered[node] = added;
    AxisIndex& axis = axes.at(skeleton.axis[node]);
    if (axis == kNoNode) axis = axis_count[tree[node]]++;
    to.axis[added] = axis;
    to.order[added] = skeleton.order[node];
    to.radius[added] = skeleton.radius[node];
    for (auto& [name, values] : to.extra) values[added] = skeleton.extra.find(name)->second[node];
  }
  return trees;
}

}  // namespace meristem
