// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/obstacle/obstacles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/frame.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/scene/file/read_mesh.h"
#include "tests/support/sample_bodies.h"
#include "tests/support/test_data.h"

namespace meristem::obstacles_test {

constexpr double kFar = std::numeric_limits<double>::infinity();

Obstacles obstacles_of(std::vector<TriangleMesh> meshes) {
  std::vector<Obstacle> bodies;
  for (TriangleMesh& mesh : meshes) bodies.push_back({.mesh = std::move(mesh)});
  return Obstacles(std::move(bodies));
}

// An L: a 3 by 3 square without its north-eastern 2 by 2 part, 2 high.
TriangleMesh l_shape() {
  return prism_mesh({{{0, 0}}, {{3, 0}}, {{3, 1}}, {{1, 1}}, {{1, 3}}, {{0, 3}}},
                    {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, 0, 2);
}

Vec3 random_position(std::uint64_t index, float reach) {
  const RandomKey key(3);
  const Vec3 share(key.uniform(index, 0), key.uniform(index, 1), key.child("z").uniform(index));
  return (2.0F * share - 1.0F) * reach;
}

Vec3 toward(Vec3 from, Vec3 to) { return glm::normalize(to - from); }

// The reference implementation: tests every triangle by its plane and three volumes, in long double.
std::optional<Obstacles::Hit> brute_force_hit(const Obstacles& obstacles, Vec3 origin, Vec3 direction) {
  using Exact = glm::vec<3, long double>;
  std::optional<Obstacles::Hit> best;
  for (std::size_t k = 0; k < obstacles.bodies().size(); ++k) {
    const TriangleMesh& mesh = obstacles.bodies()[k].mesh;
    for (const auto& [p, q, r] : mesh.triangles) {
      const Exact a = Exact(mesh.positions[p]) - Exact(origin);
      const Exact b = Exact(mesh.positions[q]) - Exact(origin);
      const Exact c = Exact(mesh.positions[r]) - Exact(origin);
      const Exact along(direction);
      const std::array<long double, 3> sides{glm::dot(along, glm::cross(a, b)), glm::dot(along, glm::cross(b, c)),
                                             glm::dot(along, glm::cross(c, a))};
      const auto [min, max] = std::minmax_element(sides.begin(), sides.end());
      const Exact normal = glm::cross(b - a, c - a);
      const long double slope = glm::dot(normal, along);
      if ((*min < 0 && *max > 0) || slope == 0) continue;
      const auto distance = static_cast<double>(glm::dot(normal, a) / slope);
      if (distance >= 0 && (!best || distance < best->distance)) best = Obstacles::Hit{distance, k};
    }
  }
  return best;
}

TEST(BoxMesh, IsClosedAndFacesOutward) {
  const TriangleMesh box = box_mesh({1, 2, 3}, {2, 4, 7});
  EXPECT_TRUE(closedness_errors(box).empty());
  EXPECT_EQ(ClosedMesh(box).winding_number({1.5, 3, 5}), 1);
  EXPECT_DOUBLE_EQ(ClosedMesh(box).volume(), 8);
}

TEST(Obstacles, WithoutBodiesNothingIsMet) {
  const Obstacles none;
  EXPECT_TRUE(none.empty());
  EXPECT_TRUE(none.bounds().is_empty());
  EXPECT_FALSE(none.contain(Vec3(0)));
  EXPECT_FALSE(none.cross(Vec3(-1), Vec3(1)));
  EXPECT_FALSE(none.first_hit(Vec3(0), kUp, kFar).has_value());
  EXPECT_TRUE(Obstacles(std::vector<Obstacle>{}).empty());
}

TEST(Obstacles, ABoxIsMetAtItsFaces) {
  const Obstacles box = obstacles_of({box_mesh({-1, 0, 2}, {1, 3, 4})});
  const auto hit = box.first_hit({0, 1, 0}, {0, 0, 1}, kFar);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->distance, 2);
  EXPECT_EQ(hit->obstacle, 0U);
  EXPECT_EQ(box.first_hit({0, 1, 3}, {0, 1, 0}, kFar)->distance, 2);  // from inside
  EXPECT_FALSE(box.first_hit({0, 1, 0}, {0, 0, -1}, kFar).has_value());
  EXPECT_FALSE(box.first_hit({0, 1, 0}, {0, 0, 1}, 1.99).has_value());
  EXPECT_TRUE(box.first_hit({0, 1, 0}, {0, 0, 1}, 2).has_value());
  EXPECT_FALSE(box.first_hit({1.01F, 1, 0}, {0, 0, 1}, kFar).has_value());
  EXPECT_EQ(box.bounds().low, Vec3(-1, 0, 2));
  EXPECT_EQ(box.bounds().high, Vec3(1, 3, 4));
}

TEST(Obstacles, ASphereIsMetWhereItsEquationSays) {
  constexpr double kRadius = 2;
  const Obstacles sphere = obstacles_of({sphere_mesh(6, kRadius)});
  int hits = 0;
  for (std::uint64_t k = 0; k < 20'000; ++k) {
    const Vec3 origin = random_position(k, 5);
    const Vec3 direction = RandomKey(8).direction(k);
    const double along = -glm::dot(DVec3(origin), DVec3(direction));
    const double squared = along * along - glm::dot(DVec3(origin), DVec3(origin)) + kRadius * kRadius;
    // Facets lie inside the sphere.
    if (std::abs(squared) < 0.02 || std::abs(glm::length(origin) - kRadius) < 0.01) continue;
    const bool is_inside = glm::length(origin) < kRadius;
    const auto hit = sphere.first_hit(origin, direction, kFar);
    ASSERT_EQ(hit.has_value(), squared > 0 && (along > 0 || is_inside));
    if (!hit) continue;
    ++hits;
    const double expected = is_inside ? along + std::sqrt(squared) : along - std::sqrt(squared);
    ASSERT_NEAR(hit->distance, expected, 0.02);
  }
  EXPECT_GT(hits, 1000);
}

TEST(Obstacles, AConcaveBodyHasNothingInItsNotch) {
  const Obstacles notched = obstacles_of({l_shape()});
  EXPECT_TRUE(closedness_errors(l_shape()).empty());
  EXPECT_TRUE(notched.contain({0.5F, 1, -2.5F}));
  EXPECT_TRUE(notched.contain({2.5F, 1, -0.5F}));
  EXPECT_FALSE(notched.contain({2, 1, -2}));
  EXPECT_FALSE(notched.cross({1.5F, 1, -1.5F}, {2.9F, 1, -2.9F}));
  EXPECT_TRUE(notched.cross({2, 1, -2}, {2, 1, -0.5F}));
  // Through one arm and the notch: the outer side of the arm is met first.
  EXPECT_DOUBLE_EQ(notched.first_hit({-1, 1, -2}, {1, 0, 0}, kFar)->distance, 1);
  EXPECT_DOUBLE_EQ(notched.first_hit({2, 1, -2}, {-1, 0, 0}, kFar)->distance, 1);
}

TEST(Obstacles, RaysAgreeWithBruteForce) {
  std::vector<TriangleMesh> meshes;
  for (std::uint64_t k = 0; k < 6; ++k) {
    meshes.push_back(moved(sphere_mesh(2, 0.5 + 0.2 * static_cast<double>(k)), DVec3(random_position(k, 4))));
  }
  meshes.push_back(l_shape());
  const Obstacles obstacles = obstacles_of(std::move(meshes));
  int hits = 0;
  for (std::uint64_t k = 0; k < 1500; ++k) {
    const Vec3 origin = random_position(100 + k, 6);
    const Vec3 direction = RandomKey(9).direction(k);
    const auto expected = brute_force_hit(obstacles, origin, direction);
    const auto hit = obstacles.first_hit(origin, direction, kFar);
    ASSERT_EQ(hit.has_value(), expected.has_value()) << k;
    if (!hit) continue;
    ++hits;
    ASSERT_NEAR(hit->distance, expected->distance, 1e-12 * (1 + expected->distance));
    ASSERT_EQ(hit->obstacle, expected->obstacle);
    const Vec3 end = origin + static_cast<float>(expected->distance + 0.01) * direction;
    ASSERT_TRUE(obstacles.cross(origin, end));
  }
  EXPECT_GT(hits, 100);
}

TEST(Obstacles, NoRaySlipsThroughEdgesOrVertices) {
  const TriangleMesh mesh = sphere_mesh(3);
  for (const DVec3 there : {DVec3(0), DVec3(1e5, -3e4, 7e4)}) {
    const TriangleMesh placed = moved(mesh, there);
    const Obstacles obstacles = obstacles_of({placed});
    for (std::uint64_t k = 0; k < 40'000; ++k) {
      const auto& triangle = placed.triangles[k % placed.triangles.size()];
      const DVec3 a = placed.positions[triangle[k % 3]];
      const DVec3 b = placed.positions[triangle[(k + 1) % 3]];
      const double share = k % 5 == 0 ? 0 : RandomKey(2).uniform(k);
      const Vec3 on_edge(glm::mix(a, b, share));
      const Vec3 from = Vec3(there) + 5.0F * RandomKey(4).direction(k);
      // Aim from outside at the centre side of the edge, so that the ray must enter.
      const Vec3 inner = Vec3(DVec3(on_edge) + 0.2 * (there - DVec3(on_edge)));
      ASSERT_TRUE(obstacles.first_hit(from, toward(from, inner), kFar).has_value());
      ASSERT_TRUE(obstacles.cross(from, inner));
      ASSERT_TRUE(obstacles.first_hit(Vec3(there), toward(Vec3(there), on_edge), kFar).has_value());
    }
  }
}

TEST(Obstacles, WaysThroughVerticesAndEdgesOfARoughSheetCrossIt) {
  // x and z are whole numbers and heights are eighths. Vertices and midpoints of edges are exact, and so are ways
  // through them.
  constexpr std::uint32_t kSide = 12;
  TriangleMesh sheet;
  for (std::uint32_t k = 0; k < kSide * kSide; ++k) {
    sheet.positions.emplace_back(k % kSide, std::floor(RandomKey(7).uniform(k, 0, 8)) / 8, k / kSide);
  }
  for (std::uint32_t k = 0; k + kSide < kSide * kSide; ++k) {
    if (k % kSide + 1 == kSide) continue;
    sheet.triangles.push_back({k, k + kSide, k + 1});
    sheet.triangles.push_back({k + 1, k + kSide, k + kSide + 1});
  }
  const Obstacles obstacles({{.mesh = sheet, .is_broken = true}});
  int ways = 0;
  for (const auto& triangle : sheet.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 vertex(sheet.positions[triangle[k]]);
      const Vec3 middle = 0.5F * (vertex + Vec3(sheet.positions[triangle[(k + 1) % 3]]));
      for (const Vec3 position : {vertex, middle}) {
        // At the rim, rounding may lead past the sheet.
        const float inward = std::min({position.x, position.z, kSide - 1 - position.x, kSide - 1 - position.z});
        if (inward == 0) continue;
        for (const Vec3 way : {Vec3(0, 4, 0), Vec3(0.25F, 3, 0.375F), Vec3(-0.125F, 5, 0.5F), Vec3(1, 7, -3)}) {
          ASSERT_TRUE(obstacles.cross(position + way, position - way));
          ++ways;
        }
      }
    }
  }
  EXPECT_GT(ways, 4000);
}

