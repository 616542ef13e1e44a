// SPDX-License-Identifier: Apache-2.0
// Computes Strahler numbers and counts streams. Nodes are visited from the tips to the root, so that the children of a
// node have their numbers before the node.
//
// Based on: A. N. Strahler, Quantitative analysis of watershed geomorphology, 1957, as botanists use it for branches.
#include "meristem/measure/strahler.h"

#include <algorithm>
#include <stdexcept>

#include "meristem/base/math.h"

namespace meristem {

std::vector<std::uint8_t> strahler_numbers(const Skeleton& skeleton, const NodeChildren& children) {
  // A number of k needs 2^(k-1) tips, so a byte holds it.
  std::vector<std::uint8_t> numbers(skeleton.node_count(), 1);
  for (std::size_t node = skeleton.node_count(); node-- > 0;) {
    std::uint8_t largest = 0;
    int sharing = 0;
    for (const NodeIndex child : children.of(static_cast<NodeIndex>(node))) {
      if (numbers[child] > largest) {
        largest = numbers[child];
        sharing = 0;
      }
      if (numbers[child] == largest) ++sharing;
    }
    if (largest > 0) numbers[node] = static_cast<std::uint8_t>(largest + (sharing > 1 ? 1 : 0));
  }
  return numbers;
}

std::vector<std::uint64_t> strahler_streams(const Skeleton& skeleton, std::span<const std::uint8_t> numbers) {
  std::vector<std::uint64_t> streams;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (!skeleton.is_root(node) && numbers[skeleton.parent[node]] == numbers[node]) continue;
    if (streams.size() < numbers[node]) streams.resize(numbers[node], 0);
    ++streams[numbers[node] - 1U];
  }
  return streams;
}

std::vector<double> bifurcation_ratios(std::span<const std::uint64_t> streams) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k + 1 < streams.size(); ++k) {
    ratios.push_back(static_cast<double>(streams[k]) / static_cast<double>(streams[k + 1]));
  }
  return ratios;
}

double mean_bifurcation_ratio(std::span<const std::uint64_t> streams) {
  if (streams.size() < 2) throw std::invalid_argument("a bifurcation ratio needs streams of two numbers");
  const double whole = static_cast<double>(streams.front()) / static_cast<double>(streams.back());
  return math::pow(whole, 1 / static_cast<double>(streams.size() - 1));
}

}  // namespace meristem
