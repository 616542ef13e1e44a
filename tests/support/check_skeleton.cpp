// SPDX-License-Identifier: Apache-2.0
// Checks the invariants of skeletons node by node, and names the first node that breaks one.
#include "tests/support/check_skeleton.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace meristem {
namespace {

using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

constexpr float kShortestSegment = 1e-7F;  // metres

AssertionResult check_columns(const Skeleton& skeleton) {
  const std::size_t nodes = skeleton.node_count();
  const auto check = [nodes](const std::string& name, std::size_t entries) -> AssertionResult {
    if (entries == nodes) return AssertionSuccess();
    return AssertionFailure() << "column '" << name << "' has " << entries << " entries for " << nodes << " nodes";
  };
  if (AssertionResult result = check("position", skeleton.position.size()); !result) return result;
  if (AssertionResult result = check("radius", skeleton.radius.size()); !result) return result;
  if (AssertionResult result = check("axis", skeleton.axis.size()); !result) return result;
  if (AssertionResult result = check("order", skeleton.order.size()); !result) return result;
  if (AssertionResult result = check("birth", skeleton.birth.size()); !result) return result;
  for (const auto& [name, values] : skeleton.extra) {
    if (AssertionResult result = check(name, values.size()); !result) return result;
  }
  return AssertionSuccess();
}

/// Returns the error in a node's own numbers or its segment, or an empty text.
std::string error_of_node(const Skeleton& skeleton, NodeIndex node) {
  const Vec3 position = skeleton.position[node];
  const bool is_finite = std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z) &&
                         std::isfinite(skeleton.radius[node]) && std::isfinite(skeleton.birth[node]);
  if (!is_finite) return "has a number that is not finite";
  for (const auto& [name, values] : skeleton.extra) {
    if (!std::isfinite(values[node])) return fmt::format("has a '{}' that is not finite", name);
  }
  if (!(skeleton.radius[node] > 0)) return fmt::format("has radius {}", skeleton.radius[node]);
  const NodeIndex parent = skeleton.parent[node];
  if (parent == kNoNode) return {};
  if (parent >= node) return fmt::format("comes before its parent {}", parent);
  if (skeleton.radius[node] > skeleton.radius[parent]) {
    return fmt::format("has radius {}, above its parent's {}", skeleton.radius[node], skeleton.radius[parent]);
  }
  if (skeleton.birth[node] < skeleton.birth[parent]) {
    return fmt::format("is born at {}, before its parent at {}", skeleton.birth[node], skeleton.birth[parent]);
  }
  const float segment = glm::distance(position, skeleton.position[parent]);
  if (!(segment >= kShortestSegment)) return fmt::format("is {} m from its parent", segment);
  return {};
}

/// Returns the error in the axes up to this node, or an empty text. `last` is the last node of each axis so far.
std::string error_of_axis(const Skeleton& skeleton, NodeIndex node, std::vector<NodeIndex>& last) {
  const AxisIndex axis = skeleton.axis[node];
  const NodeIndex parent = skeleton.parent[node];
  if (axis > last.size()) return fmt::format("begins axis {} where {} is next", axis, last.size());
  if (axis < last.size()) {
    if (parent != last[axis]) return fmt::format("is on axis {}, but its parent is not that axis's last node", axis);
    if (skeleton.order[node] != skeleton.order[parent]) return "has another order than its axis";
    last[axis] = node;
    return {};
  }
  const int wanted = parent == kNoNode ? 0 : skeleton.order[parent] + 1;
  if (skeleton.order[node] != wanted) {
    return fmt::format("begins an axis of order {} where {} is due", skeleton.order[node], wanted);
  }
  last.push_back(node);
  return {};
}

}  // namespace

AssertionResult check_skeleton(const Skeleton& skeleton) {
  if (AssertionResult result = check_columns(skeleton); !result) return result;
  std::vector<NodeIndex> last;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    std::string error = error_of_node(skeleton, node);
    if (error.empty()) error = error_of_axis(skeleton, node, last);
    if (!error.empty()) return AssertionFailure() << "node " << node << " " << error;
  }
  return AssertionSuccess();
}

}  // namespace meristem
