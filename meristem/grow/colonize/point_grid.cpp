// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/point_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace meristem {
namespace {

constexpr std::size_t kPointsPerCell =
    32;  // at most on average; fewer: more cells to pass by; more: more points to compare in vain
constexpr double kShrink = 0.8;  // from one trial of an edge to the next
constexpr double kSmallestExtent = 1e-30;
constexpr double kSlack = 1e-3;  // of an edge; far above the rounding of coordinates within the grid

std::array<double, 3> cells_along(DVec3 size, double edge) {
  return {std::floor(size.x / edge) + 1, std::floor(size.y / edge) + 1, std::floor(size.z / edge) + 1};
}

}  // namespace

PointGrid::PointGrid(const std::vector<Vec3>& points) {
  Box box;
  for (const Vec3 point : points) {
    if (!std::isfinite(point.x + point.y + point.z)) throw std::invalid_argument("attraction points must be finite");
    box.add(point);
  }
  if (box.is_empty()) return;
  low_ = box.low;
  const DVec3 size = DVec3(box.high) - DVec3(box.low);
  const double extent = std::max({size.x, size.y, size.z});
  if (!(extent > kSmallestExtent)) return;
  // Shrink the edge until there are enough cells; this also fits flat and thin clouds, whose volume says nothing.
  const double wanted = static_cast<double>(points.size()) / kPointsPerCell;
  double edge = 2 * extent;
  std::array<double, 3> cells{1, 1, 1};
  while (cells[0] * cells[1] * cells[2] < wanted) {
    edge *= kShrink;
    cells = cells_along(size, edge);
  }
  edge_ = static_cast<float>(edge);
  half_ = static_cast<float>(edge * (0.5 + kSlack));
  for (int axis = 0; axis < 3; ++axis) size_[axis] = static_cast<int>(cells[axis]);
}

PointGrid::Cell PointGrid::cell_of(Vec3 point) const {
  std::array<int, 3> cell{};
  for (int axis = 0; axis < 3; ++axis) {
    const double offset = (static_cast<double>(point[axis]) - low_[axis]) / edge_;
    cell[axis] = std::min(static_cast<int>(offset), size_[axis] - 1);
  }
  return cell_at(cell[0], cell[1], cell[2]);
}

PointGrid::Range PointGrid::cells_near(Vec3 centre, float distance) const {
  Range range{};
  for (int axis = 0; axis < 3; ++axis) {
    const double offset = (static_cast<double>(centre[axis]) - low_[axis]) / edge_;
    const double reach = static_cast<double>(distance) / edge_ + kSlack;
    range.low[axis] = static_cast<int>(std::floor(std::clamp<double>(offset - reach, 0, size_[axis])));
    range.high[axis] = static_cast<int>(std::floor(std::clamp<double>(offset + reach, -1, size_[axis] - 1)));
  }
  return range;
}

}  // namespace meristem
