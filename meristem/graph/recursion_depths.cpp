// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/recursion_depths.h"

#include <algorithm>
#include <cstddef>

namespace meristem {

bool leads_on(const Graph& graph, LinkIndex link, const RecursionDepths& depths) {
  const LinkStructure& structure = graph.structure;
  const auto is_at_end = [&](std::uint32_t recursion) {
    const LinkStructure::Recursion& found = structure.recursions[recursion];
    return depths[found.level] + 1 >= graph.components[found.head].base().recursion;
  };
  const std::uint32_t closed = structure.recursion_of_link[link];
  if (closed != kNoIndex) return !is_at_end(closed);
  if (!graph.links[link].is<LeafLink>()) return true;
  const std::uint32_t inside = structure.recursion_of[graph.links[link].from];
  return inside == kNoIndex || is_at_end(inside);
}

void count_depth(const LinkStructure& structure, LinkIndex link, ComponentIndex to, RecursionDepths& depths) {
  const std::uint32_t closed = structure.recursion_of_link[link];
  const std::uint32_t inside = structure.recursion_of[to];
  const auto begin_anew = [&](std::size_t level) {
    std::fill(depths.begin() + static_cast<std::ptrdiff_t>(level), depths.end(), 0);
  };
  if (closed != kNoIndex) {
    const std::size_t level = structure.recursions[closed].level;
    ++depths[level];
    begin_anew(level + 1);
  } else if (inside != kNoIndex && structure.recursions[inside].head == to) {
    begin_anew(structure.recursions[inside].level);
  }
}

}  // namespace meristem
