// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/approach.h"

#include <gtest/gtest.h>

namespace meristem::approach_test {

TEST(Approach, LeadsStraightToItsTarget) {
  const Approach approach = plan_approach({3, 4, 0}, 0.5, 2);
  EXPECT_NEAR(approach.direction.x, 0.6, 1e-12);
  EXPECT_NEAR(approach.direction.y, 0.8, 1e-12);
  EXPECT_NEAR(approach.distance, 5, 1e-12);
  EXPECT_EQ(approach.steps, 6U);
}

TEST(Approach, NeedsNoStepsWithinTheInfluenceDistance) {
  EXPECT_EQ(plan_approach({0, 2, 0}, 0.5, 2).steps, 0U);
  EXPECT_EQ(plan_approach({0, 0, 0}, 0.5, 2).steps, 0U);
}

TEST(Approach, CountsEvenHopelessWays) { EXPECT_GT(plan_approach({0, 1e18F, 0}, 1e-6, 1).steps, 1'000'000'000'000U); }

TEST(Approach, TakesTheFirstOfEquallyNearPoints) {
  const std::vector<Vec3> points{{0, 9, 0}, {0, 0, 2}, {2, 0, 0}};
  EXPECT_EQ(nearest_of(points, Vec3(0)), Vec3(0, 0, 2));
  EXPECT_EQ(nearest_of(points, Vec3(0, 8, 0)), Vec3(0, 9, 0));
  EXPECT_FALSE(nearest_of({}, Vec3(0)).has_value());
}

}  // namespace meristem::approach_test