TEST(Obstacles, WhatTouchesIsMet) {
  const Obstacles box = obstacles_of({box_mesh({0, 0, 0}, {2, 2, 2})});
  EXPECT_EQ(box.first_hit({-1, 2, 2}, {1, 0, 0}, kFar)->distance, 1);     // along an edge
  EXPECT_EQ(box.first_hit({0.5F, 2, 2}, {1, 0, 0}, kFar)->distance, 0);   // from a position on the edge
  EXPECT_EQ(box.first_hit({-1, 2, 1}, {1, 0, 0}, kFar)->distance, 1);     // along a face
  EXPECT_EQ(box.first_hit({-1, 2, 0.7F}, {1, 0, 0}, kFar)->distance, 1);  // along a face, past its diagonal
  EXPECT_EQ(box.first_hit({2, 2, 5}, {0, 0, -1}, kFar)->distance, 3);     // a vertex first
  EXPECT_NEAR(box.first_hit({-1, 1, 2}, toward({-1, 1, 2}, {0, 2, 2}), kFar)->distance, std::sqrt(2.0), 1e-6);
  EXPECT_TRUE(box.cross({-1, 1, 1}, {0, 1, 1}));  // ends on a face
  EXPECT_TRUE(box.cross({0, 1, 1}, {-1, 1, 1}));  // begins on a face
  EXPECT_FALSE(box.cross({-1, 2.0001F, 2}, {3, 2.0001F, 2}));
}

