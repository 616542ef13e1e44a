// SPDX-License-Identifier: Apache-2.0
// Removes branches in one pass, because a node comes after its parent. See shed.h.
#include "meristem/plant/shed.h"

#include <map>
#include <string>
#include <vector>

#include "meristem/plant/further_columns.h"
#include "meristem/plant/pipe_radii.h"

namespace meristem {
namespace {

/// Returns the new index of each node, and kNoNode for removed nodes.
std::vector<NodeIndex> place_survivors(const Skeleton& skeleton, std::span<const std::uint8_t> marked) {
  std::vector<NodeIndex> place(skeleton.node_count(), kNoNode);
  NodeIndex survivors = 0;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    const bool begins_branch = parent != kNoNode && skeleton.axis[node] != skeleton.axis[parent];
    const bool is_shed = parent != kNoNode && (place[parent] == kNoNode || (begins_branch && marked[node] != 0));
    if (!is_shed) place[node] = survivors++;
  }
  return place;
}

}  // namespace

Skeleton shed_branches(const Skeleton& skeleton, std::span<const std::uint8_t> marked) {
  const std::vector<NodeIndex> place = place_survivors(skeleton, marked);
  const auto before = skeleton.extra.find(kShedColumn);
  const std::vector<double> tips =
      count_tips(skeleton.parent, before == skeleton.extra.end() ? std::span<const float>() : before->second);
  Skeleton kept;
  std::vector<float>& lost = kept.extra[std::string(kShedColumn)];
  for (const auto& [name, values] : skeleton.extra) kept.extra[name];
  std::map<AxisIndex, AxisIndex> axes;  // new numbers of the axes that stay
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (place[node] == kNoNode) {
      // The node that bore a shed branch counts the lost tips.
      if (parent != kNoNode && place[parent] != kNoNode) {
        lost[place[parent]] += static_cast<float>(tips[node]);
      }
      continue;
    }
    const NodeIndex copy =
        kept.add_node(parent == kNoNode ? kNoNode : place[parent], skeleton.position[node], skeleton.birth[node]);
    kept.radius[copy] = skeleton.radius[node];
    kept.order[copy] = skeleton.order[node];
    kept.axis[copy] = axes.try_emplace(skeleton.axis[node], static_cast<AxisIndex>(axes.size())).first->second;
    for (const auto& [name, values] : skeleton.extra) kept.extra[name][copy] = values[node];
  }
  return kept;
}

}  // namespace meristem
