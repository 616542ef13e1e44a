// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/box_tree.h"

#include <algorithm>

namespace meristem {

namespace {

constexpr std::size_t kBoxesPerLeaf = 4;

int longest_axis(const Box& box) {
  const Vec3 size = box.size();
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes) {
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    if (!boxes[k].is_empty()) order_.push_back(k);
  }
  while (order_.size() >> levels_ > kBoxesPerLeaf) ++levels_;
  const auto at = [this](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
  for (int level = 0; level < levels_; ++level) {
    for (std::uint64_t node = 0; node < std::uint64_t{1} << level; ++node) {
      const auto begin = at(first(level, node));
      const auto end = at(first(level, node + 1));
      Box middles;
      for (auto k = begin; k != end; ++k) middles.add(boxes[*k].centre());
      const int axis = longest_axis(middles);
      std::nth_element(begin, at(first(level + 1, 2 * node + 1)), end, [&](std::uint32_t a, std::uint32_t b) {
        return boxes[a].centre()[axis] < boxes[b].centre()[axis];
      });
    }
  }
  for (const std::uint32_t k : order_) boxes_.push_back(boxes[k]);
  // Box the leaves, and what contains them from there up.
  const std::size_t leaves = std::size_t{1} << levels_;
  around_.resize(2 * leaves - 1);
  for (std::uint64_t leaf = 0; leaf < leaves; ++leaf) {
    for (std::size_t k = first(levels_, leaf); k < first(levels_, leaf + 1); ++k) {
      around_[leaves - 1 + leaf].add(boxes_[k]);
    }
  }
  for (std::size_t node = leaves - 1; node-- > 0;) {
    around_[node].add(around_[2 * node + 1]);
    around_[node].add(around_[2 * node + 2]);
  }
}

}  // namespace meristem
