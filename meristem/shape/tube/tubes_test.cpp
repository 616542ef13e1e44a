// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/tube/tubes.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "meristem/base/frame.h"
#include "meristem/base/hash.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/shape/tube/tube_plan.h"
#include "tests/support/check_mesh.h"

namespace meristem::tubes_test {

/// Builds a skeleton axis by axis.
class Builder {
 public:
  NodeIndex add(NodeIndex parent, Vec3 position, float radius, AxisIndex axis) {
    const NodeIndex node = skeleton.add_node(parent, position, 0);
    skeleton.radius[node] = radius;
    skeleton.axis[node] = axis;
    return node;
  }
  Skeleton skeleton;
};

/// Returns one axis through the given points.
Skeleton polyline(const std::vector<Vec3>& points, const std::vector<float>& radii) {
  Builder builder;
  NodeIndex last = kNoNode;
  for (std::size_t i = 0; i < points.size(); ++i) {
    last = builder.add(last, points[i], radii.size() == 1 ? radii[0] : radii[i], 0);
  }
  return builder.skeleton;
}

Vec3 tilted(double angle_deg, double azimuth_deg = 0) {
  const double angle = radians(angle_deg);
  const double azimuth = radians(azimuth_deg);
  return {std::sin(angle) * std::cos(azimuth), std::cos(angle), std::sin(angle) * std::sin(azimuth)};
}

/// Returns a stem with one branch that leaves it at an angle.
Skeleton fork(double angle_deg, float stem_radius, float branch_radius) {
  Builder builder;
  NodeIndex stem = builder.add(kNoNode, Vec3(0), stem_radius, 0);
  const NodeIndex at_fork = stem = builder.add(stem, {0, 1, 0}, stem_radius, 0);
  for (int i = 2; i <= 4; ++i) stem = builder.add(stem, {0, i, 0}, 0.8F * stem_radius, 0);
  NodeIndex branch = at_fork;
  for (int i = 1; i <= 4; ++i) {
    branch = builder.add(branch, Vec3(0, 1, 0) + 0.4F * static_cast<float>(i) * tilted(angle_deg), branch_radius, 1);
  }
  return builder.skeleton;
}

/// Returns a random tree of many axes, to compare bytes and counts.
Skeleton random_tree(std::uint64_t seed, int nodes) {
  Builder builder;
  const RandomKey key(seed);
  builder.add(kNoNode, Vec3(0), 0.03F, 0);
  AxisIndex axes = 1;
  std::vector<bool> has_next{false};
  for (int i = 1; i < nodes; ++i) {
    const auto parent = static_cast<NodeIndex>(key.child("parent").uniform(i, std::max(0, i - 40), i));
    const Vec3 step = 0.1F * glm::normalize(key.child("step").direction(i) + Vec3(0, 1.5F, 0));
    const AxisIndex axis = has_next[parent] ? axes++ : builder.skeleton.axis[parent];
    has_next[parent] = true;
    has_next.push_back(false);
    builder.add(parent, builder.skeleton.position[parent] + step, builder.skeleton.radius[parent] * 0.97F, axis);
  }
  return builder.skeleton;
}

/// Returns a surface without collars, flares and smoothed radii.
SurfaceOptions bare(int sides, float uv_scale = 1) {
  return {.sides = sides, .error = 0, .uv_scale = uv_scale, .smooth = 0, .collar = 0, .flare = 0};
}

Mesh tubes(const Skeleton& skeleton, SurfaceOptions surface = bare(8)) {
  Progress progress;
  return make_tubes(skeleton, surface, progress);
}

std::string bytes(const Mesh& mesh) {
  const auto text = [](const auto& column) { return hash128_hex(std::as_bytes(std::span(column))); };
  return text(mesh.positions) + text(mesh.normals) + text(mesh.uvs) + text(mesh.triangles);
}

float distance_to_segment(Vec3 point, Vec3 a, Vec3 b) {
  const float share = glm::clamp(glm::dot(point - a, b - a) / glm::dot(b - a, b - a), 0.0F, 1.0F);
  return glm::distance(point, a + share * (b - a));
}

double polygon_area(int n, double r) { return 0.5 * n * r * r * std::sin(2 * kPi / n); }

TEST(Tubes, StraightTubeIsAPrismWithACone) {
  const Mesh tube = tubes(polyline({{0, 0, 0}, {0, 0.5, 0}, {0, 2, 0}}, {0.1F}), bare(12));
  EXPECT_TRUE(check_mesh(tube));
  EXPECT_EQ(euler_number(tube), 2);
  EXPECT_NEAR(signed_volume(tube), polygon_area(12, 0.1) * (2 + 0.1 / 3), 1e-6);
}

TEST(Tubes, TaperingTubeHasTheVolumeOfFrustaAndTheirNormals) {
  const Mesh tube = tubes(polyline({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}, {0.4F, 0.3F, 0.2F}), bare(16));
  EXPECT_TRUE(check_mesh(tube));
  const auto frustum = [](double low, double high) {
    return polygon_area(16, 1) * (low * low + low * high + high * high) / 3;
  };
  EXPECT_NEAR(signed_volume(tube), frustum(0.4, 0.3) + frustum(0.3, 0.2) + polygon_area(16, 0.2) * 0.2 / 3, 1e-5);
  for (std::size_t i = 0; i < tube.vertex_count(); ++i) {
    if (tube.positions[i].y != 1) continue;
    EXPECT_NEAR(tube.normals[i].y, 0.1 / std::hypot(1, 0.1), 1e-5);
  }
}

TEST(Tubes, AMitredBendKeepsTheCrossSectionOfBothSegments) {
  for (const double angle : {5.0, 30.0, 60.0, 74.0}) {
    const Vec3 turned = tilted(angle);
    const Mesh tube = tubes(polyline({{0, -3, 0}, {0, 0, 0}, 3.0F * turned}, {0.2F}), bare(8));
    EXPECT_TRUE(check_mesh(tube));
    // The volume of a mitred prism is its cross-section times the length of its axis.
    EXPECT_NEAR(signed_volume(tube), polygon_area(8, 0.2) * (6 + 0.2 / 3), 1e-4) << angle;
  }
}

TEST(Tubes, SharpBendsHaveNeitherSpikesNorCrossedRings) {
  for (const double angle : {80.0, 90.0, 120.0, 149.0, 151.0, 170.0, 179.9, 180.0}) {
    // A zigzag that turns by the angle at each of its nodes.
    std::vector<Vec3> points{{0, 0, 0}};
    for (int i = 0; i < 8; ++i) points.push_back(points.back() + tilted(i % 2 == 0 ? 0 : angle) + Vec3(0, 0, 0.01F));
    Mesh tube = tubes(polyline(points, {0.1F}));
    // A segment that turns straight back is pressed flat on its inner side, where normals have little meaning.
    if (angle > 175) tube.normals.clear();
    EXPECT_TRUE(check_mesh(tube)) << angle;
    for (const Vec3 position : tube.positions) {
      float nearest = std::numeric_limits<float>::infinity();
      for (std::size_t i = 1; i < points.size(); ++i) {
        nearest = std::min(nearest, distance_to_segment(position, points[i - 1], points[i]));
      }
      EXPECT_LT(nearest, 0.13F) << angle;
    }
  }
}

TEST(Tubes, ThickTubesBendWithinTheirOwnRadius) {
  // An arc whose radius is smaller than the tube's: inner sides are compressed but do not cross.
  std::vector<Vec3> points;
  for (int i = 0; i <= 20; ++i) points.push_back(0.15F * tilted(9 * i));
  Mesh tube = tubes(polyline(points, {0.2F}));
  tube.normals.clear();
  EXPECT_TRUE(check_mesh(tube));
  const double arc = 0.15 * radians(180);
  EXPECT_NEAR(signed_volume(tube), polygon_area(8, 0.2) * (arc + 0.2 / 3), 0.3 * polygon_area(8, 0.2) * arc);
}

TEST(Tubes, FramesDoNotTwistAlongAHelix) {
  // Between neighbouring rings, a corner moves exactly as its axis does. Twist would add to this move.
  std::vector<Vec3> points;
  for (int i = 0; i <= 200; ++i) {
    points.emplace_back(std::cos(0.1 * i), 0.05 * i, std::sin(0.1 * i));
  }
  const Mesh tube = tubes(polyline(points, {0.05F}), bare(6));
  EXPECT_TRUE(check_mesh(tube));
  const std::size_t first = 7;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec3 tangent = glm::normalize(points[i + 1] - points[i - 1]);
    const Vec3 moved =
        tube.positions[first + 7 * (i + 1)] - points[i + 1] - (tube.positions[first + 7 * i] - points[i]);
    const Vec3 out = glm::normalize(tube.positions[first + 7 * i] - points[i]);
    EXPECT_LT(std::abs(glm::dot(moved, glm::cross(tangent, out))), 2e-4F) << i;
  }
}

