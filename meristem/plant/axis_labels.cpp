// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/axis_labels.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace meristem {
namespace {

constexpr float kLastExactFloat = 16'777'216;  // the last whole number up to which floats hold all

/// Nothing for the first of several, then b to z, aa, ab, ...
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
  const std::vector<std::uint32_t> numbers = axis_numbers(skeleton);
  std::vector<std::string> labels(skeleton.axis_count());
  std::unordered_map<std::uint64_t, std::uint32_t> borne;  // by axis and number of what bears them
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    std::string& label = labels[skeleton.axis[node]];
    if (!label.empty()) continue;
    if (skeleton.is_root(node)) {
      label = "main";
      continue;
    }
    const NodeIndex bearer = skeleton.parent[node];
    const AxisIndex parent = skeleton.axis[bearer];
    const std::uint32_t earlier = borne[std::uint64_t{parent} << 32U | numbers[bearer]]++;
    label = labels[parent] + '.' + std::to_string(numbers[bearer]) + letters(earlier);
  }
  return labels;
}

}  // namespace meristem