TEST(Obstacles, HoweverShortAWayInsideIsCrossed) {
  const Obstacles sphere = obstacles_of({moved(sphere_mesh(3, 1), {0.25, 3, -0.5})});
  for (std::uint64_t k = 0; k < 300; ++k) {
    // Halve the way to the centre until its ends are adjacent floats.
    Vec3 outside = Vec3(0.25F, 3, -0.5F) + 1.5F * RandomKey(12).direction(k);
    Vec3 inside(0.25F, 3, -0.5F);
    ASSERT_FALSE(sphere.contain(outside));
    for (;;) {
      ASSERT_TRUE(sphere.cross(outside, inside));
      ASSERT_TRUE(sphere.cross(inside, outside));
      const Vec3 middle = 0.5F * (outside + inside);
      if (middle == outside || middle == inside) break;
      (sphere.contain(middle) ? inside : outside) = middle;
    }
  }
  EXPECT_FALSE(sphere.cross(Vec3(0.25F, 3, -0.5F), Vec3(0.25F, 3, -0.5F)));
  EXPECT_FALSE(sphere.cross(Vec3(0.25F, 3, -0.5F), Vec3(0.25F, 3.5F, -0.5F)));
}

TEST(Obstacles, AtEqualDistancesTheLowerIndexIsMet) {
  const TriangleMesh wall = box_mesh({-1, 0, 2}, {1, 2, 3});
  const Obstacles twins = obstacles_of({box_mesh({5, 5, 5}, {6, 6, 6}), wall, wall, box_mesh({-2, 0, 2}, {2, 2, 3})});
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const Vec3 from(RandomKey(1).uniform(k, -0.9, 0.9), RandomKey(2).uniform(k, 0.1, 1.9), 0);
    const auto hit = twins.first_hit(from, {0, 0, 1}, kFar);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->distance, 2);
    EXPECT_EQ(hit->obstacle, 1U);
  }
}