TEST(Tubes, EveryRadiusAndSegmentIsTurnedWithTheSkeleton) {
  const Skeleton skeleton = random_tree(3, 300);
  Skeleton moved = skeleton;
  const Mat3 turn = rotation(glm::normalize(Vec3(1, 2, 3)), 1.1);
  for (Vec3& position : moved.position) position = turn * (2.0F * position);
  for (float& radius : moved.radius) radius *= 2;
  const Mesh mesh = tubes(skeleton);
  const Mesh moved_mesh = tubes(moved);
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_EQ(mesh.triangles, moved_mesh.triangles);
  // The first corner of a ring may have a different position, so allow a few per cent for the orientation of polygons.
  EXPECT_NEAR(surface_area(moved_mesh) / surface_area(mesh), 4, 0.04);
  EXPECT_NEAR(signed_volume(moved_mesh) / signed_volume(mesh), 8, 0.08);
}

TEST(Tubes, ALateralStartsInsideItsParent) {
  for (const double angle : {10.0, 30.0, 60.0, 90.0, 120.0, 160.0}) {
    for (const float branch_radius : {0.02F, 0.1F, 0.2F}) {
      const Skeleton skeleton = fork(angle, 0.2F, branch_radius);
      const SurfaceOptions surface = bare(10);
      const Mesh mesh = tubes(skeleton, surface);
      EXPECT_TRUE(check_mesh(mesh)) << angle;
      // The lateral's closed start and first ring follow the stem's vertices. Its number of sides falls with its
      // radius.
      const auto sides = static_cast<std::size_t>(std::lround(10 * std::cbrt(branch_radius / 0.2F)));
      const std::size_t stem = 5 * 11 + 11 + 10;
      const float inside = 0.2F * static_cast<float>(std::cos(kPi / 10));
      for (std::size_t i = stem; i < stem + sides + 2; ++i) {
        const Vec3 at = mesh.positions[i];
        const float taper = at.y > 1 ? 0.04F * (at.y - 1) : 0.0F;
        EXPECT_LT(std::hypot(at.x, at.z), inside - taper * inside / 0.2F) << angle << " " << branch_radius;
      }
      // Outside the stem, it has its own radius.
      const Vec3 second = mesh.positions[stem + 1 + (sides + 1)];
      EXPECT_NEAR(distance_to_segment(second, {0, 1, 0}, Vec3(0, 1, 0) + 2.0F * tilted(angle)), branch_radius, 1e-5F);
    }
  }
}

