// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/crown.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"

namespace meristem {
namespace {

// Two points make a straight spline: a cylinder and a cone.
const std::vector<Vec2> kCylinder{{0.5F, 1}, {0.5F, 3}};
const std::vector<Vec2> kCone{{1, 0}, {0, 3}};
const std::vector<Vec2> kRoundCrown{{0, 0.4F}, {0.96F, 1.42F}, {1.6F, 2.61F}, {0, 3.8F}};

std::vector<Vec3> sample(const ProfileCrown& crown, std::uint64_t count, std::uint64_t seed = 5) {
  Progress progress;
  return crown.sample(count, RandomKey(seed), progress);
}

// The height below which `share` of the crown's volume lies, by fine sums.
double height_below_which(const ProfileCrown& crown, double share) {
  constexpr int kParts = 200'000;
  const double part = (crown.highest() - crown.lowest()) / kParts;
  double sum = 0;
  for (int k = 0; k < kParts; ++k) {
    const double height = crown.lowest() + (k + 0.5) * part;
    sum += kPi * crown.radius_at(height) * crown.radius_at(height) * part;
    if (sum >= share * crown.volume()) return height;
  }
  return crown.highest();
}

TEST(ProfileCrown, VolumesOfCylinderAndCone) {
  EXPECT_NEAR(ProfileCrown(kCylinder).volume(), kPi * 0.25 * 2, 1e-9);
  EXPECT_NEAR(ProfileCrown(kCone).volume(), kPi, 1e-6);
}

TEST(ProfileCrown, ThreePointsMakeTheNaturalSpline) {
  // Through (0, 0), (1, 1), (2, 0) with no curvature at the ends: f(y) = 1.5 y - 0.5 y^3 up to the middle, and
  // mirrored.
  const ProfileCrown crown({{0, 0}, {1, 1}, {0, 2}});
  for (const double y : {0.1, 0.4, 0.9}) {
    EXPECT_NEAR(crown.radius_at(y), 1.5 * y - 0.5 * y * y * y, 1e-6);
    EXPECT_NEAR(crown.radius_at(2 - y), crown.radius_at(y), 1e-6);
  }
  // The integral of f^2 from 0 to 1 is 3/4 - 3/10 + 1/28.
  EXPECT_NEAR(crown.volume(), 2 * kPi * (0.75 - 0.3 + 1.0 / 28), 1e-6);
}

TEST(ProfileCrown, RadiusIsZeroOutsideAndWhereTheSplineIsNegative) {
  const ProfileCrown crown({{0, 0}, {1, 1}, {0, 2}, {0, 3}, {1, 4}});
  EXPECT_EQ(crown.radius_at(-0.1), 0);
  EXPECT_EQ(crown.radius_at(4.1), 0);
  EXPECT_EQ(crown.radius_at(2.5), 0);
  EXPECT_GT(crown.radius_at(0.5), 0);
  EXPECT_FALSE(crown.contains({0.1F, 2.5F, 0}));
}

TEST(ProfileCrown, ContainsItsPoints) {
  const ProfileCrown crown(kRoundCrown);
  for (const Vec3 point : sample(crown, 20'000)) ASSERT_TRUE(crown.contains(point)) << point.y;
  EXPECT_FALSE(crown.contains({0, 0.3F, 0}));
  EXPECT_FALSE(crown.contains({0, 3.9F, 0}));
  EXPECT_FALSE(crown.contains({1.2F, 1.42F, 0}));
}

TEST(ProfileCrown, PointsAreUniformInVolume) {
  // 10 slices of equal volume, 5 rings of equal area, 8 sectors: 400 cells of equal volume with 250 points each. The
  // statistic has 399 degrees of freedom; it exceeds 399 + 3.1 sqrt(2 * 399) = 487 by chance once in a thousand.
  for (const std::vector<Vec2>& profile : {kCone, kRoundCrown}) {
    const ProfileCrown crown(profile);
    std::array<double, 10> top{};
    for (int k = 0; k < 10; ++k) top[k] = height_below_which(crown, (k + 1) / 10.0);
    std::vector<int> hits(400);
    for (const Vec3 point : sample(crown, 100'000)) {
      int slice = 0;
      while (slice < 9 && point.y >= top[slice]) ++slice;
      const double radius = crown.radius_at(point.y);
      const double inside = (point.x * point.x + point.z * point.z) / (radius * radius);
      const int ring = std::min(4, static_cast<int>(5 * inside));
      const int sector = std::min(7, static_cast<int>((std::atan2(point.z, point.x) / kPi + 1) * 4));
      ++hits[static_cast<std::size_t>((slice * 5 + ring) * 8 + sector)];
    }
    double statistic = 0;
    for (const int cell : hits) statistic += (cell - 250.0) * (cell - 250.0) / 250;
    EXPECT_LT(statistic, 487);
    EXPECT_GT(statistic, 311);  // too even is not random either
  }
}

TEST(ProfileCrown, TheKthPointDoesNotDependOnTheCount) {
  const ProfileCrown crown(kRoundCrown);
  const std::vector<Vec3> few = sample(crown, 100);
  const std::vector<Vec3> many = sample(crown, 10'000);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  EXPECT_NE(sample(crown, 100, 6), few);
}

TEST(ProfileCrown, SamplesTheSameOnAnyNumberOfThreads) {
  const ProfileCrown crown(kRoundCrown);
  const std::vector<Vec3> points = sample(crown, 50'000);
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(sample(crown, 50'000), points) << threads << " threads";
  }
}

TEST(ProfileCrown, CancelsWhenAsked) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(ProfileCrown(kCone).sample(100'000, RandomKey(1), progress), Cancelled);
}

TEST(ProfileCrown, RejectsFallingHeightsAndEmptyProfiles) {
  EXPECT_THROW(ProfileCrown({}), std::invalid_argument);
  EXPECT_THROW(ProfileCrown({{1, 0}}), std::invalid_argument);
  EXPECT_THROW(ProfileCrown({{1, 0}, {1, 2}, {0, 1}}), std::invalid_argument);
  EXPECT_THROW(ProfileCrown({{1, 0}, {1, 0}}), std::invalid_argument);
  const ProfileCrown empty({{0, 0}, {0, 1}});
  EXPECT_EQ(empty.volume(), 0);
  EXPECT_TRUE(sample(empty, 0).empty());
  EXPECT_THROW(sample(empty, 1), std::invalid_argument);
}

}  // namespace
}  // namespace meristem
