// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/flat/cut_polygon.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "meristem/base/math.h"
#include "meristem/base/mesh.h"
#include "tests/support/check_mesh.h"

namespace meristem::cut_polygon_test {

using Points = std::vector<glm::dvec2>;

double area_of(const Points& corners) {
  double doubled = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}

/// Returns a mesh with separate vertices for each corner. check_mesh joins vertices at equal positions.
Mesh mesh_of(const std::vector<FlatTriangle>& triangles) {
  Mesh mesh;
  for (const FlatTriangle& triangle : triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
    for (const glm::dvec2 corner : triangle) {
      mesh.positions.emplace_back(corner, 0);
      mesh.normals.emplace_back(0, 0, 1);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

/// Returns true if a corner of one triangle lies inside an edge of another.
bool has_loose_corner(const std::vector<FlatTriangle>& triangles) {
  for (const FlatTriangle& triangle : triangles) {
    for (int k = 0; k < 3; ++k) {
      const glm::dvec2 a = triangle[k], b = triangle[(k + 1) % 3];
      for (const FlatTriangle& other : triangles) {
        for (const glm::dvec2 p : other) {
          const double along = glm::dot(p - a, b - a) / glm::dot(b - a, b - a);
          if (p != a && p != b && along > 0 && along < 1 && glm::distance(p, a + along * (b - a)) < 1e-12) return true;
        }
      }
    }
  }
  return false;
}

/// Returns a comb whose teeth hang from a beam, so that rows cross it many times.
Points comb(int teeth) {
  Points corners;
  for (int k = 0; k < teeth; ++k) {
    corners.insert(corners.end(), {{2.0 * k, 0}, {2.0 * k + 1, 0}});
    if (k + 1 < teeth) corners.insert(corners.end(), {{2.0 * k + 1, 3}, {2.0 * k + 2, 3}});
  }
  corners.insert(corners.end(), {{2.0 * teeth - 1, 4}, {0, 4}});
  return corners;
}

TEST(CutPolygon, ARectangleBetweenRowsAndColumnsHasTwoTrianglesACell) {
  const auto triangles = cut_polygon({{0, 0}, {3, 0}, {3, 2}, {0, 2}}, {{1}, {1, 2}});
  EXPECT_EQ(triangles.size(), 2U * 2 * 3);
  EXPECT_TRUE(check_mesh(mesh_of(triangles), {.closed = false, .outward = false}));
}

TEST(CutPolygon, CornersNearlyOnADiagonalLeaveNoGap) {
  for (const double off : {-1e-7, -1e-9, -1e-15, 0.0, 1e-15, 1e-9, 1e-7}) {
    // Without this offset, the third corner would lie on the line from the first to the fourth.
    const auto triangles = cut_polygon({{0, 0}, {2, 0}, {1 + off, 1}, {2, 2}, {0, 3}}, {});
    EXPECT_EQ(triangles.size(), 3U) << off;
  }
}

TEST(CutPolygon, AConcavePolygonKeepsItsArea) {
  const Points corners = comb(5);
  const CutLines lines{{1, 2, 3, 3.5}, {0.5, 1, 4.25}};
  const auto triangles = cut_polygon(corners, lines);
  EXPECT_TRUE(check_mesh(mesh_of(triangles), {.closed = false, .outward = false}));
  EXPECT_NEAR(surface_area(mesh_of(triangles)), area_of(corners), 1e-6);
  EXPECT_FALSE(has_loose_corner(triangles));
}

TEST(CutPolygon, NoTriangleReachesAcrossALine) {
  const auto triangles = cut_polygon(comb(3), {{0.7, 2}, {1.5}});
  for (const FlatTriangle& triangle : triangles) {
    for (const double row : {0.7, 2.0}) {
      const auto sides = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
      EXPECT_FALSE(sides.first < row && sides.second > row);
    }
    const auto sides = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
    EXPECT_FALSE(sides.first < 1.5 && sides.second > 1.5);
  }
}

TEST(CutPolygon, ACornerThatTouchesALineFromEitherSideIsACornerOnBoth) {
  // One bay from above that ends on the row, and one from below.
  const Points corners{{0, 0}, {1, 0}, {1.5, 1}, {2, 0}, {4, 0}, {4, 2}, {3.5, 2}, {3, 1}, {2.5, 2}, {0, 2}};
  const auto triangles = cut_polygon(corners, {{1}, {}});
  EXPECT_NEAR(surface_area(mesh_of(triangles)), area_of(corners), 1e-6);
  EXPECT_FALSE(has_loose_corner(triangles));
}

TEST(CutPolygon, ACornerCloseToALineCountsAsOnIt) {
  const Points corners{{0, 0}, {1, 0}, {1, 0.50001}, {1, 1}, {0, 1}};
  EXPECT_EQ(cut_polygon(corners, {{0.5}, {}, 1e-3}).size(), 4U);
  EXPECT_EQ(cut_polygon(corners, {{0.5}, {}, 1e-6}).size(), 5U);
}

RC_GTEST_PROP(CutPolygon, AnyStarIsCutWithoutGapsOrOverlap, ()) {
  const int count = *rc::gen::inRange(3, 40);
  Points corners;
  for (int k = 0; k < count; ++k) {
    const double radius = *rc::gen::inRange(100, 1001) / 1000.0;
    const double angle = 2 * kPi * k / count;
    corners.emplace_back(radius * math::cos(angle), radius * math::sin(angle));
  }
  CutLines lines;
  for (int k = 1; k < *rc::gen::inRange(1, 9); ++k) lines.rows.push_back(-1 + 0.25 * k);
  for (int k = 1; k < *rc::gen::inRange(1, 9); ++k) lines.columns.push_back(-1 + 0.25 * k);
  const auto triangles = cut_polygon(corners, lines);
  RC_ASSERT(check_mesh(mesh_of(triangles), {.closed = false, .outward = false}));
  RC_ASSERT(std::abs(surface_area(mesh_of(triangles)) - area_of(corners)) < 1e-4);
  RC_ASSERT(!has_loose_corner(triangles));
}

TEST(CutPolygon, APolygonThatCrossesItselfEndsInSomeTriangles) {
  const auto triangles = cut_polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {{0.3, 0.7}, {0.5}});
  EXPECT_LE(triangles.size(), 20U);
}

TEST(CutPolygon, CrossingsAndTouchingsAreFound) {
  EXPECT_FALSE(crosses_itself({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_FALSE(crosses_itself(comb(30)));
  EXPECT_TRUE(crosses_itself({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
  EXPECT_TRUE(crosses_itself({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));
}

}  // namespace meristem::cut_polygon_test
