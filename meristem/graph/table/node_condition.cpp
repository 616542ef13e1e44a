// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/node_condition.h"

#include <algorithm>

namespace meristem {

const std::vector<std::string>& node_variables() {
  static const std::vector<std::string> names = {"order", "radius", "u", "height", "birth", "tip_distance"};
  return names;
}

float segment_length(const Skeleton& skeleton, NodeIndex node) {
  return skeleton.is_root(node) ? 0 : glm::distance(skeleton.position[node], skeleton.position[skeleton.parent[node]]);
}

float axis_length(const Skeleton& skeleton, std::span<const NodeIndex> nodes) {
  double length = 0;
  for (const NodeIndex node : nodes) length += segment_length(skeleton, node);
  return static_cast<float>(length);
}

std::vector<std::uint8_t> nodes_where(const Skeleton& skeleton, const Axes& axes, const Condition& condition,
                                      RandomKey key) {
  const std::size_t count = skeleton.node_count();
  const std::vector<float> tip = tip_distance(skeleton);
  std::vector<double> order(count), radius(count), u(count), height(count), birth(count), distance(count),
      result(count);
  for (AxisIndex a = 0; a < axes.count(); ++a) {
    const auto nodes = axes.of(a);
    const float whole = std::max(1e-20F, axis_length(skeleton, nodes));
    float arc = 0;
    for (const NodeIndex node : nodes) {
      arc += segment_length(skeleton, node);
      u[node] = arc / whole;
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    order[k] = skeleton.order[k];
    radius[k] = skeleton.radius[k];
    height[k] = skeleton.position[k].y;
    birth[k] = skeleton.birth[k];
    distance[k] = tip[k];
  }
  const double* const columns[] = {order.data(), radius.data(), u.data(), height.data(), birth.data(), distance.data()};
  std::vector<RandomKey> keys;
  if (condition.expression.is_random()) {
    for (std::size_t k = 0; k < count; ++k) keys.push_back(key.child(k));
  }
  condition.expression.evaluate(count, columns, keys, result.data());
  std::vector<std::uint8_t> holds(count);
  for (std::size_t k = 0; k < count; ++k) holds[k] = result[k] != 0 ? 1 : 0;
  return holds;
}

}  // namespace meristem
