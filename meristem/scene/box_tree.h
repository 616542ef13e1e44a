// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

/// Boxes, halved again and again at the median of their middles, to find those around a place without asking each.
/// Empty ones are around none.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Whether `accepts(index)` says yes to any of the boxes that hold a place, their faces included; asked in an order
  /// that means nothing.
  template <class Accepts>
  bool any_around(Vec3 place, Accepts accepts) const;

 private:
  static bool holds(const Box& box, Vec3 place) {
    return glm::all(glm::lessThanEqual(box.low, place)) && glm::all(glm::lessThanEqual(place, box.high));
  }
  std::size_t first(int level, std::uint64_t index) const { return order_.size() * index >> level; }

  std::vector<std::uint32_t> order_;  // the leaf k, one of 2^levels_, has those from first(levels_, k) to the next
  std::vector<Box> boxes_;            // in that order
  std::vector<Box> around_;           // the node k of level l at 2^l - 1 + k
  int levels_ = 0;
};

template <class Accepts>
bool BoxTree::any_around(Vec3 place, Accepts accepts) const {
  if (order_.empty()) return false;
  struct Node {
    int level;
    std::uint64_t index;
  };
  // One node waits on each level; there are no more than 2^32 boxes.
  Node waiting[34];
  int count = 0;
  waiting[count++] = {0, 0};
  while (count > 0) {
    const Node node = waiting[--count];
    if (!holds(around_[(std::size_t{1} << node.level) - 1 + node.index], place)) continue;
    if (node.level < levels_) {
      waiting[count++] = {node.level + 1, 2 * node.index};
      waiting[count++] = {node.level + 1, 2 * node.index + 1};
      continue;
    }
    for (std::size_t k = first(levels_, node.index); k < first(levels_, node.index + 1); ++k) {
      if (holds(boxes_[k], place) && accepts(order_[k])) return true;
    }
  }
  return false;
}

}  // namespace meristem
