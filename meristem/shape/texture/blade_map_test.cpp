// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/texture/blade_map.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "meristem/base/parallel.h"

namespace meristem::blade_map_test {

constexpr int kPixels = 100;

double covered(const BladeMap& map) {
  return std::accumulate(map.cover.begin(), map.cover.end(), 0.0) / (kPixels * kPixels);
}

TextureShape circle() {
  TextureShape shape;
  for (int k = 0; k < 360; ++k) {
    const double angle = radians(k);
    shape.outline.emplace_back(0.5 + 0.4 * math::cos(angle), 0.5 + 0.4 * math::sin(angle));
  }
  return shape;
}

TEST(BladeMap, CoversThePolygonsArea) {
  EXPECT_NEAR(covered(BladeMap(TextureShape{}, kPixels)), 1, 1e-5);
  EXPECT_NEAR(covered(BladeMap(TextureShape{{{0.1F, 0.1F}, {0.9F, 0.1F}, {0.1F, 0.9F}}}, kPixels)), 0.32, 1e-4);
  EXPECT_NEAR(covered(BladeMap(circle(), kPixels)), kPi * 0.16, 2e-4);
}

TEST(BladeMap, RowsRunFromTopToBottom) {
  const BladeMap map({{{0, 0}, {1, 0}, {1, 0.5F}, {0, 0.5F}}}, kPixels);
  EXPECT_EQ(map.cover[50], 0);
  EXPECT_EQ(map.cover[99 * kPixels + 50], 1);
}

TEST(BladeMap, MarginsOfACircleGrowTowardItsCentre) {
  const BladeMap map(circle(), kPixels);
  EXPECT_NEAR(map.widest, 0.4, 0.015);
  for (int y = 0; y < kPixels; ++y) {
    for (int x = 0; x < kPixels; ++x) {
      const Vec2 position((static_cast<float>(x) + 0.5F) / kPixels, (static_cast<float>(y) + 0.5F) / kPixels);
      const float expected = std::max(0.0F, 0.4F - glm::distance(position, Vec2(0.5F)));
      ASSERT_NEAR(map.margin[static_cast<std::size_t>(y * kPixels + x)], expected, 0.012F) << x << " " << y;
    }
  }
}

TEST(BladeMap, MarginsAreMeasuredOnTheSurface) {
  // A square in uv that is a quarter as wide as high, so its middle is nearer to the sides.
  EXPECT_NEAR(BladeMap(TextureShape{.aspect = 0.25}, kPixels).widest, 0.125, 0.005);
}

TEST(BladeMap, TellsHowFarRowsAndTheMidribReach) {
  const BladeMap map({{{0.5F, 0.2F}, {0.9F, 0.5F}, {0.5F, 0.8F}, {0.1F, 0.5F}}}, kPixels);
  EXPECT_NEAR(map.midrib.low, 0.2F, 1e-5F);
  EXPECT_NEAR(map.midrib.high, 0.8F, 1e-5F);
  EXPECT_NEAR(map.rows[50].low, 0.1F, 0.015F);
  EXPECT_NEAR(map.rows[50].high, 0.9F, 0.015F);
  // Rows above and below have the values of the last row that the outline meets.
  EXPECT_EQ(map.rows[0].low, map.rows[19].low);
}

TEST(BladeMap, TakesAnOutlineThatEnclosesNothing) {
  const BladeMap map({{{0.5F, 0.5F}, {0.5F, 0.5F}}}, kPixels);
  EXPECT_EQ(covered(map), 0);
  EXPECT_EQ(map.widest, 0);
}

TEST(BladeMap, IsTheSameOnAnyNumberOfThreads) {
  std::vector<float> first;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    const BladeMap map(circle(), kPixels);
    if (first.empty()) first = map.margin;
    EXPECT_EQ(map.margin, first) << threads;
  }
}

}  // namespace meristem::blade_map_test
