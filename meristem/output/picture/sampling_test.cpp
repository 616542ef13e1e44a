// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/sampling.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace meristem {
namespace {

TEST(Sampling, PermutationTakesEveryPlaceOnce) {
  for (const std::uint32_t count : {1U, 2U, 7U, 64U, 100U}) {
    std::set<std::uint32_t> places;
    for (std::uint32_t i = 0; i < count; ++i) places.insert(permuted(i, count, 12345));
    EXPECT_EQ(places.size(), count);
    EXPECT_LT(*places.rbegin(), count);
  }
}

TEST(Sampling, ThePairsOfAPixelSpreadEvenly) {
  // Of 64 points each eighth of either axis holds 8 on average; random points would often miss by 4 and more.
  for (std::uint32_t pixel = 0; pixel < 20; ++pixel) {
    int columns[8] = {};
    int rows[8] = {};
    for (std::uint32_t s = 0; s < 64; ++s) {
      SampleStream stream(pixel, s, 64);
      stream.next();
      const Vec2 point = stream.next();
      ++columns[static_cast<int>(8 * point.x)];
      ++rows[static_cast<int>(8 * point.y)];
    }
    for (const int count : columns) EXPECT_NEAR(count, 8, 2);
    for (const int count : rows) EXPECT_NEAR(count, 8, 2);
  }
}

TEST(Sampling, DiscPointsLieOnTheDiscEvenly) {
  Vec2 mean(0);
  float square = 0;
  constexpr int kCount = 4096;
  for (std::uint32_t s = 0; s < kCount; ++s) {
    const Vec2 point = disc_point(SampleStream(1, s, kCount).next());
    EXPECT_LE(glm::length(point), 1);
    mean += point / static_cast<float>(kCount);
    square += glm::dot(point, point) / kCount;
  }
  EXPECT_NEAR(mean.x, 0, 0.01);
  EXPECT_NEAR(mean.y, 0, 0.01);
  EXPECT_NEAR(square, 0.5, 0.01);  // the mean of r^2 over a unit disc
}

TEST(Sampling, CosineDirectionsAreUnitAndHaveTheMeanOfTheirDensity) {
  for (const Vec3 normal : {Vec3(0, 1, 0), Vec3(0, 0, -1), glm::normalize(Vec3(1, -2, 3))}) {
    Vec3 mean(0);
    constexpr int kCount = 4096;
    for (std::uint32_t s = 0; s < kCount; ++s) {
      const Vec3 direction = cosine_direction(normal, SampleStream(2, s, kCount).next());
      EXPECT_NEAR(glm::length(direction), 1, 1e-5);
      EXPECT_GE(glm::dot(direction, normal), -1e-6F);
      mean += direction / static_cast<float>(kCount);
    }
    EXPECT_LT(glm::distance(mean, 2.0F / 3.0F * normal), 0.01);
  }
}

TEST(Sampling, ConeDirectionsStayInTheCone) {
  const Vec3 axis = glm::normalize(Vec3(1, 2, -2));
  for (std::uint32_t s = 0; s < 256; ++s) {
    const Vec3 direction = cone_direction(axis, 0.01, SampleStream(3, s, 256).next());
    EXPECT_LE(glm::length(glm::cross(direction, axis)), 0.01001F);
  }
}

}  // namespace
}  // namespace meristem
