// SPDX-License-Identifier: Apache-2.0
// Where the nodes of a forest stand when it is drawn as a tree: parents above their children, in the middle between the
// first and the last of them, children in their order, no two subtrees over each other.
//
// Based on: E. Reingold, J. Tilford: Tidier drawings of trees (1981).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace meristem {

/// In place of a parent's number.
inline constexpr std::uint32_t kNoParent = 0xffffffffU;

struct TreePlaces {
  std::vector<double> across;        ///< centre of each node, in distances between neighbours, from 0 on
  std::vector<std::uint32_t> level;  ///< 0 for roots
  double breadth = 0;                ///< greatest of `across`
  std::uint32_t levels = 0;          ///< how many levels there are
};

/// `parents` has for each node the number of its parent, which is smaller than its own, or kNoParent. Children of one
/// parent stand in the order of their numbers. The cost grows with the nodes times the depth of the shallower of two
/// neighbouring subtrees.
TreePlaces place_tree(std::span<const std::uint32_t> parents);

}  // namespace meristem