/// Returns a stem of two segments that another axis succeeds, or one axis along equal nodes.
Skeleton succeeded_stem(double angle_deg, float successor_radius, AxisIndex successor) {
  Builder builder;
  NodeIndex last = builder.add(kNoNode, Vec3(0), 0.1F, 0);
  last = builder.add(last, {0, 1, 0}, 0.1F, 0);
  last = builder.add(last, {0, 2, 0}, 0.1F, 0);
  for (int k = 1; k <= 2; ++k) {
    last = builder.add(last, Vec3(0, 2, 0) + static_cast<float>(k) * tilted(angle_deg), successor_radius, successor);
  }
  return builder.skeleton;
}

TEST(Tubes, WhatSucceedsAnAxisGoesOnWithItsRingFrameAndTexture) {
  const SurfaceOptions surface = bare(10, 0.1F);
  for (const double angle : {0.0, 5.0, 15.0}) {
    const Mesh one = tubes(succeeded_stem(angle, 0.1F, 0), surface);
    const Mesh two = tubes(succeeded_stem(angle, 0.1F, 1), surface);
    EXPECT_TRUE(check_mesh(two)) << angle;
    EXPECT_EQ(euler_number(two), 4);
    // A disc of 11 vertices and rings of 11: the stem's third ring, and the first ring of its successor after the
    // stem's cone and the successor's own hidden point.
    const std::size_t stem_ring = 11 + 2 * 11;
    const std::size_t successor_ring = stem_ring + 11 + 10 + 1;
    for (std::size_t k = 0; k < 3 * 11; ++k) {
      // The ring at the joint lies a thousandth inside the stem's ring, so that both bodies are closed.
      const float inside = k < 11 ? 1.1e-4F : 1e-6F;
      EXPECT_LT(glm::distance(two.positions[successor_ring + k], one.positions[stem_ring + k]), inside) << angle;
      EXPECT_LT(glm::distance(two.normals[successor_ring + k], one.normals[stem_ring + k]), 1e-5F) << angle;
      EXPECT_LT(glm::distance(two.uvs[successor_ring + k], one.uvs[stem_ring + k]), 1e-4F) << angle;
      if (k >= 11) continue;
      EXPECT_EQ(two.positions[stem_ring + k], one.positions[stem_ring + k]) << angle;
      EXPECT_EQ(two.normals[stem_ring + k], two.normals[successor_ring + k]) << angle;
    }
  }
}

