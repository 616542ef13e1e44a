// SPDX-License-Identifier: Apache-2.0
// A tile, the unit square, divided into irregular cells: the Voronoi cells of a jittered lattice. Its rows are
// displaced by half a cell, so that cells interlock like bricks, or like the ridges of bark if cells are long.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/base/vec.h"

namespace meristem {

class TileableCells {
 public:
  struct Spot {
    std::uint32_t cell = 0;
    float border = 0;  ///< distance to the nearest border, in widths of the tile
    Vec2 offset{0};    ///< from the cell's point, in cells
  };

  /// `rows` must be even. `jitter`, in [0, 0.4], is the maximum deviation of points from the lattice, in cells.
  TileableCells(RandomKey key, int columns, int rows, float jitter);
  /// u and v must be in [-1, 2).
  Spot at(float u, float v) const;
  /// Returns a random number in [0, 1) for each cell. `which` is 0 to 3.
  float random(std::uint32_t cell, std::size_t which) const { return randoms_[cell][which]; }

 private:
  struct Point {
    Vec2 position{0};  // in cells
    std::uint32_t cell = 0;
  };

  int columns_;
  int rows_;
  int stride_;
  std::vector<Point> points_;  // with copies across the tile's edges
  std::vector<std::array<float, 4>> randoms_;
};

}  // namespace meristem