TEST(Obstacles, ThinAndFlatTrianglesDoNotDisturb) {
  TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  mesh.positions.insert(mesh.positions.end(), {{3, 0, 0}, {3, 1, 0}, {3, 0.5, 0}, {5, 5, 5}});
  mesh.triangles.insert(mesh.triangles.end(), {{8, 9, 10}, {11, 11, 11}, {8, 8, 9}});
  const Obstacles obstacles = obstacles_of({mesh});
  EXPECT_DOUBLE_EQ(obstacles.first_hit({-1, 0.5F, 0.5F}, {1, 0, 0}, kFar)->distance, 1);
  EXPECT_DOUBLE_EQ(obstacles.first_hit({2, 0.5F, 0.5F}, {-1, 0, 0}, kFar)->distance, 1);
  // Lines and points are met if they are touched.
  EXPECT_DOUBLE_EQ(obstacles.first_hit({3, 0.25F, -4}, {0, 0, 1}, kFar)->distance, 4);
  EXPECT_DOUBLE_EQ(obstacles.first_hit({3, -2, 0}, {0, 1, 0}, kFar)->distance, 2);
  EXPECT_DOUBLE_EQ(obstacles.first_hit({5, 5, 0}, {0, 0, 1}, kFar)->distance, 5);
  EXPECT_FALSE(obstacles.first_hit({3.001F, 0.25F, -4}, {0, 0, 1}, kFar).has_value());
}

