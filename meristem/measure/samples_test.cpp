// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/samples.h"

#include <cmath>

#include <gtest/gtest.h>

namespace meristem::samples_test {

TEST(Samples, QuantilesOfWholeNumbersAreInterpolated) {
  std::vector<double> numbers;
  for (int k = 100; k >= 0; --k) numbers.push_back(k);
  const SampleStatistics found = distribution(numbers);
  EXPECT_EQ(found.count, 101U);
  EXPECT_DOUBLE_EQ(found.mean, 50);
  // The variance of 0 to n is n (n + 2) / 12.
  EXPECT_NEAR(found.spread, std::sqrt(100.0 * 102 / 12), 1e-12);
  EXPECT_NEAR(found.low, 5, 1e-12);
  EXPECT_DOUBLE_EQ(found.median, 50);
  EXPECT_NEAR(found.high, 95, 1e-12);
  EXPECT_DOUBLE_EQ(quantile(std::vector<double>{1, 2}, 0.25), 1.25);
}

TEST(Samples, OneNumberIsItsOwnDistribution) {
  const SampleStatistics found = distribution({3});
  EXPECT_EQ(found.low, 3);
  EXPECT_EQ(found.high, 3);
  EXPECT_EQ(found.spread, 0);
}

TEST(Samples, NoneHaveNothing) {
  EXPECT_EQ(distribution({}).count, 0U);
  EXPECT_EQ(quantile({}, 0.5), 0);
}

}  // namespace meristem::samples_test
