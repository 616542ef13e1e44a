// SPDX-License-Identifier: Apache-2.0
// Computes where the nodes of a forest stand in a drawing. Parents stand above the middle of their first and last
// child, children keep their order, and subtrees do not overlap.
//
// Based on: E. Reingold, J. Tilford: Tidier drawings of trees (1981).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace meristem {

/// Marks a node without a parent.
inline constexpr std::uint32_t kNoParent = 0xffffffffU;

struct TreePlaces {
  std::vector<double> across;        ///< centre of each node, from 0; neighbours have distance 1
  std::vector<std::uint32_t> level;  ///< 0 for roots
  double breadth = 0;                ///< maximum of `across`
  std::uint32_t levels = 0;          ///< number of levels
};

/// Places the nodes of a forest. `parents` has for each node the number of its parent, which must be smaller than the
/// node's own number, or kNoParent. Children of one parent stand in the order of their numbers. The cost is the number
/// of nodes times the depth of the shallower of two neighbouring subtrees.
TreePlaces place_tree(std::span<const std::uint32_t> parents);

}  // namespace meristem
