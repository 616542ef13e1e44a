// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/obstacle/closed_mesh.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "meristem/base/frame.h"
#include "meristem/base/random.h"
#include "meristem/scene/crown/mesh_crown.h"
#include "tests/support/sample_bodies.h"

namespace meristem::closed_mesh_test {

// A cube, two triangles per side.
TriangleMesh cube(DVec3 low = DVec3(0), double size = 1) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k) mesh.positions.push_back(low + size * DVec3(k & 1, k >> 1 & 1, k >> 2));
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

DVec3 random_point(std::uint64_t index, double reach) {
  const RandomKey key(11);
  const DVec3 share(key.uniform(index, 0), key.uniform(index, 1), key.child(1).uniform(index));
  return (2.0 * share - 1.0) * reach;
}

TEST(ClosedMesh, SphereHasItsPointsAndVolume) {
  const ClosedMesh mesh(sphere_mesh(5));
  EXPECT_NEAR(mesh.volume(), 4 * kPi / 3, 0.01);
  for (std::uint64_t k = 0; k < 50'000; ++k) {
    const DVec3 point = random_point(k, 1.2);
    const double distance = glm::length(point);
    if (0.998 < distance && distance < 1) continue;  // between the facets and the sphere
    ASSERT_EQ(mesh.winding_number(point), distance < 1 ? 1 : 0);
  }
}

TEST(ClosedMesh, PointsOverEdgesVerticesAndInPlanesOfFacesAreDecidedOnce) {
  // Each lattice point in a grid of cubes is inside exactly one cube, also if it lies on faces, edges or corners.
  const std::vector<double> steps{0, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75};
  std::vector<ClosedMesh> cubes;
  for (int k = 0; k < 8; ++k) cubes.emplace_back(joined(cube(DVec3(k & 1, k >> 1 & 1, k >> 2)), cube(DVec3(-1), 4)));
  for (const double x : steps) {
    for (const double y : steps) {
      for (const double z : steps) {
        int holders = 0;
        // The cube around all of them gives every mesh equal bounds, hence an equal grid.
        for (const ClosedMesh& each : cubes) holders += each.winding_number({x, y, z}) - 1;
        EXPECT_EQ(holders, 1) << x << ' ' << y << ' ' << z;
      }
    }
  }
}

TEST(ClosedMesh, PointsUnderVerticesOfASphereAreInside) {
  const TriangleMesh mesh = sphere_mesh(3);
  const ClosedMesh closed(mesh);
  for (const DVec3 vertex : mesh.positions) {
    EXPECT_TRUE(closed.contains({vertex.x * 0.999, 0, vertex.z * 0.999}));
    EXPECT_TRUE(closed.contains(0.99 * vertex));
    EXPECT_FALSE(closed.contains(1.01 * vertex));
    if (vertex.y > 0.1) {
      EXPECT_TRUE(closed.contains({vertex.x, vertex.y - 0.01, vertex.z}));
      EXPECT_FALSE(closed.contains({vertex.x, vertex.y + 0.01, vertex.z}));
    }
  }
}

TEST(ClosedMesh, TurnedCubesHaveTheirAnalyticInside) {
  for (std::uint64_t turn = 0; turn < 20; ++turn) {
    const Mat3 axes = rotation(RandomKey(5).direction(turn), 6 * RandomKey(6).uniform(turn));
    TriangleMesh mesh = cube(DVec3(-0.5));
    for (DVec3& position : mesh.positions) position = DVec3(axes * Vec3(position));
    const ClosedMesh closed(mesh);
    EXPECT_NEAR(closed.volume(), 1, 1e-5);
    for (std::uint64_t k = 0; k < 2000; ++k) {
      const DVec3 point = random_point(k, 0.9);
      const Vec3 local = glm::transpose(axes) * Vec3(point);
      const float outside = std::max({std::abs(local.x), std::abs(local.y), std::abs(local.z)}) - 0.5F;
      ASSERT_TRUE(std::abs(outside) < 1e-5F || closed.contains(point) == (outside < 0));
    }
  }
}