TEST(Tubes, AThinShootAtATipStartsInsideIt) {
  const Mesh mesh = tubes(succeeded_stem(5, 0.03F, 1), bare(10));
  EXPECT_TRUE(check_mesh(mesh));
  // The stem keeps its cone: the last ring's normals lean toward the tip.
  EXPECT_GT(mesh.normals[11 + 2 * 11].y, 0.3F);
}

TEST(Tubes, EachAxisIsABodyOfItsOwn) {
  const Skeleton skeleton = random_tree(5, 400);
  const Mesh mesh = tubes(skeleton);
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_EQ(euler_number(mesh), 2 * static_cast<long>(SkeletonAxes(skeleton).count()));
}

TEST(Tubes, ThinnerTubesHaveFewerSidesAndNoneDeviatesMoreFromRound) {
  Builder builder;
  float radius = 1;
  for (AxisIndex axis = 0; axis < 30; ++axis, radius *= 0.8F) {
    const NodeIndex base = builder.add(kNoNode, {10.0F * static_cast<float>(axis), 0, 0}, radius, axis);
    builder.add(base, {10.0F * static_cast<float>(axis), 5, 0}, radius, axis);
  }
  const Mesh mesh = tubes(builder.skeleton, bare(16));
  EXPECT_TRUE(check_mesh(mesh));
  std::vector<int> triangles(30, 0);
  for (const auto& triangle : mesh.triangles) {
    ++triangles[static_cast<std::size_t>(std::lround(mesh.positions[triangle[0]].x / 10.0F))];
  }
  EXPECT_EQ(triangles.front(), 4 * 16);
  EXPECT_EQ(triangles.back(), 4 * 3);
  for (std::size_t axis = 1; axis < 30; ++axis) {
    EXPECT_LE(triangles[axis], triangles[axis - 1]);
    const double deviation = std::pow(0.8, axis) * (1 - std::cos(kPi / (triangles[axis] / 4.0)));
    if (triangles[axis] == 4 * 3) continue;
    EXPECT_LE(deviation, 1 - std::cos(kPi / 16));
  }
}

