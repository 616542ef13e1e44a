// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/sampling.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace meristem::sampling_test {

/// Returns the number of points of the third pair of dimensions in each of `columns` x `rows` equal cells.
std::vector<int> counts_by_cell(std::uint32_t pixel, std::uint32_t begin, std::uint32_t end, int columns, int rows) {
  std::vector<int> counts(static_cast<std::size_t>(columns) * rows);
  for (std::uint32_t s = begin; s < end; ++s) {
    SampleStream stream(pixel, s, 64);
    stream.next();
    stream.next();
    const Vec2 point = stream.next();
    ++counts[static_cast<int>(static_cast<float>(rows) * point.y) * columns +
             static_cast<int>(static_cast<float>(columns) * point.x)];
  }
  return counts;
}

TEST(Sampling, EveryCellOfEveryShapeHasOnePointOfAPixel) {
  for (std::uint32_t pixel = 0; pixel < 20; ++pixel) {
    for (const int columns : {1, 2, 4, 8, 16, 32, 64}) {
      for (const int count : counts_by_cell(pixel, 0, 64, columns, 64 / columns)) ASSERT_EQ(count, 1);
    }
  }
}

TEST(Sampling, SoDoTheFirstSamplesOfAPixelAndThoseThatFollow) {
  for (std::uint32_t pixel = 0; pixel < 20; ++pixel) {
    for (const std::uint32_t begin : {0U, 8U, 16U}) {
      for (const int columns : {1, 2, 4, 8}) {
        for (const int count : counts_by_cell(pixel, begin, begin + 8, columns, 8 / columns)) ASSERT_EQ(count, 1);
      }
    }
  }
}

TEST(Sampling, FourPixelsShareTheirCells) {
  for (const std::uint32_t first : {0U, 4U, 40U}) {
    std::vector<int> counts(256);
    for (std::uint32_t pixel = first; pixel < first + 4; ++pixel) {
      const std::vector<int> more = counts_by_cell(pixel, 0, 64, 16, 16);
      for (std::size_t k = 0; k < counts.size(); ++k) counts[k] += more[k];
    }
    for (const int count : counts) ASSERT_EQ(count, 1);
  }
}

TEST(Sampling, DimensionsAreUnrelated) {
  double product = 0;
  constexpr int kCount = 4096;
  for (std::uint32_t s = 0; s < kCount; ++s) {
    SampleStream stream(3, s, kCount);
    const Vec2 a = stream.next();
    const Vec2 b = stream.next();
    product += (a.x - 0.5) * (b.x - 0.5) / kCount;
  }
  EXPECT_NEAR(product, 0, 0.005);  // 1/12 for equal dimensions; random pairs deviate by 0.0013
}

TEST(Sampling, PixelsThatAreNumberedNextToEachOtherAreNeighbours) {
  EXPECT_EQ(pixel_number(0, 0), 0U);
  EXPECT_EQ(pixel_number(1, 0), 1U);
  EXPECT_EQ(pixel_number(0, 1), 2U);
  EXPECT_EQ(pixel_number(3, 5), 39U);
  EXPECT_EQ(pixel_number(16383, 16383), (1U << 28) - 1);
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
  EXPECT_NEAR(square, 0.5, 0.01);  // mean of r^2 over a unit disc
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

}  // namespace meristem::sampling_test
