// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/plant.h"

#include <algorithm>

namespace meristem {

std::uint32_t Stem::individual() const {
  if (individual_of_root.empty()) return 0;
  const auto is_first = [this](std::uint32_t individual) { return individual == individual_of_root[0]; };
  return std::ranges::all_of(individual_of_root, is_first) ? individual_of_root[0] : kNoIndividual;
}

std::vector<std::uint32_t> Stem::individual_of_axis() const {
  std::vector<std::uint32_t> of_node(skeleton.node_count());
  std::vector<std::uint32_t> of_axis;
  std::size_t roots = 0;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const bool is_root = skeleton.is_root(node);
    const std::size_t root = is_root ? roots++ : 0;
    of_node[node] = !is_root                           ? of_node[skeleton.parent[node]]
                    : root < individual_of_root.size() ? individual_of_root[root]
                                                       : 0;
    if (of_axis.size() <= skeleton.axis[node]) of_axis.resize(skeleton.axis[node] + 1, of_node[node]);
    of_axis[skeleton.axis[node]] = of_node[node];
  }
  return of_axis;
}

std::uint64_t Plant::node_count() const {
  std::uint64_t nodes = 0;
  for (const Stem& stem : stems) nodes += stem.skeleton.node_count();
  return nodes;
}

}  // namespace meristem
