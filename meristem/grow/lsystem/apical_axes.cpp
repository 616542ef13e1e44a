// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/apical_axes.h"

#include <algorithm>
#include <limits>

#include "meristem/base/frame.h"

namespace meristem {

namespace {

constexpr int kHighestOrder = std::numeric_limits<std::uint16_t>::max();

/// How much a child may call its parent's axis its own.
struct Claim {
  bool is_apical = false;
  float radius = 0;
  float straightness = -std::numeric_limits<float>::infinity();  // cosine of the turn
  NodeIndex child = kNoNode;
};

bool is_stronger(const Claim& a, const Claim& b) {
  if (b.child == kNoNode) return true;
  if (a.is_apical != b.is_apical) return a.is_apical;
  if (a.radius != b.radius) return a.radius > b.radius;
  return a.straightness > b.straightness;
}

Vec3 direction_to(const Skeleton& skeleton, NodeIndex node) {
  if (skeleton.is_root(node)) return Vec3(0);
  return normalized_or(skeleton.position[node] - skeleton.position[skeleton.parent[node]], Vec3(0));
}

}  // namespace

void assign_apical_axes(Skeleton& skeleton, const std::vector<std::uint8_t>& begins_branch) {
  const auto nodes = static_cast<NodeIndex>(skeleton.node_count());
  std::vector<Claim> heir(nodes);  // by parent
  for (NodeIndex node = 0; node < nodes; ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent == kNoNode) continue;
    Claim claim{.is_apical = begins_branch[node] == 0, .radius = skeleton.radius[node], .child = node};
    if (!claim.is_apical) {
      claim.straightness = glm::dot(direction_to(skeleton, parent), direction_to(skeleton, node));
    }
    if (is_stronger(claim, heir[parent])) heir[parent] = claim;
  }
  AxisIndex axes = 0;
  for (NodeIndex node = 0; node < nodes; ++node) {
    const NodeIndex parent = skeleton.parent[node];
    const bool continues = parent != kNoNode && heir[parent].child == node;
    skeleton.axis[node] = continues ? skeleton.axis[parent] : axes++;
    const int order = parent == kNoNode ? 0 : skeleton.order[parent] + (continues ? 0 : 1);
    skeleton.order[node] = static_cast<std::uint16_t>(std::min(order, kHighestOrder));
  }
}

}  // namespace meristem
