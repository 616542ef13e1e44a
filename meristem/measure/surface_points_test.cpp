// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/surface_points.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/shape/solid/primitives.h"

namespace meristem::surface_points_test {

TEST(SurfacePoints, TrianglesGetPlacesInProportionToTheirArea) {
  const Mesh box = make_box({1, 2, 3});
  const SurfacePoints places(box);
  EXPECT_NEAR(places.area(), 22, 1e-5);
  constexpr int kCount = 2200;
  std::vector<int> counts(box.triangle_count(), 0);
  for (int k = 0; k < kCount; ++k) ++counts[places.at((k + 0.5) / kCount, 0.5).triangle];
  for (std::size_t t = 0; t < box.triangle_count(); ++t) {
    const auto [a, b, c] = box.triangles[t];
    const Vec3 twice = glm::cross(box.positions[b] - box.positions[a], box.positions[c] - box.positions[a]);
    EXPECT_NEAR(counts[t], kCount / 22 * glm::length(twice) / 2, 1) << t;
  }
}

TEST(SurfacePoints, AreEvenWithinATriangle) {
  // The mean of even positions is the centroid. Their second moments equal those of the triangle: 1/6 for the square of
  // a weight.
  Mesh triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  const SurfacePoints places(triangle);
  constexpr int kCount = 10'000;
  DVec3 sum(0);
  DVec3 squares(0);
  for (int k = 0; k < kCount; ++k) {
    const Vec3 weights = places.at((k + 0.5) / kCount, fraction(k * kGoldenStep)).weights;
    EXPECT_GE(std::min({weights.x, weights.y, weights.z}), 0);
    EXPECT_NEAR(weights.x + weights.y + weights.z, 1, 1e-6);
    sum += DVec3(weights);
    squares += DVec3(weights * weights);
  }
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(sum[c] / kCount, 1.0 / 3, 1e-3);
    EXPECT_NEAR(squares[c] / kCount, 1.0 / 6, 1e-3);
  }
}

TEST(SurfacePoints, OfOneSideAreOnTrianglesThatFaceIt) {
  const Mesh box = make_box({1, 2, 3});
  const SurfacePoints top(box, DVec3(0, 1, 0));
  EXPECT_NEAR(top.area(), 3, 1e-6);
  for (const double along : {0.0, 0.3, 0.999999999}) EXPECT_EQ(top.position(top.at(along, 0.7)).y, 2);
}

TEST(SurfacePoints, FlatTrianglesHaveNone) {
  Mesh line;
  line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.triangles = {{0, 1, 2}};
  EXPECT_EQ(SurfacePoints(line).area(), 0);
}

TEST(Fraction, IsFromZeroToOne) {
  EXPECT_EQ(fraction(2.25), 0.25);
  EXPECT_EQ(fraction(-0.25), 0.75);
  EXPECT_EQ(fraction(3), 0);
}

}  // namespace meristem::surface_points_test
