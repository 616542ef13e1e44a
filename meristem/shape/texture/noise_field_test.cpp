// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/texture/noise_field.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"

namespace meristem::noise_field_test {

constexpr int kPixels = 128;

float at(const std::vector<float>& field, int x, int y) {
  return field[static_cast<std::size_t>(y) * kPixels + static_cast<std::size_t>(x)];
}

TEST(NoiseField, StepsAcrossTheEdgesAreNoLargerThanWithin) {
  const auto field = noise_field(RandomKey(3), {.across = 5, .along = 3}, kPixels);
  float within = 0;
  float across = 0;
  for (int k = 0; k < kPixels; ++k) {
    for (int j = 1; j < kPixels; ++j) {
      within = std::max(
          {within, std::abs(at(field, j, k) - at(field, j - 1, k)), std::abs(at(field, k, j) - at(field, k, j - 1))});
    }
    across = std::max({across, std::abs(at(field, 0, k) - at(field, kPixels - 1, k)),
                       std::abs(at(field, k, 0) - at(field, k, kPixels - 1))});
  }
  EXPECT_LE(across, within);
  EXPECT_GT(across, 0);
}

TEST(NoiseField, HasMeanNothingAndStaysWithinAboutOne) {
  const auto field = noise_field(RandomKey(4), {.across = 16, .along = 16}, kPixels);
  double sum = 0;
  for (const float value : field) {
    sum += value;
    ASSERT_LT(std::abs(value), 1.5F);
  }
  // 256 cells with standard deviation 0.4: the tolerance is four standard deviations of their mean.
  EXPECT_NEAR(sum / static_cast<double>(field.size()), 0, 0.1);
}

TEST(NoiseField, ASingleCellIsOddAboutItsMiddle) {
  // All corners are one lattice point, with one slope.
  const auto field = noise_field(RandomKey(5), {.across = 1, .along = 1, .octaves = 1}, kPixels);
  float highest = 0;
  for (int x = 0; x < kPixels; ++x) {
    for (int y = 0; y < kPixels; ++y) {
      ASSERT_NEAR(at(field, x, y), -at(field, kPixels - 1 - x, kPixels - 1 - y), 1e-5F);
      highest = std::max(highest, at(field, x, y));
    }
  }
  EXPECT_GT(highest, 0.1F);
}

TEST(NoiseField, LeavesOutOctavesTooFineForThePixels) {
  const NoiseParameters fine{.across = 32, .along = 32, .octaves = 6};
  NoiseParameters coarse = fine;
  coarse.octaves = 2;
  const auto many = noise_field(RandomKey(6), fine, kPixels);
  const auto two = noise_field(RandomKey(6), coarse, kPixels);
  // Only the heights differ: the sum of six squares compared with the sum of two.
  const double ratio = std::sqrt((1 + 0.25) / (1 + 0.25 + 1.0 / 16 + 1.0 / 64 + 1.0 / 256 + 1.0 / 1024));
  for (std::size_t k = 0; k < many.size(); ++k) ASSERT_NEAR(many[k], ratio * two[k], 1e-5);
}

TEST(NoiseField, IsTheSameOnAnyNumberOfThreads) {
  std::vector<float> first;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    const auto field = noise_field(RandomKey(7), {.across = 9, .along = 4}, kPixels);
    if (first.empty()) first = field;
    EXPECT_EQ(field, first) << threads;
  }
}

}  // namespace meristem::noise_field_test