TEST(Obstacles, FarFromTheOriginTheyAreAsExact) {
  const DVec3 there(1e5, 0, -1e5);
  const Obstacles box = obstacles_of({box_mesh(there, there + DVec3(1))});
  EXPECT_DOUBLE_EQ(box.first_hit(Vec3(there) + Vec3(-2, 0.5F, 0.5F), {1, 0, 0}, kFar)->distance, 2);
  EXPECT_TRUE(box.contain(Vec3(there) + Vec3(0.96875F, 0.5F, 0.03125F)));
  EXPECT_FALSE(box.contain(Vec3(there) + Vec3(1.03125F, 0.5F, 0.5F)));
  const auto from_home = box.first_hit({0, 0.5F, 0}, glm::normalize(Vec3(1, 0, -1)), kFar);
  ASSERT_TRUE(from_home.has_value());
  EXPECT_NEAR(from_home->distance, 1e5 * std::sqrt(2.0), 0.02);
}

TEST(Obstacles, AnswersAreTheSameOnAnyNumberOfThreads) {
  std::vector<TriangleMesh> meshes;
  for (std::uint64_t k = 0; k < 10; ++k) meshes.push_back(moved(sphere_mesh(3), DVec3(random_position(k, 6))));
  const auto answers = [&](int threads) {
    const ThreadLimit limit(threads);
    const Obstacles obstacles = obstacles_of(meshes);
    std::vector<double> found(20'000);
    parallel_for(found.size(), 500, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const Vec3 position = random_position(k, 8);
        const auto hit = obstacles.first_hit(position, RandomKey(5).direction(k), kFar);
        found[k] = hit ? hit->distance + static_cast<double>(hit->obstacle) : obstacles.contain(position) ? -1 : -2;
      }
    });
    return found;
  };
  const std::vector<double> alone = answers(1);
  EXPECT_GT(std::count_if(alone.begin(), alone.end(), [](double answer) { return answer > 0; }), 1000);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(answers(threads), alone);
}

TEST(Obstacles, ABrokenBodyIsWhereMostViewsSeeIt) {
  TriangleMesh open = box_mesh({0, 0, 0}, {2, 2, 2});
  // Without its top, and with its western side reversed.
  open.triangles.erase(open.triangles.begin() + 6, open.triangles.begin() + 8);
  std::swap(open.triangles[6][0], open.triangles[6][1]);
  ASSERT_FALSE(closedness_errors(open).empty());
  const Obstacles broken({{.mesh = open, .is_broken = true}});
  EXPECT_TRUE(broken.contain({1, 1, 1}));
  EXPECT_TRUE(broken.contain({0.1F, 1.9F, 0.1F}));
  EXPECT_FALSE(broken.contain({1, 2.1F, 1}));
  EXPECT_FALSE(broken.contain({1, -0.1F, 1}));
  EXPECT_FALSE(broken.contain({2.1F, 1, 1}));
  EXPECT_TRUE(broken.cross({1, 3, 1}, {1, 1, 1}));  // through the hole
  EXPECT_EQ(broken.ground_centroid(0).y, 0);
}

TEST(Obstacles, TurnedAndMissingTrianglesHardlyMoveAnInside) {
  const TriangleMesh whole = sphere_mesh(4);
  TriangleMesh damaged = whole;
  damaged.triangles.clear();
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    if (t % 25 == 7) continue;  // 4 % are missing
    damaged.triangles.push_back(whole.triangles[t]);
    if (t % 10 == 3) std::swap(damaged.triangles.back()[0], damaged.triangles.back()[1]);
  }
  const ClosedMesh closed(whole);
  const Obstacles broken({{.mesh = damaged, .is_broken = true}});
  int wrong = 0;
  constexpr int kTrials = 20'000;
  for (std::uint64_t k = 0; k < kTrials; ++k) {
    const Vec3 position = random_position(k, 1);
    wrong += broken.contain(position) != closed.contains(DVec3(position)) ? 1 : 0;
  }
  // Each view errs for 4 % of the positions inside; two of three err for about 3 * 0.04^2.
  EXPECT_LT(wrong, 0.01 * kTrials);
  EXPECT_LT(glm::length(broken.ground_centroid(0)), 0.02F);
}

