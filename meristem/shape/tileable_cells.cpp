// SPDX-License-Identifier: Apache-2.0
// Based on: Worley: A cellular texture basis function (SIGGRAPH 1996); the true distance to the border, instead of the
// difference of the two nearest distances, keeps cracks equally wide.
#include "meristem/shape/tileable_cells.h"

#include <cmath>
#include <limits>

namespace meristem {

namespace {

constexpr int kMargin = 2;  // columns and rows of copies around the tile, so that no index needs wrapping

float wrapped(float x) {
  if (x < 0) return x + 1;
  return x >= 1 ? x - 1 : x;
}

}  // namespace

TileableCells::TileableCells(RandomKey key, int columns, int rows, float jitter)
    : columns_(columns), rows_(rows), stride_(columns + 2 * kMargin) {
  const RandomKey point = key.child("point");
  const RandomKey random = key.child("random");
  for (int r = -kMargin; r < rows + kMargin; ++r) {
    for (int c = -kMargin; c < columns + kMargin; ++c) {
      // `columns` twice, because a tile may be narrower than the margin.
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
  const Vec2 place = Vec2(wrapped(u), wrapped(v)) * counts;

  // Find the nearest of the points around.
  std::array<Vec2, 9> offsets;
  std::array<float, 9> squares;
  const Point* nearest_point = nullptr;
  std::size_t nearest = 0;
  float nearest_square = std::numeric_limits<float>::infinity();
  std::size_t k = 0;
  const int row = static_cast<int>(place.y);
  for (int r = row - 1; r <= row + 1; ++r) {
    // Cut off one cell further on, where nothing is negative.
    const int column = static_cast<int>(place.x + ((r & 1) != 0 ? 0.5F : 1.0F)) - 1;
    const Point* points = points_.data() + (r + kMargin) * stride_ + column - 1 + kMargin;
    for (int c = 0; c < 3; ++c, ++k) {
      offsets[k] = place - points[c].place;
      squares[k] = glm::dot(offsets[k], offsets[k]);
      if (squares[k] < nearest_square) {
        nearest_square = squares[k];
        nearest = k;
        nearest_point = points + c;
      }
    }
  }

  // Measure to the nearest of the lines between its point and the others, in widths of the tile. Squares of quotients
  // are compared without dividing.
  float least_difference = std::numeric_limits<float>::max();
  float least_slope = 1;
  for (std::size_t other = 0; other < k; ++other) {
    if (other == nearest) continue;
    const Vec2 slope = (offsets[nearest] - offsets[other]) * counts;
    const float difference = (squares[other] - nearest_square) * (squares[other] - nearest_square);
    const float slope_square = glm::dot(slope, slope);
    if (difference * least_slope < least_difference * slope_square) {
      least_difference = difference;
      least_slope = slope_square;
    }
  }
  return {nearest_point->cell, 0.5F * std::sqrt(least_difference / least_slope), offsets[nearest]};
}

}  // namespace meristem
