// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/texture/tileable_cells.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace meristem::tileable_cells_test {

TEST(TileableCells, OppositeEdgesBelongToTheSameCells) {
  const TileableCells cells(RandomKey(1), 7, 4, 0.38F);
  for (int k = 0; k < 100; ++k) {
    const float t = (static_cast<float>(k) + 0.5F) / 100;
    for (const auto& [here, there] : {std::pair(Vec2(0, t), Vec2(1, t)), std::pair(Vec2(t, 0), Vec2(t, 1))}) {
      const TileableCells::Spot a = cells.at(here.x, here.y);
      const TileableCells::Spot b = cells.at(there.x, there.y);
      EXPECT_EQ(a.cell, b.cell);
      EXPECT_NEAR(a.border, b.border, 1e-5F);
    }
  }
}

TEST(TileableCells, WithoutJitterAreHexagonsOfAWallOfBricks) {
  // Two columns and two rows: points at (1/4, 1/4), (3/4, 1/4) and, half a column further, (0, 3/4), (1/2, 3/4).
  const TileableCells cells(RandomKey(1), 2, 2, 0);
  const TileableCells::Spot middle = cells.at(0.25F, 0.25F);
  EXPECT_NEAR(glm::length(middle.offset), 0, 1e-6F);
  // The nearest border is halfway to the neighbour in the row.
  EXPECT_NEAR(middle.border, 0.25F, 1e-6F);
  EXPECT_EQ(cells.at(0.4F, 0.25F).cell, middle.cell);
  EXPECT_NE(cells.at(0.6F, 0.25F).cell, middle.cell);
  EXPECT_NEAR(cells.at(0.4F, 0.25F).border, 0.1F, 1e-6F);
}

TEST(TileableCells, BordersAreWhereTheCellChanges) {
  const TileableCells cells(RandomKey(2), 9, 6, 0.4F);
  constexpr int kSteps = 3000;
  TileableCells::Spot last = cells.at(0, 0.37F);
  int changes = 0;
  for (int k = 1; k < kSteps; ++k) {
    const TileableCells::Spot spot = cells.at(static_cast<float>(k) / kSteps, 0.37F);
    // A step reduces the distance to a border by no more than its length.
    if (spot.cell != last.cell) {
      EXPECT_LE(spot.border + last.border, 1.01F / kSteps);
      ++changes;
    }
    last = spot;
  }
  EXPECT_GE(changes, 8);
}

TEST(TileableCells, EachHasItsOwnRandomNumbers) {
  const TileableCells cells(RandomKey(3), 5, 4, 0.3F);
  std::set<float> numbers;
  for (std::uint32_t cell = 0; cell < 20; ++cell) {
    for (std::size_t which = 0; which < 4; ++which) {
      const float number = cells.random(cell, which);
      EXPECT_GE(number, 0);
      EXPECT_LT(number, 1);
      numbers.insert(number);
    }
  }
  EXPECT_EQ(numbers.size(), 80U);
}

}  // namespace meristem::tileable_cells_test