TEST(Obstacles, StandOverTheCentroidOfTheirVolume) {
  const Obstacles bodies = obstacles_of(
      {box_mesh({-3, 0, 3}, {3, 8, 6}), moved(sphere_mesh(4), {5, 9, -7}), l_shape(), moved(l_shape(), {1e5, 0, 0})});
  EXPECT_LT(glm::distance(bodies.ground_centroid(0), Vec3(0, 0, 4.5F)), 1e-6F);
  EXPECT_LT(glm::distance(bodies.ground_centroid(1), Vec3(5, 0, -7)), 1e-6F);
  // Arms of 3 and 2 square metres with centroids (1.5, -0.5) and (0.5, -2).
  EXPECT_LT(glm::distance(bodies.ground_centroid(2), Vec3(1.1F, 0, -1.1F)), 1e-6F);
  EXPECT_LT(glm::distance(bodies.ground_centroid(3), Vec3(1e5F + 1.1F, 0, -1.1F)), 0.01F);
}

void check_inside(const TriangleMesh& mesh) {
  const Obstacles house = obstacles_of({mesh});
  const ClosedMesh closed(mesh);
  const Box box = house.bounds();
  std::uint64_t inside = 0;
  constexpr std::uint64_t kTrials = 20'000;
  for (std::uint64_t k = 0; k < kTrials; ++k) {
    const Vec3 position = box.centre() + random_position(k, 0.5F) * box.size();
    const bool is_inside = house.contain(position);
    ASSERT_EQ(is_inside, closed.contains(DVec3(position)));
    inside += is_inside ? 1 : 0;
    // Every way out of a closed body passes a wall, also through vertices.
    const Vec3 vertex(mesh.positions[k % mesh.positions.size()]);
    const Vec3 beyond = position + 40.0F * toward(position, k % 2 == 0 ? vertex : position + RandomKey(6).direction(k));
    ASSERT_TRUE(!is_inside || house.cross(position, beyond));
  }
  const Vec3 size = box.size();
  const double volume = double{size.x} * size.y * size.z * static_cast<double>(inside) / kTrials;
  EXPECT_NEAR(volume, closed.volume(), 0.02 * closed.volume());
}

TEST(Obstacles, HousesHaveTheirInside) {
  for (const std::string& file : data_files({"models/house.obj"}, {"obstacles/house.obj"})) {
    SCOPED_TRACE(file);
    check_inside(read_mesh(file, SizeLimits{}));
  }
}

TEST(Obstacles, NumbersThatAreNoneMeetNothing) {
  const Obstacles box = obstacles_of({box_mesh({0, 0, 0}, {1, 1, 1})});
  const float nan = std::nanf("");
  EXPECT_FALSE(box.contain({nan, 0.5F, 0.5F}));
  EXPECT_FALSE(box.first_hit({nan, 0.5F, 0.5F}, {1, 0, 0}, kFar).has_value());
  EXPECT_FALSE(box.first_hit({-1, 0.5F, 0.5F}, {nan, 0, 0}, kFar).has_value());
  EXPECT_FALSE(box.first_hit({-1, 0.5F, 0.5F}, Vec3(0), kFar).has_value());
  EXPECT_FALSE(box.first_hit({-1, 0.5F, 0.5F}, {1, 0, 0}, std::nan("")).has_value());
  EXPECT_FALSE(box.cross({-1, 0.5F, nan}, {2, 0.5F, 0.5F}));
}

TEST(Obstacles, RejectMeshesThatPointNowhere) {
  TriangleMesh wrong = box_mesh({0, 0, 0}, {1, 1, 1});
  wrong.triangles[2][1] = 8;
  EXPECT_THROW(obstacles_of({wrong}), std::invalid_argument);
  TriangleMesh endless = box_mesh({0, 0, 0}, {1, 1, 1});
  endless.positions[3].y = std::nan("");
  EXPECT_THROW(obstacles_of({endless}), std::invalid_argument);
  endless.positions[3].y = 1e300;
  EXPECT_THROW(obstacles_of({endless}), std::invalid_argument);
}

