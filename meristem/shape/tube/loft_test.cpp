// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/tube/loft.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "tests/support/check_mesh.h"

namespace meristem::loft_test {

// Returns a ring that runs counter-clockwise seen from above.
LoftSection ring(int points, double radius, double height, bool is_round = true) {
  LoftSection section{.is_round = is_round};
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * kPi * k / points;
    section.points.emplace_back(radius * math::sin(angle), height, radius * math::cos(angle));
  }
  return section;
}

LoftSection row(std::vector<Vec3> points) { return {.points = std::move(points), .is_closed = false}; }
LoftSection tip(Vec3 point) { return {.points = {point}}; }

// Returns the area of a regular polygon.
double polygon_area(int corners, double radius) {
  return 0.5 * corners * radius * radius * math::sin(2 * kPi / corners);
}

TEST(Loft, EqualRingsAreAPrism) {
  const Mesh mesh = make_loft(std::vector{ring(24, 2, 0), ring(24, 2, 3)}).mesh;
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_EQ(euler_number(mesh), 2);
  EXPECT_NEAR(signed_volume(mesh), 3 * polygon_area(24, 2), 1e-4);
}

TEST(Loft, ARingAndAPointAreAPyramid) {
  for (const bool is_up : {true, false}) {
    const Mesh mesh = is_up ? make_loft(std::vector{ring(12, 1, 0), tip({0, 6, 0})}).mesh
                            : make_loft(std::vector{tip({0, -6, 0}), ring(12, 1, 0)}).mesh;
    EXPECT_TRUE(check_mesh(mesh));
    EXPECT_EQ(euler_number(mesh), 2);
    EXPECT_NEAR(signed_volume(mesh), 2 * polygon_area(12, 1), 1e-4);
  }
}

TEST(Loft, RingsOfManySizesAreAFrustum) {
  std::vector<LoftSection> sections;
  for (int k = 0; k <= 10; ++k) sections.push_back(ring(64, 1 - 0.05 * k, 0.3 * k));
  const Mesh mesh = make_loft(sections).mesh;
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_NEAR(signed_volume(mesh), 3 * polygon_area(64, 1) * (1 + 0.5 + 0.25) / 3, 1e-4);
}

TEST(Loft, RingsWithDifferentNumbersOfPointsAreClosed) {
  for (const auto& [below, above] : {std::pair(3, 17), std::pair(40, 5), std::pair(8, 9), std::pair(100, 7)}) {
    const Mesh mesh = make_loft(std::vector{ring(below, 1, 0), ring(above, 1, 2), ring(below, 1, 4)}).mesh;
    EXPECT_TRUE(check_mesh(mesh)) << below << " " << above;
    EXPECT_EQ(euler_number(mesh), 2);
    const double thin = std::min(polygon_area(below, 1), polygon_area(above, 1));
    EXPECT_GT(signed_volume(mesh), 4 * thin * 0.99);
    EXPECT_LT(signed_volume(mesh), 4 * kPi);
  }
}

TEST(Loft, FacesOutwardWhicheverWayTheRingsRun) {
  std::vector<LoftSection> sections{ring(16, 1, 0), ring(16, 1, 2)};
  for (LoftSection& section : sections) std::reverse(section.points.begin(), section.points.end());
  const Mesh mesh = make_loft(sections).mesh;
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_NEAR(signed_volume(mesh), 2 * polygon_area(16, 1), 1e-4);
}

TEST(Loft, ACupIsClosedAndHollow) {
  const Mesh mesh = make_loft(std::vector{ring(32, 1, 0), ring(32, 1, 2), ring(32, 0.9, 2), ring(32, 0.9, 0.1)}).mesh;
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_NEAR(signed_volume(mesh), 2 * polygon_area(32, 1) - 1.9 * polygon_area(32, 0.9), 1e-4);
}

