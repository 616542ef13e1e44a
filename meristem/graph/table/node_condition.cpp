// SPDX-License-Identifier: Apache-2.0
// Evaluates conditions over the nodes of a skeleton. The expression is evaluated for all nodes together; each variable
// is a column of numbers. Columns that few conditions need are computed only if the expression uses them.
#include "meristem/graph/table/node_condition.h"

#include <algorithm>

#include "meristem/base/math.h"
#include "meristem/graph/table/node_light.h"

namespace meristem {

namespace {

/// Indices of the variables that only some skeletons have.
enum : std::size_t { kRank = 6, kInclination, kMetamer, kBudAge, kLight, kMarked, kFruit, kWound };

/// Returns the inclination of the segment that ends in each node, degrees above the horizontal.
std::vector<double> inclinations(const Skeleton& skeleton) {
  std::vector<double> angles(skeleton.node_count(), 90);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const float length = segment_length(skeleton, node);
    if (length == 0) continue;
    const double rise = (skeleton.position[node].y - skeleton.position[skeleton.parent[node]].y) / length;
    angles[node] = degrees(math::asin(std::clamp(rise, -1.0, 1.0)));
  }
  return angles;
}

/// Returns the number of growth steps since each node grew.
std::vector<double> ages(const Skeleton& skeleton) {
  const float last = skeleton.birth.empty() ? 0 : *std::ranges::max_element(skeleton.birth);
  std::vector<double> ages;
  for (const float birth : skeleton.birth) ages.push_back(last - birth);
  return ages;
}

}  // namespace

const std::vector<std::string>& node_variables() {
  static const std::vector<std::string> names = {"order",        "radius", "u",           "height",  "birth",
                                                 "tip_distance", "rank",   "inclination", "metamer", "bud_age",
                                                 "light",        "marked", "fruit",       "wound"};
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

std::vector<std::uint8_t> nodes_where(const Skeleton& skeleton, const SkeletonAxes& axes,
                                      const SiteCondition& condition, RandomKey key, const Scene* scene) {
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
  // Quantities that only some models of growth have are computed only if the condition uses them.
  const auto column = [&](const char* name) {
    const auto found = skeleton.extra.find(name);
    return found == skeleton.extra.end() ? std::vector<double>(count, 0)
                                         : std::vector<double>(found->second.begin(), found->second.end());
  };
  std::vector<std::vector<double>> more(node_variables().size());
  for (std::size_t k = kRank; k < more.size(); ++k) {
    if (!condition.expression.uses(k)) continue;
    if (k == kRank) more[k] = skeleton.extra.count("rank") != 0 ? column("rank") : order;
    if (k == kInclination) more[k] = inclinations(skeleton);
    if (k == kMetamer) more[k] = column("metamer");
    if (k == kBudAge) more[k] = ages(skeleton);
    if (k == kLight && (scene == nullptr || skeleton.extra.count("light") != 0)) more[k] = column("light");
    if (k == kLight && more[k].empty()) {
      const std::vector<float> light = light_at_nodes(skeleton, *scene);
      more[k].assign(light.begin(), light.end());
    }
    if (k == kMarked) more[k] = column("marked");
    if (k == kFruit) more[k] = column("fruit");
    if (k == kWound) more[k] = column("wound");
  }
  std::vector<const double*> columns = {order.data(),  radius.data(), u.data(),
                                        height.data(), birth.data(),  distance.data()};
  for (std::size_t k = kRank; k < more.size(); ++k) columns.push_back(more[k].empty() ? nullptr : more[k].data());
  std::vector<RandomKey> keys;
  if (condition.expression.is_random()) {
    for (std::size_t k = 0; k < count; ++k) keys.push_back(key.child(k));
  }
  condition.expression.evaluate(count, columns, keys, result.data());
  std::vector<std::uint8_t> holds(count);
  for (std::size_t k = 0; k < count; ++k) holds[k] = is_true(result[k]) ? 1 : 0;
  return holds;
}

}  // namespace meristem
