// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/convex_hull.h"

#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "meristem/base/random.h"
#include "tests/support/check_mesh.h"

namespace meristem::convex_hull_test {

/// Returns the corners, edge points and inner points of a grid in a box.
std::vector<Vec3> box_grid(Vec3 size, Vec3 corner, int steps) {
  std::vector<Vec3> points;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      for (int k = 0; k <= steps; ++k) points.push_back(corner + size * Vec3(i, j, k) / static_cast<float>(steps));
    }
  }
  return points;
}

Vec3 on_sphere(std::uint64_t index) {
  const double y = 2 * RandomKey(3).uniform(2 * index) - 1;
  const double azimuth = 2 * kPi * RandomKey(3).uniform(2 * index + 1);
  const double radius = std::sqrt(1 - y * y);
  return {radius * math::cos(azimuth), y, radius * math::sin(azimuth)};
}

TEST(ConvexHull, BoxHasItsAreaAndVolume) {
  const Mesh hull = convex_hull(box_grid({2, 3, 4}, {1, -1, 5}, 4));
  EXPECT_TRUE(check_mesh(hull));
  EXPECT_EQ(euler_number(hull), 2);
  EXPECT_NEAR(surface_area_of(hull), 2 * (6 + 8 + 12), 1e-5);
  EXPECT_NEAR(volume_of(hull), 24, 1e-5);
}

TEST(ConvexHull, TetrahedronIsItsOwnHull) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2F, 0.2F, 0.2F}};
  const Mesh hull = convex_hull(points);
  EXPECT_TRUE(check_mesh(hull));
  EXPECT_EQ(hull.vertex_count(), 4U);
  EXPECT_EQ(hull.triangle_count(), 4U);
  EXPECT_NEAR(volume_of(hull), 1.0 / 6, 1e-12);
  EXPECT_NEAR(surface_area_of(hull), 1.5 + std::sqrt(3.0) / 2, 1e-12);
}

TEST(ConvexHull, HoldsEveryPoint) {
  std::vector<Vec3> points;
  for (std::uint64_t k = 0; k < 2000; ++k) points.push_back(on_sphere(k) * static_cast<float>(RandomKey(4).uniform(k)));
  const Mesh hull = convex_hull(points);
  EXPECT_TRUE(check_mesh(hull));
  ASSERT_GT(hull.triangle_count(), 100U);
  for (const auto& [a, b, c] : hull.triangles) {
    const DVec3 corner(hull.positions[a]);
    const DVec3 outward =
        glm::normalize(glm::cross(DVec3(hull.positions[b]) - corner, DVec3(hull.positions[c]) - corner));
    for (const Vec3 point : points) EXPECT_LT(glm::dot(outward, DVec3(point) - corner), 1e-6);
  }
}

TEST(ConvexHull, SphereIsApproachedFromInside) {
  std::vector<Vec3> points;
  for (std::uint64_t k = 0; k < 4000; ++k) points.push_back(on_sphere(k));
  const Mesh hull = convex_hull(points);
  EXPECT_TRUE(check_mesh(hull));
  EXPECT_EQ(hull.vertex_count(), 4000U);
  EXPECT_LT(volume_of(hull), 4 * kPi / 3);
  EXPECT_GT(volume_of(hull), 0.995 * 4 * kPi / 3);
  EXPECT_LT(surface_area_of(hull), 4 * kPi);
  EXPECT_GT(surface_area_of(hull), 0.995 * 4 * kPi);
}

