// SPDX-License-Identifier: Apache-2.0
// Tests the distribution of random numbers. Keys are fixed, so these tests pass always or never. The comment on each
// bound says how rarely a good generator would exceed it.
#include "meristem/base/random.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/hash.h"

namespace meristem::random_test {

using Words = std::array<std::uint32_t, 4>;

/// Returns Pearson's statistic for equally likely bins.
double chi_square(const std::vector<int>& counts, int samples) {
  const double expected = static_cast<double>(samples) / static_cast<double>(counts.size());
  double sum = 0;
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

// Pearson's statistic exceeds these values once in a thousand times, for 63 and 255 degrees of freedom.
constexpr double kRareOf64 = 103.4;
constexpr double kRareOf256 = 330.5;
constexpr int kSamples = 1 << 17;

/// Returns the statistic of pairs (first(k), second(k)) over a grid of 16 by 16 cells.
template <class First, class Second>
double pair_chi_square(First first, Second second) {
  std::vector<int> cells(256);
  for (std::uint64_t k = 0; k < kSamples; ++k) {
    const auto row = static_cast<std::size_t>(16 * first(k));
    const auto column = static_cast<std::size_t>(16 * second(k));
    ++cells.at(16 * row + column);
  }
  return chi_square(cells, kSamples);
}

TEST(Philox, MatchesTheKnownAnswersOfRandom123) {
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  const std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}), (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(RandomKey, NumbersDependOnKeyAndIndexOnly) {
  const RandomKey key = RandomKey(7).child("stem").child(3);
  const double first = key.uniform(100);
  for (std::uint64_t k = 0; k < 50; ++k) static_cast<void>(key.child(k).normal(k));
  EXPECT_EQ(key.uniform(100), first);
  EXPECT_EQ(RandomKey(7).child("stem").child(3).uniform(100), first);
  EXPECT_EQ(key.child("leaf"), key.child(hash64("leaf")));
}

TEST(RandomKey, EverySeedNameIndexLaneAndOrderGivesAnotherStream) {
  const RandomKey key(7);
  EXPECT_NE(key, RandomKey(8));
  EXPECT_NE(key.child("a"), key.child("b"));
  EXPECT_NE(key.child(""), key);
  EXPECT_NE(key.child(0), key);
  EXPECT_NE(key.child("a").child("b"), key.child("b").child("a"));
  EXPECT_NE(key.child("a").child("b"), key.child("ab"));
  EXPECT_NE(key.uniform(0, 0U), key.uniform(0, 1U));
  EXPECT_NE(key.uniform(0), key.uniform(std::uint64_t{1} << 32));
}

TEST(RandomKey, ChildrenOfManyKeysDiffer) {
  std::vector<std::uint64_t> bits;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    for (std::uint64_t k = 0; k < 300; ++k) bits.push_back(RandomKey(seed).child(k).bits());
  }
  std::sort(bits.begin(), bits.end());
  EXPECT_EQ(std::adjacent_find(bits.begin(), bits.end()), bits.end());
}

TEST(RandomKey, UniformFillsTheUnitIntervalEvenly) {
  for (const RandomKey key : {RandomKey(1), RandomKey(1).child("leaf"), RandomKey(1).child(1)}) {
    for (const unsigned lane : {0U, 1U}) {
      std::vector<int> bins(64);
      for (std::uint64_t k = 0; k < kSamples; ++k) {
        const double u = key.uniform(k, lane);
        ASSERT_GE(u, 0);
        ASSERT_LT(u, 1);
        ++bins.at(static_cast<std::size_t>(64 * u));
      }
      EXPECT_LT(chi_square(bins, kSamples), kRareOf64);
    }
  }
}

TEST(RandomKey, UniformOfARangeStaysInIt) {
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const double x = RandomKey(2).uniform(k, -3, 5);
    EXPECT_GE(x, -3);
    EXPECT_LT(x, 5);
    EXPECT_DOUBLE_EQ(x, -3 + 8 * RandomKey(2).uniform(k));
  }
}

TEST(RandomKey, NeighboursAreIndependent) {
  const RandomKey key(3);
  const RandomKey next(4);
  const RandomKey left = key.child("left");
  const RandomKey right = key.child("right");
  const auto number = [](RandomKey of) { return [of](std::uint64_t k) { return of.uniform(k); }; };
  EXPECT_LT(pair_chi_square(number(key), number(next)), kRareOf256);
  EXPECT_LT(pair_chi_square(number(left), number(right)), kRareOf256);
  EXPECT_LT(pair_chi_square(number(key), number(left)), kRareOf256);
  EXPECT_LT(pair_chi_square(number(key.child(0)), number(key.child(1))), kRareOf256);
  EXPECT_LT(pair_chi_square(number(key), [&](std::uint64_t k) { return key.uniform(k + 1); }), kRareOf256);
  EXPECT_LT(pair_chi_square(number(key), [&](std::uint64_t k) { return key.uniform(k, 1U); }), kRareOf256);
  // The first numbers of many children, as when one number is drawn for each leaf.
  EXPECT_LT(pair_chi_square([&](std::uint64_t k) { return key.child(k).uniform(0); },
                            [&](std::uint64_t k) { return key.child(k + 1).uniform(0); }),
            kRareOf256);
}

TEST(RandomKey, NormalHasTheMomentsOfTheStandardNormal) {
  double sums[5] = {};
  for (std::uint64_t k = 0; k < kSamples; ++k) {
    const double x = RandomKey(5).normal(k);
    ASSERT_TRUE(std::isfinite(x));
    for (int power = 1; power <= 4; ++power) sums[power] += std::pow(x, power);
  }
  // Four standard deviations of each mean: Var(x^p) = E(x^2p) - E(x^p)², that is 1, 2, 15 and 96.
  const double n = kSamples;
  EXPECT_NEAR(sums[1] / n, 0, 4 * std::sqrt(1 / n));
  EXPECT_NEAR(sums[2] / n, 1, 4 * std::sqrt(2 / n));
  EXPECT_NEAR(sums[3] / n, 0, 4 * std::sqrt(15 / n));
  EXPECT_NEAR(sums[4] / n, 3, 4 * std::sqrt(96 / n));
}

TEST(RandomKey, NormalFallsEvenlyIntoItsQuantiles) {
  std::vector<int> bins(64);
  for (std::uint64_t k = 0; k < kSamples; ++k) {
    const double below = 0.5 * std::erfc(-RandomKey(6).normal(k) / std::sqrt(2.0));
    ++bins.at(std::min<std::size_t>(63, static_cast<std::size_t>(64 * below)));
  }
  EXPECT_LT(chi_square(bins, kSamples), kRareOf64);
}

TEST(RandomKey, DirectionsAreUnitAndEvenOnTheSphere) {
  // On a sphere, height and azimuth are independent and both uniform (Archimedes).
  const RandomKey key(7);
  const auto height = [&](std::uint64_t k) { return std::min(0.9999999, 0.5 + 0.5 * key.direction(k).y); };
  const auto azimuth = [&](std::uint64_t k) {
    const Vec3 d = key.direction(k);
    return std::clamp(0.5 + std::atan2(d.z, d.x) / (2 * kPi), 0.0, 0.9999999);
  };
  EXPECT_LT(pair_chi_square(height, azimuth), kRareOf256);
  for (std::uint64_t k = 0; k < 1000; ++k) EXPECT_NEAR(glm::length(key.direction(k)), 1, 1e-6);
}

}  // namespace meristem::random_test