TEST(Tubes, TilesGoRoundAWholeNumberOfTimesAndKeepTheirAspect) {
  const SurfaceOptions surface = bare(24, 0.1F);
  const Mesh tube = tubes(polyline({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}}, {0.2F, 0.15F, 0.1F, 0.05F}), surface);
  // Four rings of 25 vertices follow the closed start.
  const std::size_t first = 25;
  const float tiles = std::round(static_cast<float>(2 * kPi) * 0.2F / 0.1F);
  for (std::size_t ring = 0; ring < 4; ++ring) {
    const std::size_t seam = first + 25 * ring;
    EXPECT_EQ(tube.uvs[seam].x, 0.0F);
    EXPECT_EQ(tube.uvs[seam + 24].x, tiles);
    EXPECT_EQ(tube.positions[seam], tube.positions[seam + 24]);
    if (ring == 0) continue;
    const float radius = 0.225F - 0.05F * static_cast<float>(ring);
    const float tile_around = static_cast<float>(2 * kPi) * radius / tiles;
    const float tile_along = 1 / (tube.uvs[seam].y - tube.uvs[seam - 25].y);
    EXPECT_NEAR(tile_along / tile_around, 1, 1e-5F);
  }
}

TEST(Tubes, SizeIsKnownBeforehand) {
  for (const Skeleton& skeleton : {random_tree(1, 2000), fork(60, 0.1F, 0.05F), Skeleton{}}) {
    for (const SurfaceOptions& surface : {bare(8), SurfaceOptions{}}) {
      const TubeSize size = TubePlan(skeleton, {{surface}}).sizes()[0];
      const Mesh mesh = tubes(skeleton, surface);
      EXPECT_EQ(size.triangles, mesh.triangle_count());
      EXPECT_EQ(size.vertices, mesh.vertex_count());
      EXPECT_EQ(size.bytes(), mesh.bytes());
    }
  }
}

TEST(Tubes, HaveTheSameBytesOnAnyNumberOfThreads) {
  const Skeleton skeleton = random_tree(7, 20000);
  std::string expected;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    const std::string got = bytes(tubes(skeleton, SurfaceOptions{}));
    if (expected.empty()) expected = got;
    EXPECT_EQ(got, expected) << threads;
  }
}

TEST(Tubes, LoneNodesMakeNothingAndLoneLateralNodesAStub) {
  EXPECT_EQ(tubes(Skeleton{}).triangle_count(), 0U);
  EXPECT_EQ(tubes(polyline({{1, 2, 3}}, {0.1F})).triangle_count(), 0U);
  Builder builder;
  const NodeIndex base = builder.add(kNoNode, Vec3(0), 0.1F, 0);
  builder.add(base, {0, 1, 0}, 0.1F, 0);
  builder.add(base, {1, 0, 0}, 0.05F, 1);
  const Mesh mesh = tubes(builder.skeleton);
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_EQ(euler_number(mesh), 4);
}

TEST(Tubes, BrokenSkeletonsGiveFiniteMeshes) {
  // Coinciding nodes and radii of 0 are invalid in a skeleton. The mesh is useless then, but must be finite.
  const Mesh mesh = tubes(polyline({{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}}, {0, 0.1F, 0, 0}));
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    EXPECT_TRUE(std::isfinite(glm::dot(mesh.positions[i], mesh.normals[i]) + mesh.uvs[i].x + mesh.uvs[i].y));
  }
}

RC_GTEST_PROP(Tubes, AreClosedAndFiniteForAnyPath, ()) {
  const auto share = [] { return static_cast<float>(*rc::gen::inRange(0, 1001)) / 1000.0F; };
  std::vector<Vec3> points{{0, 0, 0}};
  std::vector<float> radii{0.01F + 0.2F * share()};
  const int nodes = *rc::gen::inRange(2, 12);
  for (int i = 1; i < nodes; ++i) {
    const Vec3 step = tilted(180 * share(), 360 * share()) * (0.02F + share());
    points.push_back(points.back() + step);
    radii.push_back(radii.back() * (0.3F + 0.7F * share()));
  }
  // A random walk bends within its own radius, where triangles may lie behind normals. Edges and volume must be
  // correct.
  Mesh mesh = tubes(polyline(points, radii), bare(*rc::gen::inRange(3, 12)));
  mesh.normals.clear();
  RC_ASSERT(check_mesh(mesh, {.outward = false}));
}

