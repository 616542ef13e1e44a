// SPDX-License-Identifier: Apache-2.0
// Builds the point tree. Each level splits the points of its nodes at the median along the longest side of their box,
// and the nodes of a level run in parallel.
#include "meristem/base/point_tree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "meristem/base/parallel.h"

namespace meristem {
namespace {

constexpr std::size_t kPointsPerBlock = 1 << 14;  // minimum number of points that is worth another thread

Vec3 position_of(Vec3 point) { return point; }
Vec3 position_of(const NumberedPoint& place) { return place.position; }

template <class Point>
Box box_of(const Point* begin, const Point* end) {
  Box box;
  for (const Point* point = begin; point != end; ++point) box.add(position_of(*point));
  return box;
}

int longest_axis(const Box& box) {
  const Vec3 size = box.size();
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

/// Moves the median along an axis to its final position, smaller values before it and larger ones after it.
template <class Point>
void halve(Point* begin, Point* middle, Point* end) {
  if (middle == end) return;
  const int axis = longest_axis(box_of(begin, end));
  std::nth_element(begin, middle, end,
                   [axis](const Point& a, const Point& b) { return position_of(a)[axis] < position_of(b)[axis]; });
}

}  // namespace

template <class Point>
void PointTree::build(std::vector<Point>& points, std::size_t leaf_points, const Progress& progress) {
  for (const Point& point : points) {
    const Vec3 position = position_of(point);
    if (!std::isfinite(position.x + position.y + position.z)) {
      throw std::invalid_argument("points must be finite");
    }
  }
  while (point_count_ >> leaf_level_ > leaf_points - 1) ++leaf_level_;
  // Split level by level. The nodes of one level are independent.
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
  // Compute the boxes of the leaves, then the boxes of the nodes above, level by level.
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

template void PointTree::build(std::vector<Vec3>&, std::size_t, const Progress&);
template void PointTree::build(std::vector<NumberedPoint>&, std::size_t, const Progress&);

}  // namespace meristem
