// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/light/sampled_days.h"

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "meristem/scene/light/sun.h"

namespace meristem::sampled_days_test {

const double kDortmund = radians(51.51494);

TEST(SampledDays, FromNoonAreThoseOfADay) {
  for (const double every : {0.25, 1.0, 1.7, 5.0}) {
    const auto plain = sun_of_day(kDortmund, 126, every);
    const auto anchored = sampled_days(kDortmund, {126}, {.every = every});
    ASSERT_EQ(plain.size(), anchored.size()) << every;
    for (std::size_t k = 0; k < plain.size(); ++k) {
      EXPECT_EQ(plain[k].toward, anchored[k].toward);
      EXPECT_EQ(plain[k].strength, anchored[k].strength);
    }
  }
}

TEST(SampledDays, MayBeginAtAnyTime) {
  // Every 4 hours from 9:30: 5:30, 9:30, 13:30 and 17:30 are in daylight.
  const auto positions = sampled_days(kDortmund, {126}, {.every = 4, .anchor = 9.5});
  ASSERT_EQ(positions.size(), 4U);
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 expected = unit_vector(sun_position(kDortmund, 126, 5.5 + 4 * static_cast<double>(k)));
    EXPECT_LT(glm::distance(positions[k].toward, expected), 1e-6F);
    sum += positions[k].strength;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(SampledDays, CountMidnightOnceOnThePolarDay) {
  const double pole = radians(89);
  EXPECT_EQ(sampled_days(pole, {172}, {.every = 6, .anchor = 12}).size(), 4U);
  EXPECT_EQ(sampled_days(pole, {172}, {.every = 6, .anchor = 0}).size(), 4U);
  EXPECT_EQ(sampled_days(pole, {172}, {.every = 6, .anchor = 3}).size(), 4U);
}

}  // namespace meristem::sampled_days_test