TEST(Tubes, CountNodesAsProgressAndStopWhenAsked) {
  const Skeleton skeleton = random_tree(9, 5000);
  std::vector<double> seen;
  Progress progress([&](std::string_view, double fraction) { seen.push_back(fraction); });
  progress.begin("meshing", skeleton.node_count());
  make_tubes(skeleton, {}, progress);
  EXPECT_EQ(seen.back(), 1);
  progress.cancel();
  EXPECT_THROW(make_tubes(skeleton, {}, progress), Cancelled);
}

/// Returns a stem of many short segments along a quarter circle of 1 m, with an even taper.
Skeleton quarter_circle(int segments) {
  Skeleton stem;
  for (int i = 0; i <= segments; ++i) {
    const double angle = kPi / 2 * i / segments;
    const Vec3 position(static_cast<float>(1 - math::cos(angle)), static_cast<float>(math::sin(angle)), 0);
    const NodeIndex node = stem.add_node(i == 0 ? kNoNode : static_cast<NodeIndex>(i - 1), position, 0);
    stem.radius[node] = 0.1F - 0.05F * static_cast<float>(i) / static_cast<float>(segments);
  }
  return stem;
}

TEST(Tubes, LeaveOutRingsOnlyWithinTheErrorAllowed) {
  const Skeleton stem = quarter_circle(200);
  SurfaceOptions surface = bare(8);
  std::size_t last = tubes(stem, surface).triangle_count();
  for (const float error : {0.01F, 0.1F, 0.3F}) {
    surface.error = error;
    const TubePlan plan(stem, {{surface}});
    const AxisPath path = plan.path(0);
    EXPECT_LT(path.size(), 200U);
    for (NodeIndex node = 0; node < stem.node_count(); ++node) {
      float nearest = 1;
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        nearest = std::min(nearest, distance_to_segment(stem.position[node], path.position(i), path.position(i + 1)));
      }
      EXPECT_LE(nearest, error * stem.radius[node] * 1.001F + 1e-6F) << error << " " << node;
    }
    const Mesh mesh = tubes(stem, surface);
    EXPECT_TRUE(check_mesh(mesh));
    EXPECT_LE(mesh.triangle_count(), last);
    last = mesh.triangle_count();
  }
}

TEST(Tubes, StraightStemsKeepFewRings) {
  Skeleton stem;
  for (int i = 0; i <= 120; ++i) {
    const NodeIndex node = stem.add_node(i == 0 ? kNoNode : static_cast<NodeIndex>(i - 1), {0, 0.1F * i, 0}, 0);
    stem.radius[node] = 0.1F;
  }
  SurfaceOptions surface = bare(8);
  surface.error = 0.01F;
  EXPECT_LE(TubePlan(stem, {{surface}}).path(0).size(), 14U);
}

TEST(Tubes, CapsCloseTheTipAsAsked) {
  const Skeleton stem = quarter_circle(20);
  const auto volume = [&](SurfaceOptions::Cap cap) {
    SurfaceOptions surface = bare(24);
    surface.cap = cap;
    const Mesh mesh = tubes(stem, surface);
    EXPECT_TRUE(check_mesh(mesh));
    EXPECT_EQ(euler_number(mesh), 2);
    const TubeSize size = TubePlan(stem, {{surface}}).sizes()[0];
    EXPECT_EQ(size.vertices, mesh.vertex_count());
    EXPECT_EQ(size.triangles, mesh.triangle_count());
    return signed_volume(mesh);
  };
  // Compared with a flat end: a cone and a half ball of the tip's radius.
  const double cube = 0.05 * 0.05 * 0.05;
  const double flat = volume(SurfaceOptions::Cap::flat);
  EXPECT_NEAR(volume(SurfaceOptions::Cap::pointed) - flat, kPi / 3 * cube, 0.03 * cube);
  EXPECT_NEAR(volume(SurfaceOptions::Cap::round) - flat, 2 * kPi / 3 * cube, 0.25 * cube);
}