TEST(Loft, NormalsOfACylinderAreItsOwn) {
  const Mesh mesh = make_loft(std::vector{ring(12, 1, 0), ring(12, 1, 1), ring(12, 1, 3)}, {false, false}).mesh;
  EXPECT_TRUE(check_mesh(mesh, {.closed = false}));
  for (std::size_t k = 0; k < mesh.vertex_count(); ++k) {
    const Vec3 outward = mesh.positions[k] * Vec3(1, 0, 1);
    EXPECT_LT(glm::distance(mesh.normals[k], outward), 1e-5F) << k;
  }
}

TEST(Loft, CornersAreSharpUnlessTheSectionIsRound) {
  const auto flat_faces = [](bool is_round) {
    const Mesh mesh = make_loft(std::vector{ring(4, 1, 0, is_round), ring(4, 1, 1, is_round)}, {false, false}).mesh;
    int flat = 0;
    for (const auto& triangle : mesh.triangles) {
      const Vec3 a = mesh.positions[triangle[0]];
      const Vec3 face = glm::normalize(glm::cross(mesh.positions[triangle[1]] - a, mesh.positions[triangle[2]] - a));
      if (glm::distance(mesh.normals[triangle[0]], face) < 1e-5F) ++flat;
    }
    return flat;
  };
  EXPECT_EQ(flat_faces(false), 8);
  EXPECT_EQ(flat_faces(true), 0);
}

TEST(Loft, RowsFaceTheSideFromWhichTheyRunToTheRight) {
  const Mesh mesh =
      make_loft(std::vector{row({{-1, 0, 0}, {1, 0, 0}}), row({{-1, 2, 0}, {0, 2, 0}, {1, 2, 0}}), tip({0, 3, 0})})
          .mesh;
  EXPECT_TRUE(check_mesh(mesh, {.closed = false}));
  EXPECT_NEAR(surface_area(mesh), 5, 1e-5);
  for (const Vec3 normal : mesh.normals) EXPECT_LT(glm::distance(normal, Vec3(0, 0, 1)), 1e-5F);
}

TEST(Loft, ARingOpensIntoARow) {
  LoftSection arc = row({});
  for (int k = 0; k <= 12; ++k) {
    const double angle = radians(30 + 25.0 * k);
    arc.points.emplace_back(math::sin(angle), 2, math::cos(angle));
  }
  const Mesh mesh = make_loft(std::vector{ring(9, 0.5, 0), ring(9, 0.5, 1), arc}, {false, false}).mesh;
  EXPECT_TRUE(check_mesh(mesh, {.closed = false}));
  for (std::size_t k = 0; k < mesh.vertex_count(); ++k) {
    EXPECT_GT(glm::dot(mesh.normals[k], mesh.positions[k] * Vec3(1, 0, 1)), 0) << k;
  }
}

TEST(Loft, UvsRunFromZeroToOneBothWays) {
  const Mesh mesh = make_loft(std::vector{ring(8, 1, 0), ring(8, 1, 1), ring(8, 1, 4)}, {false, false}).mesh;
  ASSERT_EQ(mesh.vertex_count(), 27U);
  for (std::uint32_t k = 0; k < 27; ++k) {
    EXPECT_NEAR(mesh.uvs[k].x, (k % 9) / 8.0, 1e-6);
    EXPECT_NEAR(mesh.uvs[k].y, mesh.positions[k].y / 4, 1e-6);
  }
}

TEST(Loft, TrianglesBelongToTheUpperOfTheirSections) {
  const Loft loft = make_loft(std::vector{ring(6, 1, 0), ring(6, 1, 1), ring(6, 1, 2)});
  ASSERT_EQ(loft.first_triangle.size(), 4U);
  EXPECT_EQ(loft.first_triangle.back(), loft.mesh.triangle_count());
  for (std::uint32_t k = 0; k < 3; ++k) {
    for (std::uint32_t t = loft.first_triangle[k]; t < loft.first_triangle[k + 1]; ++t) {
      float highest = 0;
      for (const std::uint32_t vertex : loft.mesh.triangles[t]) {
        highest = std::max(highest, loft.mesh.positions[vertex].y);
      }
      EXPECT_EQ(highest, static_cast<float>(k));
    }
  }
}

