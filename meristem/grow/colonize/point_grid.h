// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

/// Cubic cells over the bounding box of a set of points, some 16 to 32 points a cell where they are spread evenly;
/// never more cells than points, whatever their extent.
class PointGrid {
 public:
  using Cell = std::uint32_t;
  /// Cells from `low` to `high`, both included, along each axis.
  struct Range {
    std::array<int, 3> low;
    std::array<int, 3> high;
  };

  /// Throws std::invalid_argument for coordinates that are not finite.
  explicit PointGrid(const std::vector<Vec3>& points);

  std::array<int, 3> size() const { return size_; }  ///< cells along x, y, z
  std::size_t cell_count() const { return static_cast<std::size_t>(size_[0]) * size_[1] * size_[2]; }
  Cell cell_at(int x, int y, int z) const { return static_cast<Cell>((z * size_[1] + y) * size_[0] + x); }
  Cell cell_of(Vec3 point) const;
  /// All cells in which points within `distance` of `centre` may lie; empty (low > high) where there are none.
  Range cells_near(Vec3 centre, float distance) const;
  /// A lower bound of the distance along one axis (0 to 2) from `coordinate` to the cells with number `cell` on it.
  float gap(int axis, int cell, float coordinate) const {
    const float centre = low_[axis] + edge_ * (static_cast<float>(cell) + 0.5F);
    const float beyond = (coordinate < centre ? centre - coordinate : coordinate - centre) - half_;
    return beyond > 0 ? beyond : 0;
  }

 private:
  Vec3 low_{0};
  float edge_ = 1;
  float half_ = 0.5F;  // half an edge and a little, so that rounding never puts a point outside its cell
  std::array<int, 3> size_{1, 1, 1};
};

}  // namespace meristem