TEST(Tubes, AxesOfOneSkeletonMayWearTheirOwn) {
  Skeleton stem = quarter_circle(10);
  NodeIndex last = 5;
  for (int i = 1; i <= 5; ++i) {
    last = stem.add_node(last, stem.position[5] + Vec3(-0.1F * i, 0.05F * i, 0), 0);
    stem.radius[last] = 0.02F;
    stem.axis[last] = 1;
  }
  const TubePlan plan(stem, {{bare(16), 0}, {bare(4), 1}}, {0, 1});
  Progress progress;
  const std::vector<Mesh> meshes = make_tubes(plan, progress);
  ASSERT_EQ(meshes.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_TRUE(check_mesh(meshes[k]));
    EXPECT_EQ(meshes[k].triangle_count(), plan.sizes()[k].triangles);
  }
  EXPECT_EQ(plan[0].sides, 16U);
  EXPECT_EQ(plan[1].sides, 4U);
  // Side by side, they equal one mesh of equal surfaces.
  const Mesh one = tubes(stem, bare(16));
  EXPECT_EQ(std::vector<Vec3>(one.positions.begin(), one.positions.begin() + 16),
            std::vector<Vec3>(meshes[0].positions.begin(), meshes[0].positions.begin() + 16));
}

TEST(Tubes, RejectASurfaceWithoutATileSize) {
  Progress progress;
  EXPECT_THROW(make_tubes(fork(30, 0.1F, 0.1F), {.uv_scale = 0}, progress), std::invalid_argument);
}

Mesh textured_tube(const SurfaceOptions& surface) {
  Progress progress;
  return make_tubes(polyline({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}, {0.3F}), surface, progress);
}

TEST(TubeTexture, IsShiftedAndMirrored) {
  SurfaceOptions surface;
  surface.uv_scale = 0.5F;
  const Mesh plain = textured_tube(surface);
  surface.shift_u = 0.25F;
  surface.shift_v = -2;
  const Mesh shifted = textured_tube(surface);
  surface.mirror = true;
  const Mesh mirrored = textured_tube(surface);
  ASSERT_EQ(plain.uvs.size(), shifted.uvs.size());
  for (std::size_t k = 0; k < plain.uvs.size(); ++k) {
    EXPECT_LT(glm::distance(shifted.uvs[k], plain.uvs[k] + Vec2(0.25F, -2)), 1e-5F);
    EXPECT_LT(glm::distance(mirrored.uvs[k], Vec2(-1, 1) * plain.uvs[k] + Vec2(0.25F, -2)), 1e-5F);
  }
  EXPECT_EQ(plain.positions, shifted.positions);
}

// The first and the last vertex of each ring lie at one position, so their uvs must differ by whole tiles.
TEST(TubeTexture, JoinsAroundTheTubeAtEveryTurn) {
  SurfaceOptions surface;
  surface.uv_scale = 0.4F;
  constexpr float kTiles = 5;  // around the tube
  const Mesh plain = textured_tube(surface);
  for (const double turn : {17.0, 45.0, 90.0, 200.0, -60.0}) {
    surface.turn = static_cast<float>(radians(turn));
    const Mesh turned = textured_tube(surface);
    int seams = 0;
    for (std::size_t a = 0; a < plain.uvs.size(); ++a) {
      for (std::size_t b = a + 1; b < plain.uvs.size(); ++b) {
        if (plain.positions[a] != plain.positions[b] || plain.normals[a] != plain.normals[b]) continue;
        if (plain.uvs[a].y != plain.uvs[b].y || std::abs(plain.uvs[b].x - plain.uvs[a].x - kTiles) > 1e-4F) continue;
        ++seams;
        const Vec2 step = turned.uvs[b] - turned.uvs[a];
        EXPECT_LT(glm::distance(step, glm::round(step)), 1e-4F) << turn;
      }
    }
    EXPECT_GT(seams, 1);
  }
  surface.turn = static_cast<float>(kPi / 2);
  const Mesh on_its_side = textured_tube(surface);
  for (std::size_t k = 0; k < plain.uvs.size(); ++k) {
    EXPECT_LT(glm::distance(on_its_side.uvs[k], Vec2(-plain.uvs[k].y, plain.uvs[k].x)), 1e-4F);
  }
}

}  // namespace meristem::tubes_test
