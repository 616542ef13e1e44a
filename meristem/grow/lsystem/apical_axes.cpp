// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/apical_axes.h"

#include <algorithm>
#include <limits>

#include "meristem/base/frame.h"

namespace meristem {

namespace {

constexpr int kHighestOrder = std::numeric_limits<std::uint16_t>::max();

Vec3 direction_to(const Skeleton& skeleton, NodeIndex node) {
  if (skeleton.is_root(node)) return Vec3(0);
  return normalized_or(skeleton.position[node] - skeleton.position[skeleton.parent[node]], Vec3(0));
}

/// Returns the cosine of the angle between the segment of a node and the segment of its parent.
float straightness(const Skeleton& skeleton, NodeIndex node) {
  return glm::dot(direction_to(skeleton, skeleton.parent[node]), direction_to(skeleton, node));
}

/// Returns true if `child` continues its parent's axis rather than `other`, an earlier child.
bool is_stronger(const Skeleton& skeleton, const std::vector<std::uint8_t>& begins_branch, NodeIndex child,
                 NodeIndex other) {
  if (begins_branch[child] != begins_branch[other]) return begins_branch[child] == 0;
  if (skeleton.radius[child] != skeleton.radius[other]) return skeleton.radius[child] > skeleton.radius[other];
  return begins_branch[child] != 0 && straightness(skeleton, child) > straightness(skeleton, other);
}

}  // namespace

void assign_apical_axes(Skeleton& skeleton, const std::vector<std::uint8_t>& begins_branch) {
  const auto nodes = static_cast<NodeIndex>(skeleton.node_count());
  std::vector<NodeIndex> heir(nodes, kNoNode);  // by parent
  for (NodeIndex node = 0; node < nodes; ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent == kNoNode) continue;
    if (heir[parent] == kNoNode || is_stronger(skeleton, begins_branch, node, heir[parent])) heir[parent] = node;
  }
  AxisIndex axes = 0;
  for (NodeIndex node = 0; node < nodes; ++node) {
    const NodeIndex parent = skeleton.parent[node];
    const bool continues = parent != kNoNode && heir[parent] == node;
    skeleton.axis[node] = continues ? skeleton.axis[parent] : axes++;
    const int order = parent == kNoNode ? 0 : skeleton.order[parent] + (continues ? 0 : 1);
    skeleton.order[node] = static_cast<std::uint16_t>(std::min(order, kHighestOrder));
  }
}

}  // namespace meristem
