// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/point_tree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "meristem/base/parallel.h"

namespace meristem {
namespace {

constexpr std::size_t kPointsPerBlock = 1 << 14;  // fewer are not worth another thread

Box box_of(const Vec3* begin, const Vec3* end) {
  Box box;
  for (const Vec3* point = begin; point != end; ++point) box.add(*point);
  return box;
}

int longest_axis(const Box& box) {
  const Vec3 size = box.size();
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

/// Puts the median along an axis in its place, smaller ones before it and larger ones after it.
void halve(Vec3* begin, Vec3* middle, Vec3* end) {
  if (middle == end) return;
  const int axis = longest_axis(box_of(begin, end));
  std::nth_element(begin, middle, end, [axis](Vec3 a, Vec3 b) { return a[axis] < b[axis]; });
}

}  // namespace

PointTree::PointTree(std::vector<Vec3>& points, Progress& progress) : point_count_(points.size()) {
  for (const Vec3 point : points) {
    if (!std::isfinite(point.x + point.y + point.z)) throw std::invalid_argument("attraction points must be finite");
  }
  while (point_count_ >> leaf_level_ > kLeafPoints - 1) ++leaf_level_;
  // Halve level by level; the nodes of one are independent.
  for (int level = 0; level < leaf_level_; ++level) {
    const std::size_t nodes = std::size_t{1} << level;
    const std::size_t grain = std::max<std::size_t>(1, kPointsPerBlock * nodes / points.size());
    parallel_for(nodes, grain, [&](std::size_t begin, std::size_t end) {
      progress.check();
      for (auto k = static_cast<std::uint32_t>(begin); k < end; ++k) {
        halve(points.data() + first_point(level, k), points.data() + first_point(level + 1, 2 * k + 1),
              points.data() + first_point(level, k + 1));
      }
    });
  }
  // Box the leaves, and what contains them from there up.
  boxes_.resize(node_count());
  for (std::uint32_t leaf = 0; leaf < leaf_count(); ++leaf) {
    boxes_[place(leaf_level_, leaf)] =
        box_of(points.data() + first_point(leaf_level_, leaf), points.data() + first_point(leaf_level_, leaf + 1));
  }
  for (std::uint32_t node = place(leaf_level_, 0); node-- > 0;) {
    boxes_[node].add(boxes_[2 * node + 1]);
    boxes_[node].add(boxes_[2 * node + 2]);
  }
}

}  // namespace meristem