TEST(ClosedMesh, InsideIsWhereTheSurfaceWindsAroundThePoint) {
  TriangleMesh inner = sphere_mesh(3, 0.5);
  const ClosedMesh doubled(joined(sphere_mesh(3), inner));
  EXPECT_EQ(doubled.winding_number(DVec3(0)), 2);
  EXPECT_TRUE(doubled.contains(DVec3(0)));
  turn_over(inner);
  const ClosedMesh hollow(joined(sphere_mesh(3), inner));
  EXPECT_FALSE(hollow.contains(DVec3(0)));
  EXPECT_TRUE(hollow.contains({0.7, 0, 0}));
  EXPECT_NEAR(hollow.volume(), ClosedMesh(sphere_mesh(3)).volume() * 7 / 8, 1e-9);
  TriangleMesh inside_out = sphere_mesh(3);
  turn_over(inside_out);
  const ClosedMesh turned(inside_out);
  EXPECT_EQ(turned.winding_number(DVec3(0)), -1);
  EXPECT_TRUE(turned.contains(DVec3(0)));
}

TEST(ClosedMesh, ManyLargeTrianglesAreNoBurden) {
  // Ten thousand nested cubes: every triangle spans the whole plan.
  TriangleMesh mesh;
  for (int k = 0; k < 10'000; ++k) {
    const TriangleMesh next = cube(DVec3(-0.5 - 1e-6 * k), 1 + 2e-6 * k);
    const auto offset = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), next.positions.begin(), next.positions.end());
    for (const auto& [a, b, c] : next.triangles) mesh.triangles.push_back({a + offset, b + offset, c + offset});
  }
  const ClosedMesh closed(mesh);
  EXPECT_EQ(closed.winding_number(DVec3(0)), 10'000);
}