TEST(Loft, CapsWithBaysStayInside) {
  LoftSection star;
  for (int k = 0; k < 10; ++k) {
    const double angle = 2 * kPi * k / 10;
    const double radius = k % 2 == 0 ? 1 : 0.3;
    star.points.emplace_back(3 + radius * math::sin(angle), 0, radius * math::cos(angle));
  }
  LoftSection hook{
      .points = {{0, 0, 0}, {4, 0, 0}, {4, 0, -4}, {0, 0, -4}, {0, 0, -3}, {3, 0, -3}, {3, 0, -1}, {0, 0, -1}}};
  for (LoftSection& section : std::vector{star, hook}) {
    LoftSection above = section;
    for (Vec3& point : above.points) point.y = 1;
    const Mesh mesh = make_loft(std::vector{section, above}).mesh;
    EXPECT_TRUE(check_mesh(mesh));
  }
  LoftSection above = hook;
  for (Vec3& point : above.points) point.y = 1;
  EXPECT_NEAR(signed_volume(make_loft(std::vector{hook, above}).mesh), 10, 1e-5);
}

TEST(Loft, ASingleRingIsADiscAndASingleRowNothing) {
  const Mesh disc = make_loft(std::vector{ring(16, 1, 0)}).mesh;
  EXPECT_TRUE(check_mesh(disc, {.closed = false}));
  EXPECT_NEAR(surface_area(disc), polygon_area(16, 1), 1e-5);
  EXPECT_GT(disc.normals.at(0).y, 0.999F);
  EXPECT_EQ(make_loft(std::vector{row({{0, 0, 0}, {1, 0, 0}})}).mesh.triangle_count(), 0U);
  EXPECT_EQ(make_loft({}).mesh.triangle_count(), 0U);
}

TEST(Loft, SectionsThatTouchLeaveNoSlivers) {
  LoftSection lifted = ring(12, 1, 1);
  for (Vec3& point : lifted.points) point.y += 1e-7F;
  const Mesh mesh = make_loft(std::vector{ring(12, 1, 0), ring(12, 1, 1), lifted, ring(12, 0.5, 2)}).mesh;
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_EQ(euler_number(mesh), 2);
}

TEST(Loft, FaultsNameTheirPoint) {
  const auto error_at = [](std::vector<Vec3> points, bool is_closed) {
    return find_error({.points = std::move(points), .is_closed = is_closed}).value().point;
  };
  EXPECT_EQ(error_at({}, true), std::nullopt);
  EXPECT_EQ(error_at({{0, 0, 0}, {1, 0, 0}}, true), std::nullopt);
  EXPECT_EQ(error_at({{0, 0, 0}, {1, 0, 0}, {std::numeric_limits<float>::infinity(), 0, 1}}, true), 2U);
  EXPECT_EQ(error_at({{0, 0, 0}, {0, 0, 0}}, false), 1U);
  EXPECT_EQ(error_at({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 0}}, true), 3U);
  EXPECT_EQ(error_at({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, true), std::nullopt);
  EXPECT_EQ(error_at({{0, 0, 0}, {2, 0, 2}, {2, 0, 0}, {0, 0, 1}}, true), std::nullopt);
  EXPECT_EQ(error_at(std::vector<Vec3>(1001), false), 1000U);
  EXPECT_FALSE(find_error(ring(3, 1, 0)));
  EXPECT_FALSE(find_error(tip({0, 0, 0})));
  EXPECT_FALSE(find_error(row({{0, 0, 0}, {1, 0, 0}})));
  EXPECT_THROW(make_loft(std::vector{LoftSection{}}), std::invalid_argument);
}

}  // namespace meristem::loft_test
