// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/solid/primitives.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/check_mesh.h"

namespace meristem::primitives_test {

/// Returns the area of a regular polygon with `n` corners on a circle of radius `r`.
double polygon_area(int n, double r) { return 0.5 * n * r * r * std::sin(2 * kPi / n); }
double polygon_side(int n, double r) { return 2 * r * std::sin(kPi / n); }

Box box_of(const Mesh& mesh) {
  Box box;
  for (const Vec3 position : mesh.positions) box.add(position);
  return box;
}

TEST(Primitives, BoxHasItsVolumeAndAreaAndStandsOnThePlane) {
  const Mesh box = make_box({2, 3, 5});
  EXPECT_TRUE(check_mesh(box));
  EXPECT_NEAR(signed_volume(box), 30, 1e-6);
  EXPECT_NEAR(surface_area(box), 62, 1e-6);
  EXPECT_EQ(euler_number(box), 2);
  EXPECT_EQ(box_of(box).low, Vec3(-1, 0, -2.5));
  EXPECT_EQ(box_of(box).high, Vec3(1, 3, 2.5));
}

TEST(Primitives, CylinderIsAPrismOverAPolygon) {
  for (const int n : {3, 4, 7, 32}) {
    const Mesh cylinder = make_cylinder(0.5, 2, n);
    EXPECT_TRUE(check_mesh(cylinder));
    EXPECT_NEAR(signed_volume(cylinder), 2 * polygon_area(n, 0.5), 1e-6);
    EXPECT_NEAR(surface_area(cylinder), 2 * polygon_area(n, 0.5) + 2 * n * polygon_side(n, 0.5), 1e-5);
    EXPECT_EQ(euler_number(cylinder), 2);
  }
}

TEST(Primitives, ConeIsAPyramidOverAPolygon) {
  for (const int n : {3, 5, 24}) {
    const Mesh cone = make_cone(0.5, 2, n);
    EXPECT_TRUE(check_mesh(cone));
    EXPECT_NEAR(signed_volume(cone), 2 * polygon_area(n, 0.5) / 3, 1e-6);
    const double slant = std::hypot(2, 0.5 * std::cos(kPi / n));
    EXPECT_NEAR(surface_area(cone), polygon_area(n, 0.5) + 0.5 * n * polygon_side(n, 0.5) * slant, 1e-5);
    EXPECT_EQ(euler_number(cone), 2);
  }
}

TEST(Primitives, SphereVolumeAndAreaConvergeAtSecondOrder) {
  const auto volume_error = [](int n) { return 4.0 / 3 * kPi * 8 - signed_volume(make_sphere(2, n)); };
  const auto area_error = [](int n) { return 4 * kPi * 4 - surface_area(make_sphere(2, n)); };
  for (const int n : {3, 4, 9, 32}) {
    EXPECT_TRUE(check_mesh(make_sphere(2, n)));
    EXPECT_EQ(euler_number(make_sphere(2, n)), 2);
  }
  EXPECT_NEAR(volume_error(32) / volume_error(64), 4, 0.1);
  EXPECT_NEAR(area_error(32) / area_error(64), 4, 0.1);
}

TEST(Primitives, SphereVerticesLieOnTheSphereAlongTheirNormals) {
  const Mesh sphere = make_sphere(2, 12);
  for (std::size_t i = 0; i < sphere.vertex_count(); ++i) {
    EXPECT_LT(glm::distance(sphere.positions[i], 2.0F * sphere.normals[i]), 1e-6);
  }
}

TEST(Primitives, TorusHasOneHoleAndPappusVolume) {
  const auto error = [](int n) { return 2 * kPi * kPi * 3 * 0.25 - signed_volume(make_torus(3, 0.5, n)); };
  for (const int n : {3, 8, 48}) {
    EXPECT_TRUE(check_mesh(make_torus(3, 0.5, n)));
    EXPECT_EQ(euler_number(make_torus(3, 0.5, n)), 0);
  }
  EXPECT_NEAR(error(64) / error(128), 4, 0.1);
  EXPECT_LT(std::abs(error(128)), 0.03);
}

TEST(Primitives, ScalingByTwoGivesFourTimesTheArea) {
  EXPECT_NEAR(surface_area(make_torus(2, 0.5, 16)) / surface_area(make_torus(1, 0.25, 16)), 4, 1e-5);
  EXPECT_NEAR(surface_area(make_cone(2, 4, 16)) / surface_area(make_cone(1, 2, 16)), 4, 1e-5);
}

TEST(Primitives, RejectSizesAndSegmentsThatMakeNoBody) {
  EXPECT_THROW(make_box({1, 0, 1}), std::invalid_argument);
  EXPECT_THROW(make_sphere(1, 2), std::invalid_argument);
  EXPECT_THROW(make_sphere(std::nan(""), 8), std::invalid_argument);
  EXPECT_THROW(make_cylinder(-1, 1, 8), std::invalid_argument);
  EXPECT_THROW(make_cone(1, INFINITY, 8), std::invalid_argument);
  EXPECT_THROW(make_torus(1, 1, 8), std::invalid_argument);
}

}  // namespace meristem::primitives_test
