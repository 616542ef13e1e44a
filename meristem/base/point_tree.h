// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"

namespace meristem {

/// A point that keeps its number while points are reordered.
struct NumberedPoint {
  Vec3 position{0};
  std::uint32_t number = 0;
};

/// Points that are split again and again at the median of their longest extent, until few are left together. The result
/// is a complete binary tree whose nodes need no links. Unlike a grid of equal cells, the tree adapts to clouds of any
/// shape, to several distant clouds and to outliers.
///
/// Level l has 2^l nodes. Node i of a level contains the points [first_point(l, i), first_point(l, i + 1)).
class PointTree {
 public:
  /// Points in a leaf. Fewer points mean more boxes to check, more points mean more useless comparisons. 32 are slower,
  /// except for small clouds.
  static constexpr std::size_t kLeafPoints = 64;

  /// Orders `points` in place. Leaves have fewer than `leaf_points`. Throws std::invalid_argument for coordinates that
  /// are not finite, and Cancelled.
  PointTree(std::vector<Vec3>& points, const Progress& progress, std::size_t leaf_points = kLeafPoints)
      : point_count_(points.size()) {
    build(points, leaf_points, progress);
  }
  PointTree(std::vector<NumberedPoint>& points, const Progress& progress, std::size_t leaf_points = kLeafPoints)
      : point_count_(points.size()) {
    build(points, leaf_points, progress);
  }

  int leaf_level() const { return leaf_level_; }
  std::uint32_t leaf_count() const { return std::uint32_t{1} << leaf_level_; }
  std::uint32_t first_point(int level, std::uint32_t index) const {
    return static_cast<std::uint32_t>(point_count_ * index >> level);
  }
  /// Returns the position of a node in arrays over all nodes. The children of position p are at 2 p + 1 and 2 p + 2.
  static std::uint32_t place(int level, std::uint32_t index) { return (std::uint32_t{1} << level) - 1 + index; }
  std::uint32_t node_count() const { return 2 * leaf_count() - 1; }
  /// Returns the boxes around the points of each node, by position of the node.
  const std::vector<Box>& boxes() const { return boxes_; }

 private:
  template <class Point>
  void build(std::vector<Point>& points, std::size_t leaf_points, const Progress& progress);

  std::uint64_t point_count_;
  int leaf_level_ = 0;
  std::vector<Box> boxes_;
};

/// Returns the squared distance from a point to a box, 0 inside. The result never exceeds the rounded squared distance
/// to any point in the box.
inline float distance2(const Box& box, Vec3 point) {
  // Clamping compiles to minima and maxima. A comparison with 0 would compile to an unpredictable branch.
  const Vec3 offset = point - glm::min(glm::max(point, box.low), box.high);
  return squared_length(offset);
}

}  // namespace meristem
