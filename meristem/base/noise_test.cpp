// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/noise.h"

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace meristem::noise_test {

const RandomKey kKey(7);

/// A walk through the noise in each number of dimensions, along a line that meets no lattice point.
struct Walk {
  const char* name;
  std::function<double(RandomKey, double)> value;
};

std::vector<Walk> walks() {
  return {
      {"line", [](RandomKey key, double s) { return gradient_noise(key, s); }},
      {"plane", [](RandomKey key, double s) { return gradient_noise(key, 0.618 * s, 0.787 * s + 0.3); }},
      {"space", [](RandomKey key, double s) { return gradient_noise(key, 0.53 * s, 0.61 * s + 0.3, 0.59 * s - 0.2); }}};
}

TEST(Noise, IsZeroOnTheLattice) {
  for (int x = -3; x <= 3; ++x) {
    EXPECT_EQ(gradient_noise(kKey, x), 0);
    for (int y = -3; y <= 3; ++y) {
      EXPECT_EQ(gradient_noise(kKey, x, y), 0);
      EXPECT_EQ(gradient_noise(kKey, x, y, x - y), 0);
    }
  }
}

TEST(Noise, FillsTheRangeWithMeanZero) {
  for (const Walk& walk : walks()) {
    double sum = 0;
    double min = 0;
    double max = 0;
    constexpr int kSamples = 200'000;
    for (int k = 0; k < kSamples; ++k) {
      const double value = walk.value(kKey, k * 0.37);
      sum += value;
      min = std::min(min, value);
      max = std::max(max, value);
    }
    // Some 70,000 unrelated cells have a standard deviation below 0.5, so their mean has a standard deviation below
    // 0.002.
    EXPECT_NEAR(sum / kSamples, 0, 0.01) << walk.name;
    EXPECT_GE(min, -1.1) << walk.name;
    EXPECT_LE(min, -0.7) << walk.name;
    EXPECT_LE(max, 1.1) << walk.name;
    EXPECT_GE(max, 0.7) << walk.name;
  }
}

TEST(Noise, IsTwiceContinuouslyDifferentiableAcrossCells) {
  // Quadratic extrapolation from one side of a lattice plane meets the other side up to the third order.
  constexpr double kStep = 1e-3;
  const auto jump = [](auto value, double border) {
    const double before[] = {value(border - 3 * kStep), value(border - 2 * kStep), value(border - kStep)};
    return value(border + kStep) - (6 * before[2] - 8 * before[1] + 3 * before[0]);
  };
  const double third_order = 1000 * kStep * kStep * kStep;
  for (int border = -5; border <= 5; ++border) {
    EXPECT_NEAR(jump([](double s) { return gradient_noise(kKey, s); }, border), 0, third_order);
    EXPECT_NEAR(jump([](double s) { return gradient_noise(kKey, 0.4, s); }, border), 0, third_order);
    EXPECT_NEAR(jump([](double s) { return gradient_noise(kKey, 0.4, 0.7, s); }, border), 0, third_order);
  }
}

TEST(Noise, KeysGiveUnrelatedFunctions) {
  for (const Walk& walk : walks()) {
    double product = 0;
    double square = 0;
    for (int k = 0; k < 20'000; ++k) {
      const double a = walk.value(RandomKey(1), k * 0.73);
      product += a * walk.value(RandomKey(2), k * 0.73);
      square += a * a;
    }
    // The correlation of 14,000 unrelated cells has a standard deviation below 0.01.
    EXPECT_NEAR(product / square, 0, 0.05) << walk.name;
  }
}

TEST(Noise, DoesNotRepeat) {
  for (const Walk& walk : walks()) {
    for (const double period : {16.0, 256.0, 4096.0, 65536.0}) {
      int equal = 0;
      for (int k = 0; k < 200; ++k) {
        const double s = k * 0.37 + 0.1;
        equal += std::abs(gradient_noise(kKey, s, 0.5) - gradient_noise(kKey, s + period, 0.5)) < 1e-6 ? 1 : 0;
        equal += std::abs(gradient_noise(kKey, s) - gradient_noise(kKey, s + period)) < 1e-6 ? 1 : 0;
      }
      EXPECT_LT(equal, 20) << walk.name << ' ' << period;
    }
  }
}

TEST(Noise, HasTheSameBitsEverywhere) {
  EXPECT_EQ(gradient_noise(RandomKey(), 0.5), 0x1.c61b93f0399ap-4);
  EXPECT_EQ(gradient_noise(RandomKey(), 0.25, 1.75), 0x1.20422f2c368b2p-1);
  EXPECT_EQ(gradient_noise(RandomKey(), -0.25, 1.75, 8.5), -0x1.15038p-1);
}

TEST(Noise, FarAwayPlacesAndMissingNumbersAreDefined) {
  EXPECT_EQ(gradient_noise(kKey, 1e300), 0);
  EXPECT_EQ(gradient_noise(kKey, 0.5, -1e18), 0);
  EXPECT_TRUE(std::isfinite(gradient_noise(kKey, 1e15 + 0.5, -1e15, 0.5)));
  EXPECT_TRUE(std::isnan(gradient_noise(kKey, std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(gradient_noise(kKey, 0, std::nan(""))));
  EXPECT_TRUE(std::isnan(gradient_noise(kKey, 0, 1e300, std::nan(""))));
}

}  // namespace meristem::noise_test
