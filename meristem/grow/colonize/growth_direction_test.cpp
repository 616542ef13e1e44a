// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/growth_direction.h"

#include <cmath>

#include <gtest/gtest.h>

namespace meristem::growth_direction_test {

TEST(GrowthDirection, IsTheUnitSumPlusBias) {
  const auto plain = growth_direction({0, 5, 0}, DVec3(0));
  ASSERT_TRUE(plain.has_value());
  EXPECT_EQ(*plain, DVec3(0, 1, 0));
  const auto biased = growth_direction({0, 5, 0}, DVec3(1, 0, 0));
  ASSERT_TRUE(biased.has_value());
  EXPECT_NEAR(biased->x, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(biased->y, std::sqrt(0.5), 1e-15);
}

TEST(GrowthDirection, IsNothingWhereSumOrBiasedSumVanishes) {
  EXPECT_FALSE(growth_direction({0, 0, 0}, DVec3(0, 1, 0)).has_value());
  EXPECT_FALSE(growth_direction({0, 2, 0}, DVec3(0, -1, 0)).has_value());
  EXPECT_FALSE(growth_direction({1e-9, 0, 0}, DVec3(0)).has_value());
}

}  // namespace meristem::growth_direction_test
