// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/obstacle/box_tree.h"

#include "meristem/base/progress.h"

namespace meristem {

namespace {

constexpr std::size_t kLeafBoxes = 4;

std::vector<NumberedPoint> middles_of(const std::vector<Box>& boxes) {
  std::vector<NumberedPoint> middles;
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    if (!boxes[k].is_empty()) middles.push_back({boxes[k].centre(), k});
  }
  return middles;
}

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes)
    : middles_(middles_of(boxes)), tree_(middles_, Progress(), kLeafBoxes), around_(tree_.node_count()) {
  for (const NumberedPoint& middle : middles_) boxes_.push_back(boxes[middle.number]);
  for (std::uint32_t leaf = 0; leaf < tree_.leaf_count(); ++leaf) {
    Box& around = around_[PointTree::place(tree_.leaf_level(), leaf)];
    const std::uint32_t end = tree_.first_point(tree_.leaf_level(), leaf + 1);
    for (std::uint32_t k = tree_.first_point(tree_.leaf_level(), leaf); k < end; ++k) around.add(boxes_[k]);
  }
  for (std::uint32_t node = PointTree::place(tree_.leaf_level(), 0); node-- > 0;) {
    around_[node].add(around_[2 * node + 1]);
    around_[node].add(around_[2 * node + 2]);
  }
}

}  // namespace meristem
