// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meristem/base/point_tree.h"
#include "meristem/base/vec.h"

namespace meristem {

/// A tree of boxes, sorted by their centres, that finds the boxes around a position. Empty boxes contain no position.
class BoxTree {
 public:
  /// Throws std::invalid_argument for boxes that are not finite.
  explicit BoxTree(const std::vector<Box>& boxes = {});

  /// Returns true if `accepts(index)` returns true for any box that contains the position. Faces belong to their boxes.
  /// The order of calls is unspecified.
  template <class Accepts>
  bool any_around(Vec3 position, Accepts accepts) const;

 private:
  std::vector<NumberedPoint> middles_;  // centres of the boxes, in the tree's order
  PointTree tree_;
  std::vector<Box> boxes_;   // boxes, in the tree's order
  std::vector<Box> around_;  // bounds of the boxes below each node of the tree
};

template <class Accepts>
bool BoxTree::any_around(Vec3 position, Accepts accepts) const {
  struct Node {
    int level;
    std::uint32_t index;
  };
  // A stack with one entry per level suffices; there are no more than 2^32 boxes.
  Node waiting[34];
  int count = 0;
  waiting[count++] = {0, 0};
  while (count > 0) {
    const Node node = waiting[--count];
    if (!around_[PointTree::place(node.level, node.index)].holds(position)) continue;
    if (node.level < tree_.leaf_level()) {
      waiting[count++] = {node.level + 1, 2 * node.index};
      waiting[count++] = {node.level + 1, 2 * node.index + 1};
      continue;
    }
    const std::uint32_t end = tree_.first_point(node.level, node.index + 1);
    for (std::uint32_t k = tree_.first_point(node.level, node.index); k < end; ++k) {
      if (boxes_[k].holds(position) && accepts(middles_[k].number)) return true;
    }
  }
  return false;
}

}  // namespace meristem
