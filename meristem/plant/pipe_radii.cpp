// SPDX-License-Identifier: Apache-2.0
// The pipe law is r^n = sum of the children's r^n. With equal tips its solution is r = tip_radius * tips^(1/n), where
// `tips` is the number of tips at or beyond the node. Tips are whole numbers, so rounding errors do not accumulate
// toward the root. A node that does not fork has exactly the radius of its child.
#include "meristem/plant/pipe_radii.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <stdexcept>

#include "meristem/base/math.h"
#include "meristem/plant/further_columns.h"

namespace meristem {
std::vector<double> count_tips(std::span<const NodeIndex> parent, std::span<const float> lost, double memory) {
  std::vector<double> tips(parent.size(), 0);
  for (std::size_t node = parent.size(); node-- > 0;) {
    const bool bears = tips[node] > 0;
    if (!lost.empty()) tips[node] += memory * lost[node];
    if (!bears) tips[node] = std::max(tips[node], 1.0);
    if (parent[node] != kNoNode) tips[parent[node]] += tips[node];
  }
  return tips;
}

std::vector<float> pipe_radii(std::span<const NodeIndex> parent, std::span<const float> lost, const PipeModel& model) {
  if (!(model.tip_radius > 0 && model.exponent > 0))
    throw std::invalid_argument("pipe model: tip radius and exponent must be above 0");
  const std::vector<double> tips = count_tips(parent, lost, model.memory);
  std::vector<float> radius(parent.size());
  // Parents come first, and most nodes continue their parent without a fork.
  for (NodeIndex node = 0; node < parent.size(); ++node) {
    if (parent[node] != kNoNode && tips[node] == tips[parent[node]]) {
      radius[node] = radius[parent[node]];
    } else {
      radius[node] = static_cast<float>(model.tip_radius * math::pow(tips[node], 1 / model.exponent));
    }
  }
  return radius;
}

void assign_pipe_radii(Skeleton& skeleton, const PipeModel& model) {
  const auto shed = skeleton.extra.find(kShedColumn);
  const std::span<const float> lost = shed == skeleton.extra.end() ? std::span<const float>() : shed->second;
  skeleton.radius = pipe_radii(skeleton.parent, lost, model);
}

void assign_axes(Skeleton& skeleton) {
  // Find, for each node, the child that continues its axis.
  std::vector<NodeIndex> heir(skeleton.node_count(), kNoNode);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent == kNoNode) continue;
    if (heir[parent] == kNoNode || skeleton.radius[node] > skeleton.radius[heir[parent]]) heir[parent] = node;
  }
  // Continue the parent's axis in that child, and begin new axes in the others.
  AxisIndex axes = 0;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent != kNoNode && heir[parent] == node) {
      skeleton.axis[node] = skeleton.axis[parent];
      skeleton.order[node] = skeleton.order[parent];
    } else {
      assert(parent == kNoNode || skeleton.order[parent] < std::numeric_limits<std::uint16_t>::max());
      skeleton.axis[node] = axes++;
      skeleton.order[node] =
          parent == kNoNode ? std::uint16_t{0} : static_cast<std::uint16_t>(skeleton.order[parent] + 1);
    }
  }
}

}  // namespace meristem
