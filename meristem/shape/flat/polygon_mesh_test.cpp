// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/flat/polygon_mesh.h"

#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "tests/support/check_mesh.h"

namespace meristem::polygon_mesh_test {

TEST(MakePolygon, KeepsTheCornersAndLooksUp) {
  const std::vector<Vec3> hexagon{{0, 0, 0}, {-1, 1, 0}, {-1, 2, 0}, {0, 3, 0}, {1, 2, 0}, {1, 1, 0}};
  const Mesh mesh = make_polygon(hexagon);
  EXPECT_EQ(mesh.vertex_count(), 6U);
  EXPECT_EQ(mesh.triangle_count(), 4U);
  EXPECT_NEAR(surface_area(mesh), 4, 1e-6);
  for (const Vec3 normal : mesh.normals) EXPECT_GT(normal.z, 0.999F);
  for (const auto& [a, b, c] : mesh.triangles) {
    EXPECT_GT(glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).z, 0);
  }
  for (std::size_t k = 0; k < mesh.vertex_count(); ++k) EXPECT_NEAR(mesh.uvs[k].y, mesh.positions[k].y / 3, 1e-6);
}

TEST(MakePolygon, HasNothingWithoutArea) {
  EXPECT_EQ(make_polygon({}).vertex_count(), 0U);
  EXPECT_EQ(make_polygon(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}).vertex_count(), 0U);
  EXPECT_EQ(make_polygon(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}}).vertex_count(), 0U);
}

TEST(MakePolygon, CountsRepeatedCornersOnce) {
  const Mesh mesh = make_polygon(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}});
  EXPECT_EQ(mesh.vertex_count(), 4U);
  EXPECT_NEAR(surface_area(mesh), 1, 1e-6);
}

TEST(MakePolygon, BendsWithItsCorners) {
  const std::vector<Vec3> saddle{{0, 0, 0}, {1, 0, 0.3F}, {1, 1, 0}, {0, 1, 0.3F}};
  const Mesh mesh = make_polygon(saddle);
  ASSERT_EQ(mesh.vertex_count(), 4U);
  for (const Vec3 position : mesh.positions) EXPECT_NE(std::ranges::find(saddle, position), saddle.end());
}

TEST(MakePolygon, FillsALargeStarWithoutGaps) {
  std::vector<Vec3> star;
  constexpr int kPoints = 1000;
  for (int k = 0; k < 2 * kPoints; ++k) {
    const double angle = k * kPi / kPoints;
    const double radius = k % 2 == 0 ? 1 : 0.6;
    star.emplace_back(radius * math::cos(angle), radius * math::sin(angle), 0);
  }
  const Mesh mesh = make_polygon(star);
  EXPECT_NEAR(surface_area(mesh), kPoints * 0.6 * std::sin(kPi / kPoints), 1e-4);
}

}  // namespace meristem::polygon_mesh_test
