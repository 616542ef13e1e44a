// SPDX-License-Identifier: Apache-2.0
// Names of axes that stay valid while the plant grows. A label is the path of metamer numbers at which axes branch off,
// from the main axis to the named one.
#include "meristem/plant/axis_labels.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace meristem {
namespace {

constexpr float kLastExactFloat = 16'777'216;  // the largest n up to which floats represent every whole number

/// Returns the suffix of a label after `earlier` axes with the same number: empty for 0, then b to z, aa, ab, ...
std::string letters(std::uint32_t earlier) {
  if (earlier == 0) return {};
  std::string text;
  for (std::uint32_t rest = earlier + 1; rest > 0; rest = (rest - 1) / 26) {
    text += static_cast<char>('a' + (rest - 1) % 26);
  }
  std::reverse(text.begin(), text.end());
  return text;
}

}  // namespace

std::vector<std::uint32_t> axis_numbers(const Skeleton& skeleton) {
  const auto column = skeleton.extra.find(kMetamerColumn);
  const float* const metamer = column == skeleton.extra.end() ? nullptr : column->second.data();
  std::vector<std::uint32_t> numbers(skeleton.node_count(), 0);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (metamer != nullptr && metamer[node] >= 1 && metamer[node] <= kLastExactFloat &&
        std::floor(metamer[node]) == metamer[node]) {
      numbers[node] = static_cast<std::uint32_t>(metamer[node]);
    } else if (!skeleton.is_root(node)) {
      const NodeIndex parent = skeleton.parent[node];
      numbers[node] = skeleton.axis[node] == skeleton.axis[parent] ? numbers[parent] + 1 : 1;
    }
  }
  return numbers;
}

std::vector<std::string> axis_labels(const Skeleton& skeleton) {
  std::vector<std::string> labels;
  for (ShootName& name : shoot_names(skeleton, {})) labels.push_back(std::move(name.label));
  return labels;
}

std::vector<ShootName> shoot_names(const Skeleton& skeleton, const std::vector<std::uint32_t>& part_of_axis) {
  const std::vector<std::uint32_t> numbers = axis_numbers(skeleton);
  std::vector<ShootName> names(skeleton.axis_count());
  for (AxisIndex axis = 0; axis < names.size() && !part_of_axis.empty(); ++axis) names[axis].part = part_of_axis[axis];
  std::unordered_map<std::uint64_t, std::uint32_t> borne;  // number of earlier axes, by parent axis and node number
  std::unordered_map<std::uint32_t, std::uint32_t> trees;  // number of trees in each part
  // The first axis of each part that stands on another part.
  std::unordered_map<std::uint32_t, AxisIndex> main_of_joint;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const AxisIndex axis = skeleton.axis[node];
    ShootName& name = names[axis];
    if (!name.label.empty()) continue;
    if (skeleton.is_root(node)) {
      name.label = "main";
      name.tree = trees[name.part]++;
      continue;
    }
    const NodeIndex bearer = skeleton.parent[node];
    AxisIndex parent = skeleton.axis[bearer];
    std::uint32_t number = numbers[bearer];
    if (names[parent].part != name.part) {
      // A part that stands on another part has no root of its own: its root was replaced by the node that bears it.
      const auto [found, is_first] = main_of_joint.try_emplace(name.part, axis);
      if (is_first) {
        name.label = "main";
        continue;
      }
      parent = found->second;
      number = 0;
    }
    const std::uint32_t earlier = borne[std::uint64_t{parent} << 32U | number]++;
    name.label = names[parent].label + '.' + std::to_string(number) + letters(earlier);
    name.tree = names[parent].tree;
  }
  return names;
}

std::vector<NodeIndex> shoot_nodes(const Skeleton& skeleton, AxisIndex axis) {
  std::vector<NodeIndex> nodes;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.axis[node] != axis) continue;
    if (nodes.empty() && !skeleton.is_root(node)) nodes.push_back(skeleton.parent[node]);
    nodes.push_back(node);
  }
  return nodes;
}

}  // namespace meristem
