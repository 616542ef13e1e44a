// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/graph/tree_layout.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace meristem::tree_layout_test {

TEST(TreeLayout, ParentsStandInTheMiddleOfTheirChildren) {
  const std::vector<std::uint32_t> parents{kNoParent, 0, 0, 0, 2};
  const TreePlaces places = place_tree(parents);
  EXPECT_EQ(places.level, (std::vector<std::uint32_t>{0, 1, 1, 1, 2}));
  EXPECT_EQ(places.levels, 3U);
  EXPECT_DOUBLE_EQ(places.across[0], (places.across[1] + places.across[3]) / 2);
  EXPECT_DOUBLE_EQ(places.across[2], places.across[4]);
  EXPECT_GE(places.across[2] - places.across[1], 1);
}

TEST(TreeLayout, NoTwoNodesOfALevelAreNearerThanNeighboursAndOrdersHold) {
  std::mt19937 chance(5);
  for (int tree = 0; tree < 40; ++tree) {
    std::vector<std::uint32_t> parents{kNoParent};
    for (std::uint32_t node = 1; node < 60; ++node) {
      parents.push_back(chance() % 12 == 0 ? kNoParent : static_cast<std::uint32_t>(chance() % node));
    }
    const TreePlaces places = place_tree(parents);
    double min = 1e9;
    for (std::uint32_t a = 0; a < parents.size(); ++a) {
      min = std::min(min, places.across[a]);
      EXPECT_LE(places.across[a], places.breadth);
      for (std::uint32_t b = a + 1; b < parents.size(); ++b) {
        if (places.level[a] != places.level[b]) continue;
        EXPECT_GE(std::abs(places.across[a] - places.across[b]), 1 - 1e-9) << tree << ": " << a << ", " << b;
        if (parents[a] == parents[b]) {
          EXPECT_LT(places.across[a], places.across[b]);
        }
      }
    }
    EXPECT_NEAR(min, 0, 1e-12);
  }
}

TEST(TreeLayout, OfNothingIsNothing) {
  EXPECT_TRUE(place_tree({}).across.empty());
  EXPECT_EQ(place_tree({}).levels, 0U);
}

}  // namespace meristem::tree_layout_test
