// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/join_skeletons.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace meristem {

Skeleton join_skeletons(std::vector<Skeleton> trees) {
  std::erase_if(trees, [](const Skeleton& tree) { return tree.node_count() == 0; });
  if (trees.empty()) return {};
  if (trees.size() == 1) return std::move(trees[0]);
  std::size_t nodes = 0;
  Skeleton all;
  for (const Skeleton& tree : trees) {
    nodes += tree.node_count();
    for (const auto& [name, values] : tree.extra) all.extra[name];
  }
  all.reserve(nodes);
  const auto join = [](auto& column, const auto& rest) { column.insert(column.end(), rest.begin(), rest.end()); };
  AxisIndex axes = 0;
  for (Skeleton& tree : trees) {
    const auto first = static_cast<NodeIndex>(all.node_count());
    const AxisIndex first_axis = axes;
    for (NodeIndex& node : tree.parent) node = node == kNoNode ? kNoNode : first + node;
    for (AxisIndex& axis : tree.axis) {
      axis += first_axis;
      axes = std::max(axes, axis + 1);
    }
    join(all.parent, tree.parent);
    join(all.position, tree.position);
    join(all.radius, tree.radius);
    join(all.axis, tree.axis);
    join(all.order, tree.order);
    join(all.birth, tree.birth);
    all.operations.append(tree.operations);
    for (auto& [name, column] : all.extra) {
      const auto own = tree.extra.find(name);
      if (own != tree.extra.end()) join(column, own->second);
      column.resize(all.node_count(), 0);
    }
    tree = {};
  }
  return all;
}

}  // namespace meristem
