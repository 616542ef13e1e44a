// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/light_of_points.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "tests/support/walled_scene.h"

namespace meristem::light_of_points_test {

constexpr double kNear = 1e-6;

TEST(LightOfPoints, FallsWithEachPointOnTheWay) {
  const std::vector<Vec3> column{{0, 1, 0}, {0, 3, 0}, {0, 2, 0}, {0.25F, 5, 0}, {0.6F, 9, 0}};
  const std::vector<double> light = light_of_points(column, Scene(), 0.3, 0.1, Progress());
  const std::vector<double> before{3, 1, 2, 0, 0};
  for (std::size_t k = 0; k < column.size(); ++k) EXPECT_NEAR(light[k], math::exp(-0.1 * before[k]), kNear) << k;
}

TEST(LightOfPoints, IsTheMeanOverTheLights) {
  Scene scene;
  scene.light.sun = {{Vec3(0, 1, 0), 0.5}, {Vec3(1, 0, 0), 0.25}};
  scene.light.sky = {{Vec3(-1, 0, 0), 0.25}};
  const std::vector<Vec3> points{{0, 1, 0}, {0, 2, 0}, {1, 1, 0}};
  const std::vector<double> light = light_of_points(points, scene, 0.3, 1, Progress());
  const double dimmed = math::exp(-1);
  EXPECT_NEAR(light[0], 0.5 * dimmed + 0.25 * dimmed + 0.25, kNear);
  EXPECT_NEAR(light[1], 1, kNear);
  EXPECT_NEAR(light[2], 0.5 + 0.25 + 0.25 * dimmed, kNear);
}

TEST(LightOfPoints, IsNoneInTheShadeOfAWall) {
  const std::vector<double> light =
      light_of_points({{0, 1, 0}, {0, 20, 0}}, walled_scene(kSouth), 0.3, 0.1, Progress());
  EXPECT_EQ(light[0], 0);
  EXPECT_EQ(light[1], 1);
}

// Tests all pairs with the exact lateral distance. Cells of a sixth of the radius may differ near its edge.
TEST(LightOfPoints, AgreesWithAllPairs) {
  std::vector<Vec3> points;
  const RandomKey key(7);
  for (std::uint64_t k = 0; k < 1500; ++k) {
    points.push_back(3.0F * Vec3(key.uniform(3 * k), key.uniform(3 * k + 1), key.uniform(3 * k + 2)) - Vec3(700, 0, 1));
  }
  const Scene scene = scene_under({1, 0.8});
  const Vec3 toward = scene.light.sun[0].toward;
  const std::vector<double> light = light_of_points(points, scene, 0.3, 0.1, Progress());
  double difference = 0;
  double mean = 0;
  for (std::size_t a = 0; a < points.size(); ++a) {
    int count = 0;
    for (const Vec3 other : points) {
      const Vec3 way = other - points[a];
      const float along = glm::dot(way, toward);
      count += along > 0 && glm::length(way - along * toward) <= 0.3F ? 1 : 0;
    }
    const double exact = math::exp(-0.1 * count);
    difference += std::abs(light[a] - exact);
    mean += light[a] - exact;
  }
  EXPECT_LT(difference / 1500, 0.02);
  EXPECT_LT(std::abs(mean) / 1500, 0.005);
}

TEST(LightOfPoints, IsTheSameOnAnyNumberOfThreads) {
  std::vector<Vec3> points;
  for (std::uint64_t k = 0; k < 1000; ++k) points.push_back(RandomKey(2).direction(k));
  Scene scene = walled_scene(kSouth);
  scene.light.sun = sun_of_day(0.9, 126, 0.5);
  const auto light_on = [&](int threads) {
    const ThreadLimit limit(threads);
    return light_of_points(points, scene, 0.3, 0.1, Progress());
  };
  const auto one = light_on(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(light_on(threads), one);
}

TEST(Brightest, LeavesOutTheDarkestShare) {
  const std::vector<double> light{0.5, 0.1, 0.9, 0.1, 0.7};
  EXPECT_EQ(brightest(light, 0), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(brightest(light, 0.2).size(), 4U);
  EXPECT_EQ(brightest(light, 0.5), (std::vector<std::uint32_t>{0, 2, 4}));
  EXPECT_EQ(brightest(light, 1), (std::vector<std::uint32_t>{}));
}

TEST(Brightest, DrawsLotsAmongEquallyDarkOnes) {
  const std::vector<double> dark(1000, 0.25);
  const std::vector<std::uint32_t> left = brightest(dark, 0.5);
  ASSERT_EQ(left.size(), 500U);
  const auto first_half = std::count_if(left.begin(), left.end(), [](std::uint32_t k) { return k < 500; });
  EXPECT_NEAR(static_cast<double>(first_half), 250, 50);
}

}  // namespace meristem::light_of_points_test