TEST(ConvexHull, LargeCloudsAreThinnedFirst) {
  // A ball and eight corners that lie outside it.
  std::vector<Vec3> points;
  for (std::uint64_t k = 0; k < 50'000; ++k) points.push_back(on_sphere(k));
  for (int k = 0; k < 8; ++k) {
    points.insert(points.begin() + 6000 * k, Vec3((k & 1) != 0 ? 2 : -2, (k & 2) != 0 ? 2 : -2, (k & 4) != 0 ? 2 : -2));
  }
  const Mesh hull = convex_hull(points);
  EXPECT_TRUE(check_mesh(hull));
  EXPECT_EQ(hull.vertex_count(), 8U);
  EXPECT_NEAR(volume_of(hull), 64, 1e-9);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(convex_hull(points, &progress), Cancelled);
}

TEST(ConvexHull, LargeFlatCloudsHaveNone) {
  std::vector<Vec3> points;
  for (std::uint64_t k = 0; k < 30'000; ++k)
    points.emplace_back(RandomKey(1).uniform(k), 0.5F, RandomKey(2).uniform(k));
  EXPECT_EQ(convex_hull(points).triangle_count(), 0U);
}

TEST(ConvexHull, FarFromTheOriginNothingIsLost) {
  const Mesh hull = convex_hull(box_grid({2, 2, 2}, {4096, 0, -8192}, 2));
  EXPECT_NEAR(volume_of(hull), 8, 1e-9);
}

TEST(ConvexHull, FlatAndFewPointsHaveNone) {
  std::vector<Vec3> plane;
  std::vector<Vec3> tilted;
  std::vector<Vec3> line;
  for (int k = 0; k < 50; ++k) {
    const Vec3 point(k % 7, 0, k % 5);
    plane.push_back(point);
    tilted.emplace_back(point.x, 0.3F * point.x - 0.7F * point.z, point.z);
    line.emplace_back(0.1F * k, 0.2F * k, -0.3F * k);
  }
  for (const auto& points :
       {plane, tilted, line, std::vector<Vec3>(9, Vec3(1, 2, 3)), std::vector<Vec3>(3, Vec3(1)), std::vector<Vec3>{}}) {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    EXPECT_EQ(convex_hull(points).triangle_count(), 0U);
    EXPECT_EQ(testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout(), "");
  }
}

TEST(ConvexOutline, SquareKeepsItsCornersCounterClockwise) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 4; ++i) {
    for (int j = 0; j <= 4; ++j) points.emplace_back(i, j);
  }
  const std::vector<Vec2> outline = convex_outline(points);
  EXPECT_EQ(outline, (std::vector<Vec2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  const OutlineSize size = measure_outline(outline);
  EXPECT_DOUBLE_EQ(size.area, 16);
  EXPECT_DOUBLE_EQ(size.perimeter, 16);
  EXPECT_DOUBLE_EQ(size.diameter, 4 * std::sqrt(2.0));
}

TEST(ConvexOutline, PointsOnALineGiveItsEnds) {
  const std::vector<Vec2> outline = convex_outline({{1, 1}, {0, 0}, {3, 3}, {2, 2}, {0, 0}});
  EXPECT_EQ(outline, (std::vector<Vec2>{{0, 0}, {3, 3}}));
  const OutlineSize size = measure_outline(outline);
  EXPECT_EQ(size.area, 0);
  EXPECT_DOUBLE_EQ(size.perimeter, 2 * 3 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(size.diameter, 3 * std::sqrt(2.0));
  EXPECT_EQ(convex_outline({{2, 1}, {2, 1}}).size(), 1U);
  EXPECT_EQ(measure_outline(convex_outline({{2, 1}})).diameter, 0);
  EXPECT_EQ(measure_outline(convex_outline({})).perimeter, 0);
}

TEST(ConvexOutline, DiameterIsThatOfAllPairs) {
  for (std::uint64_t round = 0; round < 200; ++round) {
    const RandomKey key = RandomKey(9).child(round);
    std::vector<Vec2> points;
    for (std::uint64_t k = 0; k < 3 + round % 20; ++k) points.emplace_back(key.uniform(2 * k), key.uniform(2 * k + 1));
    double largest = 0;
    for (const Vec2 a : points) {
      for (const Vec2 b : points) largest = std::max(largest, glm::distance(glm::dvec2(a), glm::dvec2(b)));
    }
    EXPECT_DOUBLE_EQ(measure_outline(convex_outline(points)).diameter, largest) << "round " << round;
  }
}

}  // namespace meristem::convex_hull_test
