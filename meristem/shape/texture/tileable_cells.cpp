// SPDX-License-Identifier: Apache-2.0
// Finds the cell at a position and its distance to the nearest border. The true distance to the border, instead of the
// difference of the two nearest distances, keeps cracks equally wide.
//
// Based on: Worley: A cellular texture basis function (SIGGRAPH 1996).
#include "meristem/shape/texture/tileable_cells.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace meristem {

namespace {

constexpr int kBorder = 2;  // columns and rows of copies around the tile, so that no index needs wrapping

float wrapped(float x) {
  if (x < 0) return x + 1;
  return x >= 1 ? x - 1 : x;
}

}  // namespace

TileableCells::TileableCells(RandomKey key, int columns, int rows, float jitter)
    : columns_(columns), rows_(rows), stride_(columns + 2 * kBorder) {
  const RandomKey point = key.child("point");
  const RandomKey random = key.child("random");
  for (int r = -kBorder; r < rows + kBorder; ++r) {
    for (int c = -kBorder; c < columns + kBorder; ++c) {
      // `columns` is added twice, because a tile may be narrower than the margin.
      const int column = (c + 2 * columns) % columns;
      const auto cell = static_cast<std::uint32_t>((r + 2 * rows) % rows * columns + column);
      const auto strayed = [&](unsigned lane) {
        return 0.5F + jitter * static_cast<float>(2 * point.uniform(cell, lane) - 1);
      };
      const float shift = (r & 1) != 0 ? 0.5F : 0.0F;
      points_.push_back({{static_cast<float>(c) + shift + strayed(0), static_cast<float>(r) + strayed(1)}, cell});
    }
  }
  for (std::uint64_t cell = 0; cell < static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows); ++cell) {
    const auto uniform = [&](std::uint64_t which) { return static_cast<float>(random.uniform(4 * cell + which)); };
    randoms_.push_back({uniform(0), uniform(1), uniform(2), uniform(3)});
  }
}

TileableCells::Spot TileableCells::at(float u, float v) const {
  const Vec2 counts(columns_, rows_);
  const Vec2 position = Vec2(wrapped(u), wrapped(v)) * counts;

  // Measure the distances to the nine points around. Plain arrays become vector code.
  float across[9];
  float along[9];
  float squares[9];
  const Point* points[3];
  const int row = static_cast<int>(position.y);
  for (int r = 0; r < 3; ++r) {
    // Truncate one cell further on, where no number is negative.
    const bool is_shifted = ((row - 1 + r) & 1) != 0;
    const int column = static_cast<int>(position.x + (is_shifted ? 0.5F : 1.0F)) - 1;
    points[r] = points_.data() + static_cast<std::ptrdiff_t>(row - 1 + r + kBorder) * stride_ + column - 1 + kBorder;
    for (int c = 0; c < 3; ++c) {
      across[3 * r + c] = position.x - points[r][c].position.x;
      along[3 * r + c] = position.y - points[r][c].position.y;
    }
  }
  for (int k = 0; k < 9; ++k) squares[k] = across[k] * across[k] + along[k] * along[k];
  int nearest = 0;
  for (int k = 1; k < 9; ++k) nearest = squares[k] < squares[nearest] ? k : nearest;

  // Find the nearest bisector between this point and the others, in widths of the tile. The distance to the point
  // itself is NaN and never less than the border.
  float border = std::numeric_limits<float>::max();
  for (int k = 0; k < 9; ++k) {
    const float difference = squares[k] - squares[nearest];
    const float slope_u = (across[nearest] - across[k]) * counts.x;
    const float slope_v = (along[nearest] - along[k]) * counts.y;
    const float square = difference * difference / (slope_u * slope_u + slope_v * slope_v);
    border = square < border ? square : border;
  }
  return {points[nearest / 3][nearest % 3].cell, 0.5F * std::sqrt(border), {across[nearest], along[nearest]}};
}

}  // namespace meristem