// The reference implementation: samples each triangle in a fine net of points.
double brute_force_distance(const TriangleMesh& mesh, Vec3 position) {
  constexpr int kSteps = 60;
  double min = kFar;
  for (const auto& [p, q, r] : mesh.triangles) {
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const DVec3 at = mesh.positions[p] + (mesh.positions[q] - mesh.positions[p]) * (double(i) / kSteps) +
                         (mesh.positions[r] - mesh.positions[p]) * (double(j) / kSteps);
        min = std::min(min, glm::distance(at, DVec3(position)));
      }
    }
  }
  return min;
}

TEST(Obstacles, TheWayFromASurfaceIsAcrossItsFacesAndSlantedAtItsEdges) {
  const Obstacles box = obstacles_of({box_mesh({-1, 0, -1}, {1, 2, 1})});
  EXPECT_EQ(box.away_from_surface({1.5F, 1, 0.2F}), Vec3(1, 0, 0));
  EXPECT_EQ(box.away_from_surface({0.1F, 1, -1.01F}).value(), Vec3(0, 0, -1));
  const Vec3 at_edge = box.away_from_surface({1.3F, 2.4F, 0}).value();
  EXPECT_LT(glm::distance(at_edge, Vec3(0.6F, 0.8F, 0)), 1e-6F);
  const Vec3 inside = box.away_from_surface({0.9F, 1, 0}).value();
  EXPECT_EQ(inside, Vec3(1, 0, 0)) << "out of the body";
  EXPECT_EQ(box.away_from_surface({1, 1, 0.3F}), Vec3(1, 0, 0)) << "on the surface: its normal";
  EXPECT_FALSE(Obstacles().away_from_surface({0, 0, 0}).has_value());
}

TEST(Obstacles, TheNearestSurfaceIsThatOfAllTriangles) {
  const TriangleMesh mesh = l_shape();
  const Obstacles obstacles = obstacles_of({mesh, box_mesh({20, 0, 20}, {21, 1, 21})});
  for (std::uint64_t k = 0; k < 200; ++k) {
    const Vec3 position = random_position(k, 4);
    const Vec3 way = obstacles.away_from_surface(position).value();
    EXPECT_NEAR(glm::length(way), 1, 1e-6) << k;
    const double distance = brute_force_distance(mesh, position);
    // The surface is reached along this direction at the distance, and not earlier.
    const double sign = obstacles.contain(position) ? -1 : 1;
    const DVec3 met = DVec3(position) - sign * distance * DVec3(way);
    EXPECT_LT(brute_force_distance(mesh, Vec3(met)), 0.06) << k;
  }
}

TEST(Obstacles, TheNearestSurfaceIsFoundFarFromTheOriginAndFromAll) {
  const Obstacles far = obstacles_of({box_mesh({1e6, 0, 1e6}, {1e6 + 2, 2, 1e6 + 2})});
  EXPECT_EQ(far.away_from_surface({1e6F + 3, 1, 1e6F + 1}), Vec3(1, 0, 0));
  EXPECT_GT(far.away_from_surface({0, 1, 0})->y, -0.1F);
  EXPECT_LT(far.away_from_surface({0, 1, 0})->x, -0.7F);
}

TEST(Obstacles, TheirTreesLeaveTheSmallestNumbersToOtherLoops) {
  const Obstacles box = obstacles_of({box_mesh({0, 0, 0}, {1, 1, 1})});
  EXPECT_TRUE(box.contain({0.5F, 0.5F, 0.5F}));
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    std::vector<float> halves(1000);
    parallel_for(halves.size(), 1, [&](std::size_t block, std::size_t) {
      const volatile float smallest = std::numeric_limits<float>::denorm_min() * 2;
      halves[block] = smallest / 2;
    });
    EXPECT_EQ(std::count(halves.begin(), halves.end(), std::numeric_limits<float>::denorm_min()), 1000) << threads;
  }
}

}  // namespace meristem::obstacles_test
