// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/crown/crown_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/scene/crown/combined_crown.h"
#include "meristem/scene/crown/mesh_crown.h"
#include "meristem/scene/crown/profile_crown.h"
#include "meristem/scene/crown/solid_crowns.h"

namespace meristem::crown_points_test {

const ProfileCrown kRoundCrown({{0, 0.4F}, {0.96F, 1.42F}, {1.6F, 2.61F}, {0, 3.8F}});

std::vector<Vec3> place(const Crown& crown, const PointDistribution& distribution, std::uint64_t seed = 5) {
  Progress progress;
  return place_points(crown, distribution, RandomKey(seed), progress);
}

// Maps a point to coordinates in [0, 1] that preserve ratios of volumes.
using EqualVolume = std::function<DVec3(Vec3)>;

// Checks that points are uniform in 10 x 10 x 10 cells of equal volume. With 100 points per cell on average, the
// chi-squared statistic has 999 degrees of freedom. It exceeds 999 + 3.29 sqrt(2 * 999) = 1146, or stays below 852, by
// chance once in two thousand.
void expect_uniform(const std::vector<Vec3>& points, const EqualVolume& cell_of) {
  constexpr int kParts = 10;
  std::vector<double> hits(kParts * kParts * kParts);
  for (const Vec3 point : points) {
    const DVec3 at = cell_of(point);
    int cell = 0;
    for (int k = 0; k < 3; ++k) {
      ASSERT_TRUE(at[k] > -1e-5 && at[k] < 1 + 1e-5) << at[k];
      cell = cell * kParts + std::clamp(static_cast<int>(at[k] * kParts), 0, kParts - 1);
    }
    ++hits[static_cast<std::size_t>(cell)];
  }
  const double expected = static_cast<double>(points.size()) / static_cast<double>(hits.size());
  double statistic = 0;
  for (const double hit : hits) statistic += (hit - expected) * (hit - expected) / expected;
  EXPECT_LT(statistic, 1146);
  EXPECT_GT(statistic, 852);
}

constexpr std::uint64_t kMany = 100'000;

double turn_of(double x, double z) { return std::atan2(x, z) / (2 * kPi) + 0.5; }

// Returns a function of height: the share of the volume below it, computed from the areas of cross-sections.
template <class Section>
std::function<double(double)> share_below(double low, double high, Section section) {
  constexpr int kSlices = 20'000;
  std::vector<double> sums(kSlices + 1);
  for (int k = 0; k < kSlices; ++k) sums[k + 1] = sums[k] + section(low + (k + 0.5) * (high - low) / kSlices);
  return [=](double height) {
    const double at = std::clamp((height - low) / (high - low) * kSlices, 0.0, kSlices - 1e-9);
    const auto slice = static_cast<std::size_t>(at);
    return (sums[slice] + (at - static_cast<double>(slice)) * (sums[slice + 1] - sums[slice])) / sums.back();
  };
}

// Coordinates of a body of revolution: height, radius and azimuth. Radii start at the share `hollow` of the full
// radius.
EqualVolume revolved(const ProfileCrown& crown, double from, double hollow = 0) {
  const auto height = share_below(from, crown.highest(), [&](double y) { return std::pow(crown.radius_at(y), 2); });
  return [=, &crown](Vec3 p) {
    const double ring = (double{p.x} * p.x + double{p.z} * p.z) / std::pow(crown.radius_at(p.y), 2);
    return DVec3(height(p.y), (ring - hollow * hollow) / (1 - hollow * hollow), turn_of(p.x, p.z));
  };
}

TEST(CrownPoints, AreUniformInProfiles) {
  expect_uniform(place(kRoundCrown, {.count = kMany}), revolved(kRoundCrown, kRoundCrown.lowest()));
  const ProfileCrown cone(ProfileCrown::Profile{{1, 0}, {0, 3}});
  expect_uniform(place(cone, {.count = kMany}), revolved(cone, 0));
}

TEST(CrownPoints, AreUniformBetweenProfilesAtAzimuths) {
  // The radius is 1 in the north and 2 in the south, linear in between. The area up to azimuth a of the half turn is
  // the integral of (1 + a / pi)^2. As a share this is ((1 + t)^3 - 1) / 7 with t = a / pi.
  const ProfileCrown crown(ProfileCrown::Sides{{0, {{1, 0}, {1, 2}}}, {kPi, {{2, 0}, {2, 2}}}});
  expect_uniform(place(crown, {.count = kMany}), [&](Vec3 p) {
    const double azimuth = std::atan2(p.x, -p.z);
    const double t = std::abs(azimuth) / kPi;
    const double turn = (std::pow(1 + t, 3) - 1) / 7;
    const double ring = (double{p.x} * p.x + double{p.z} * p.z) / ((1 + t) * (1 + t));
    return DVec3(p.y / 2, ring, azimuth < 0 ? 0.5 - turn / 2 : 0.5 + turn / 2);
  });
}

TEST(CrownPoints, AreUniformInSolids) {
  const EllipsoidCrown ellipsoid({1, 2, 3}, {1, 2, 0.5F});
  expect_uniform(place(ellipsoid, {.count = kMany}), [](Vec3 p) {
    const DVec3 unit = (DVec3(p) - DVec3(1, 2, 3)) / DVec3(1, 2, 0.5);
    const double radius = std::sqrt(glm::dot(unit, unit));
    return DVec3(radius * radius * radius, (unit.y / radius + 1) / 2, turn_of(unit.x, unit.z));
  });
  const ConeCrown cone({0, 1, 0}, 2, 3);
  expect_uniform(place(cone, {.count = kMany}), [](Vec3 p) {
    const double from_apex = (4.0 - p.y) / 3;
    return DVec3(std::pow(from_apex, 3), (double{p.x} * p.x + double{p.z} * p.z) / std::pow(2 * from_apex, 2),
                 turn_of(p.x, p.z));
  });
  const BoxCrown box({{-1, 0, 2}, {1, 1, 7}});
  expect_uniform(place(box, {.count = kMany}), [](Vec3 p) { return DVec3((p.x + 1) / 2, p.y, (p.z - 2) / 5); });
}

TEST(CrownPoints, AreUniformInCombinations) {
  const auto box = [](Vec3 low, Vec3 high) { return std::make_shared<BoxCrown>(Box{low, high}); };
  // Two overlapping boxes, end to end.
  const CombinedCrown both(CombineKind::unite, {box({0, 0, 0}, {2, 1, 1}), box({1, 0, 0}, {5, 1, 1})});
  expect_uniform(place(both, {.count = kMany}), [](Vec3 p) { return DVec3(p.x / 5, p.y, p.z); });
  const CombinedCrown common(CombineKind::intersect, {box({0, 0, 0}, {2, 1, 1}), box({1, 0, 0}, {5, 1, 1})});
  expect_uniform(place(common, {.count = kMany}), [](Vec3 p) { return DVec3(p.x - 1, p.y, p.z); });
  // A hollow ball.
  const auto ball = [](float radius) { return std::make_shared<EllipsoidCrown>(Vec3(0), Vec3(radius)); };
  const CombinedCrown shell(CombineKind::subtract, {ball(2), ball(1)});
  expect_uniform(place(shell, {.count = kMany}), [](Vec3 p) {
    const double radius = glm::length(DVec3(p));
    return DVec3((std::pow(radius, 3) - 1) / 7, (p.y / radius + 1) / 2, turn_of(p.x, p.z));
  });
}

TEST(CrownPoints, AreUniformInMeshes) {
  TriangleMesh cube;
  for (int k = 0; k < 8; ++k) cube.positions.emplace_back(k & 1, k >> 1 & 1, k >> 2);
  cube.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  const DFrame frame{.axes = exact_rotation(glm::normalize(DVec3(1, 2, 3)), 1), .origin = {0, 2, 1}};
  const MeshCrown crown(std::make_shared<const ClosedMesh>(cube), frame);
  expect_uniform(place(crown, {.count = kMany}),
                 [&](Vec3 p) { return glm::transpose(frame.axes) * (DVec3(p) - frame.origin); });
}

TEST(CrownPoints, AreUniformInZones) {
  const double height = kRoundCrown.highest() - kRoundCrown.lowest();
  const double cut = kRoundCrown.lowest() + 0.4 * height;
  const auto points = [](CrownZone zone) {
    return place(kRoundCrown, {.count = kMany, .shares = {{.share = 1, .zone = zone}}});
  };
  expect_uniform(points({.above = 0.4}), revolved(kRoundCrown, cut));
  expect_uniform(points({.outer = 0.15}), revolved(kRoundCrown, kRoundCrown.lowest(), 0.85));
  expect_uniform(points({.above = 0.4, .outer = 0.15}), revolved(kRoundCrown, cut, 0.85));
}

TEST(CrownPoints, OuterZonesOfOtherBodiesAreMeasuredFromTheMiddleOfTheirBounds) {
  const BoxCrown box({{2, 0, -1}, {4, 1, 1}});
  for (const Vec3 point : place(box, {.count = 1000, .shares = {{.share = 1, .zone = {.outer = 0.25}}}})) {
    ASSERT_GT(std::max(std::abs(point.x - 3), std::abs(point.z)), 0.7499F);
  }
}

TEST(CrownPoints, SharesAreExact) {
  EXPECT_EQ(share_counts({.count = 10}), (std::vector<std::uint64_t>{10}));
  EXPECT_EQ(share_counts({.count = 1700, .shares = {{.share = 0.2}}}), (std::vector<std::uint64_t>{340, 1360}));
  EXPECT_EQ(share_counts({.count = 10, .shares = {{.share = 0.25}, {.share = 0.25}}}),
            (std::vector<std::uint64_t>{3, 2, 5}));
  EXPECT_EQ(share_counts({.count = 1, .shares = {{.share = 0.3}, {.share = 0.4}}}),
            (std::vector<std::uint64_t>{0, 1, 0}));
  // Ten tenths do not sum to exactly 1 in floating point, but no point must remain.
  const std::vector<std::uint64_t> tenths =
      share_counts({.count = 7, .shares = std::vector(10, PointDistribution::Share{.share = 0.1})});
  EXPECT_EQ(std::accumulate(tenths.begin(), tenths.end(), std::uint64_t{0}), 7U);
  EXPECT_EQ(tenths.back(), 0U);
}

TEST(CrownPoints, EachShareLiesInItsZone) {
  const PointDistribution distribution{
      .count = 5000, .shares = {{.share = 0.2, .zone = {.above = 0.4}}, {.share = 0.5, .zone = {.outer = 0.15}}}};
  const std::vector<Vec3> points = place(kRoundCrown, distribution);
  ASSERT_EQ(points.size(), 5000U);
  for (std::size_t k = 0; k < 1000; ++k) ASSERT_GE(points[k].y, 0.4 + 0.4 * 3.4 - 1e-5);
  for (std::size_t k = 1000; k < 3500; ++k) {
    ASSERT_GE(std::hypot(points[k].x, points[k].z), 0.8499 * kRoundCrown.radius_at(points[k].y));
  }
  for (const Vec3 point : points) ASSERT_TRUE(kRoundCrown.contains(point));
}

TEST(CrownPoints, TheKthPointDoesNotDependOnTheCount) {
  const std::vector<Vec3> few = place(kRoundCrown, {.count = 100});
  const std::vector<Vec3> many = place(kRoundCrown, {.count = 100'000});
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  EXPECT_NE(place(kRoundCrown, {.count = 100}, 6), few);
}

TEST(CrownPoints, AreTheSameOnAnyNumberOfThreads) {
  for (const bool blue_noise : {false, true}) {
    const PointDistribution distribution{
        .count = 30'000, .shares = {{.share = 0.4, .zone = {.outer = 0.2}}}, .blue_noise = blue_noise};
    const std::vector<Vec3> points = place(kRoundCrown, distribution);
    for (const int threads : {1, 2, 3, 8}) {
      const ThreadLimit limit(threads);
      EXPECT_EQ(place(kRoundCrown, distribution), points) << threads << " threads";
    }
  }
}

TEST(CrownPoints, CancelWhenAsked) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(sample_crown(kRoundCrown, 100'000, RandomKey(1), progress), Cancelled);
}

Diagnostic error(const Crown& crown, const PointDistribution& distribution) {
  try {
    place(crown, distribution);
  } catch (const InputError& error) {
    return error.diagnostics().at(0);
  }
  return {};
}

TEST(CrownPoints, EmptyCrownsAndZonesAreRejectedAtTheirPlace) {
  const auto ball = [](float x) { return std::make_shared<EllipsoidCrown>(Vec3(x, 0, 0), Vec3(1)); };
  const CombinedCrown apart(CombineKind::intersect, {ball(0), ball(3)});
  const CombinedCrown nothing(CombineKind::subtract, {ball(0), ball(0)});
  for (const Crown* crown : {static_cast<const Crown*>(&apart), static_cast<const Crown*>(&nothing)}) {
    EXPECT_FALSE(is_fillable(*crown));
    EXPECT_EQ(error(*crown, {.count = 10}).path, "crown");
    EXPECT_EQ(error(*crown, {.count = 10, .blue_noise = true}).path, "crown");
    EXPECT_TRUE(place(*crown, {.count = 0}).empty());
  }
  const ConeCrown cone(Vec3(0), 1, 1);
  EXPECT_TRUE(is_fillable(cone));
  const PointDistribution tip{.count = 10, .shares = {{.share = 0.1}, {.share = 0.5, .zone = {.above = 0.999}}}};
  EXPECT_EQ(error(cone, tip).path, "points.shares[1]");
}

// Returns the mean and the smallest distance to the nearest neighbour.
std::array<double, 2> neighbour_distances(const std::vector<Vec3>& points) {
  double sum = 0;
  double min = 1e9;
  for (std::size_t a = 0; a < points.size(); ++a) {
    double nearest = 1e9;
    for (std::size_t b = 0; b < points.size(); ++b) {
      if (a != b) nearest = std::min(nearest, glm::length(DVec3(points[a]) - DVec3(points[b])));
    }
    sum += nearest;
    min = std::min(min, nearest);
  }
  return {sum / static_cast<double>(points.size()), min};
}

TEST(BlueNoise, NeighboursKeepTheirDistance) {
  const auto [random_mean, random_min] = neighbour_distances(place(kRoundCrown, {.count = 3000}));
  const auto [mean, min] = neighbour_distances(place(kRoundCrown, {.count = 3000, .blue_noise = true}));
  EXPECT_LT(random_min / random_mean, 0.2);
  EXPECT_GT(min / mean, 0.75);
  EXPECT_GT(mean, 1.35 * random_mean);
}

TEST(BlueNoise, GivesTheExactNumberInEveryShare) {
  for (const std::uint64_t count : {1U, 2U, 77U, 5000U}) {
    const PointDistribution distribution{
        .count = count, .shares = {{.share = 0.7, .zone = {.outer = 0.15}}, {.share = 0.3}}, .blue_noise = true};
    const std::vector<Vec3> points = place(kRoundCrown, distribution);
    EXPECT_EQ(points.size(), count);
    for (const Vec3 point : points) ASSERT_TRUE(kRoundCrown.contains(point));
  }
}

TEST(BlueNoise, StaysUniformInVolume) {
  // Sums over large cells vary less than for random points, so only the upper bound is tested: 8 cells of equal volume.
  const BoxCrown box({Vec3(0), Vec3(2)});
  std::array<int, 8> hits{};
  for (const Vec3 point : place(box, {.count = 8000, .blue_noise = true})) {
    ++hits[static_cast<std::size_t>(point.x >= 1) + 2 * (point.y >= 1) + 4 * (point.z >= 1)];
  }
  for (const int hit : hits) EXPECT_NEAR(hit, 1000, 60);
}

TEST(BlueNoise, EndsWhereOnlyFewPlacesAreLeft) {
  // Far from the origin, floats are so coarse that not every point can have its own position.
  const BoxCrown box({Vec3(90'000), Vec3(90'000.03F)});
  EXPECT_EQ(place(box, {.count = 2000, .blue_noise = true}).size(), 2000U);
}

}  // namespace meristem::crown_points_test