TEST(ClosedMesh, FarFromTheOriginItIsAsExact) {
  const DVec3 there(85'000'000, 446'000, -3e6);
  const ClosedMesh closed(cube(there));
  EXPECT_TRUE(closed.contains(there + DVec3(0.999)));
  EXPECT_TRUE(closed.contains(there + DVec3(0.001)));
  EXPECT_FALSE(closed.contains(there + DVec3(0.5, 1.001, 0.5)));
}

TEST(ClosedMesh, ContainsNoPointThatIsNoNumber) {
  const ClosedMesh closed(cube());
  EXPECT_FALSE(closed.contains(DVec3(std::nan(""), 0.5, 0.5)));
  EXPECT_FALSE(closed.contains(DVec3(0.5, HUGE_VAL, 0.5)));
  EXPECT_FALSE(ClosedMesh(TriangleMesh{}).contains(DVec3(0)));
}

TEST(ClosedMesh, RejectsIndicesOutOfRange) {
  TriangleMesh mesh = cube();
  mesh.triangles[3][1] = 8;
  EXPECT_THROW(ClosedMesh{mesh}, std::invalid_argument);
}

TEST(Closedness, ClosedMeshesHaveNoFaults) {
  EXPECT_TRUE(closedness_errors(cube()).empty());
  EXPECT_TRUE(closedness_errors(sphere_mesh(3)).empty());
  TriangleMesh turned = cube();
  turn_over(turned);
  EXPECT_TRUE(closedness_errors(turned).empty());
  // Two cubes that share an edge: four triangles meet there, two in each direction.
  EXPECT_TRUE(closedness_errors(joined(cube(), cube({1, 1, 0}))).empty());
}

TEST(Closedness, VerticesAtOnePlaceCountAsOne) {
  TriangleMesh apart;
  for (const auto& triangle : cube().triangles) {
    std::array<std::uint32_t, 3> own{};
    for (std::size_t k = 0; k < 3; ++k) {
      own[k] = static_cast<std::uint32_t>(apart.positions.size());
      apart.positions.push_back(cube().positions[triangle[k]]);
    }
    apart.triangles.push_back(own);
  }
  apart.triangles.push_back({0, 0, 1});  // without area
  EXPECT_TRUE(closedness_errors(apart).empty());
}

TEST(Closedness, TellsEachKindOfFaultWithItsPlace) {
  TriangleMesh open = cube();
  open.triangles.pop_back();
  EXPECT_EQ(closedness_errors(open).at(0),
            "3 edges are open, with a triangle on one side only; the first goes from (0, 0, 1) to (0, 1, 1)");
  TriangleMesh turned = cube();
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_EQ(
      closedness_errors(turned).at(0),
      "3 edges are between triangles that are turned against each other; the first goes from (0, 0, 0) to (0, 0, 1)");
  TriangleMesh crowded = cube();
  crowded.positions.push_back({0.5, 0.5, -1});
  crowded.triangles.push_back({0, 1, 8});
  EXPECT_EQ(closedness_errors(crowded).size(), 2U);
  EXPECT_NE(closedness_errors(crowded).at(1).find("1 edge is where more triangles meet one way than the other"),
            std::string::npos);
  TriangleMesh flat = cube();
  for (DVec3& position : flat.positions) position.y = 0;
  EXPECT_TRUE(closedness_errors(flat).empty());
  EXPECT_EQ(body_error(flat), "encloses nothing");
  EXPECT_EQ(body_error(cube()), "");
}

TEST(ClosedMesh, ABowTieIsClosedAndCrossesItself) {
  // A prism over two triangles, one counter-clockwise and one clockwise.
  TriangleMesh tie;
  tie.positions = {{-1, 0, -1}, {-1, 0, 1}, {1, 0, -1}, {1, 0, 1}, {-1, 1, -1},
                   {-1, 1, 1},  {1, 1, -1}, {1, 1, 1},  {0, 0, 0}, {0, 1, 0}};
  // Bottom and top as two triangles that meet in the middle, then the sides.
  tie.triangles = {{0, 8, 1}, {2, 8, 3}, {4, 5, 9}, {6, 7, 9}};
  const std::array<std::array<std::uint32_t, 2>, 6> sides{{{0, 1}, {1, 8}, {8, 2}, {2, 3}, {3, 8}, {8, 0}}};
  for (const auto& side : sides) {
    const std::uint32_t a = side[0], b = side[1];
    const auto above = [](std::uint32_t k) { return k == 8 ? 9 : k + 4; };
    tie.triangles.push_back({a, b, above(b)});
    tie.triangles.push_back({a, above(b), above(a)});
  }
  EXPECT_EQ(closedness_errors(tie), std::vector<std::string>{});
  EXPECT_NE(body_error(tie).find("crosses itself"), std::string::npos) << body_error(tie);
  EXPECT_TRUE(ClosedMesh(tie).contains({-0.5, 0.5, 0}));
  EXPECT_TRUE(ClosedMesh(tie).contains({0.5, 0.5, 0}));
  EXPECT_EQ(ClosedMesh(tie).volume(), 0);
}

TEST(MeshCrown, IsPlacedByItsFrame) {
  const auto mesh = std::make_shared<const ClosedMesh>(cube(DVec3(-0.5)));
  const DFrame frame{.axes = 2.0 * exact_rotation({0, 1, 0}, kPi / 4), .origin = {3, 5, 0}};
  const MeshCrown crown(mesh, frame);
  EXPECT_TRUE(crown.contains({3 + 1.4F, 5, 0}));
  EXPECT_FALSE(crown.contains({3 + 1.43F, 5, 0}));
  EXPECT_FALSE(crown.contains({3 + 0.8F, 5, 0.8F}));
  EXPECT_TRUE(crown.contains({3, 5.99F, 0}));
  EXPECT_NEAR(crown.bounds().high.x, 3 + std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(crown.bounds().low.y, 4, 1e-5);
}

}  // namespace meristem::closed_mesh_test
