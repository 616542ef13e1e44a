// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/tube/collar.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "meristem/base/random.h"
#include "meristem/shape/tube/tube_plan.h"
#include "tests/support/check_mesh.h"

namespace meristem::collar_test {

// Returns a stem of five nodes along y with a radius of 0.2 m, and a branch of another axis at its third node.
Skeleton fork(double angle_deg, float branch_radius, float segment = 0.4F) {
  Skeleton skeleton;
  const auto add = [&](NodeIndex parent, Vec3 position, float radius, AxisIndex axis) {
    const NodeIndex node = skeleton.add_node(parent, position, 0);
    skeleton.radius[node] = radius;
    skeleton.axis[node] = axis;
    return node;
  };
  NodeIndex stem = add(kNoNode, {0, -2, 0}, 0.2F, 0);
  for (int i = 1; i < 5; ++i) stem = add(stem, {0, i - 2, 0}, 0.2F, 0);
  const double angle = radians(angle_deg);
  const Vec3 way(math::sin(angle), math::cos(angle), 0);
  NodeIndex branch = 2;
  for (int i = 1; i <= 8; ++i) branch = add(branch, segment * static_cast<float>(i) * way, branch_radius, 1);
  return skeleton;
}

SurfaceOptions collared(int sides) { return {.sides = sides, .smooth = 0, .collar = 0.8F, .flare = 0}; }

Mesh tubes(const Skeleton& skeleton, const SurfaceOptions& surface) {
  Progress progress;
  return make_tubes(skeleton, surface, progress);
}

TEST(Bark, IsTheSurfaceOfItsCones) {
  const Skeleton skeleton = fork(90, 0.1F);
  const SurfaceOptions surface = collared(12);
  const TubePlan plan(skeleton, {{surface}});
  const Bark bark = plan.bark_below(plan.path(1));
  EXPECT_NEAR(bark.distance({0.5F, 0.1F, 0}), 0.3F, 1e-6F);
  EXPECT_NEAR(bark.distance({0, 0.1F, 0.05F}), -0.15F, 1e-6F);
  EXPECT_NEAR(glm::distance(bark.nearest({0, 0.3F, -2}).normal(), Vec3(0, 0, -1)), 0, 1e-6F);
  EXPECT_NEAR(bark.trace({1, 0.2F, 0}, {-1, 0, 0}, 2), 0.8F, 1e-3F);
  // Rays that miss the bark stop where they are nearest.
  EXPECT_EQ(bark.trace({1, 0.2F, 0}, {1, 0, 0}, 2), 0);
  EXPECT_NEAR(bark.trace({1, 0.2F, 0.25F}, {-1, 0, 0}, 2), 1, 0.05F);
}

TEST(Collar, BranchesComeFreeWhereTheirCrotchDoes) {
  for (const double angle : {30.0, 45.0, 60.0, 90.0, 120.0}) {
    const Skeleton skeleton = fork(angle, 0.08F);
    const SurfaceOptions surface = collared(16);
    const TubePlan plan(skeleton, {{surface}});
    const std::optional<Collar>& collar = plan[1].collar;
    ASSERT_TRUE(collar.has_value()) << angle;
    EXPECT_NEAR(collar->radius, 0.08F, 1e-6F);
    // Along the branch: out of the bark, past the crotch, and a fillet of 0.8 radii.
    const double sine = std::sin(radians(angle));
    const double expected = (0.2 + 0.08 * std::abs(std::cos(radians(angle)))) / sine + 0.8 * 0.08;
    EXPECT_NEAR(glm::length(collar->centre), expected, 1e-3) << angle;
  }
}

TEST(Collar, LeavesOutBranchesAlongTheBarkAndStubs) {
  const SurfaceOptions surface = collared(16);
  const Skeleton steep = fork(8, 0.1F);
  EXPECT_FALSE(TubePlan(steep, {{surface}})[1].collar.has_value());
  const Skeleton stub = fork(90, 0.1F, 0.02F);
  EXPECT_FALSE(TubePlan(stub, {{surface}})[1].collar.has_value());
  const Skeleton equal = fork(90, 0.2F);
  EXPECT_FALSE(TubePlan(equal, {{surface}})[1].collar.has_value());
  // Twigs whose swelling would be invisible have no collar.
  const Skeleton twig = fork(90, 0.002F);
  EXPECT_FALSE(TubePlan(twig, {{surface}})[1].collar.has_value());
}

TEST(Collar, FlowsIntoTheBarkWithItsNormalsAtEveryAngle) {
  for (const double angle : {25.0, 40.0, 60.0, 90.0, 120.0, 150.0}) {
    for (const float branch_radius : {0.04F, 0.09F, 0.15F, 0.185F}) {
      const Skeleton skeleton = fork(angle, branch_radius);
      const SurfaceOptions surface = collared(24);
      const TubePlan plan(skeleton, {{surface}});
      ASSERT_TRUE(plan[1].collar.has_value());
      const Mesh mesh = tubes(skeleton, surface);
      ASSERT_TRUE(check_mesh(mesh)) << angle << " " << branch_radius;
      const std::size_t stride = plan[1].sides + 1;
      const std::size_t hidden = plan[1].first_vertex + 1;
      for (std::size_t k = 0; k < stride; ++k) {
        const Vec3 low = mesh.positions[hidden + stride + k];
        const Vec3 outward = glm::normalize(Vec3(low.x, 0, low.z));
        EXPECT_NEAR(std::hypot(low.x, low.z), 0.2F - plan[1].sink, 1e-3F) << angle << " " << branch_radius;
        EXPECT_GT(glm::dot(mesh.normals[hidden + stride + k], outward), 0.999F);
        const Vec3 below = mesh.positions[hidden + k];
        EXPECT_LT(std::hypot(below.x, below.z), std::hypot(low.x, low.z));
        // In between, the normal turns steadily from the bark's direction to the branch's.
        const Vec3 free = mesh.normals[hidden + 4 * stride + k];
        const Vec3 inner = mesh.normals[hidden + 2 * stride + k];
        EXPECT_GT(glm::dot(inner, outward) + 0.05F, glm::dot(free, outward));
      }
    }
  }
}

TEST(Collar, RandomTreesStayClosed) {
  const RandomKey key(4);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Skeleton tree;
    tree.add_node(kNoNode, Vec3(0), 0);
    tree.radius[0] = 0.1F;
    AxisIndex axes = 1;
    std::vector<bool> has_next{false};
    for (std::uint64_t i = 1; i < 300; ++i) {
      const auto low = static_cast<double>(i > 40 ? i - 40 : 0);
      const auto parent =
          static_cast<NodeIndex>(key.child(seed).child("parent").uniform(i, low, static_cast<double>(i)));
      const Vec3 step = 0.15F * glm::normalize(key.child(seed).child("step").direction(i) + Vec3(0, 1, 0));
      const NodeIndex node = tree.add_node(parent, tree.position[parent] + step, 0);
      tree.radius[node] = 0.95F * tree.radius[parent];
      tree.axis[node] = has_next[parent] ? axes++ : tree.axis[parent];
      has_next[parent] = true;
      has_next.push_back(false);
    }
    // Branches as thick as their parent leave at any angle here. Edges and volume must be correct, but normals need
    // not.
    Mesh mesh = tubes(tree, SurfaceOptions{.sides = 12});
    mesh.normals.clear();
    EXPECT_TRUE(check_mesh(mesh, {.outward = false})) << seed;
    EXPECT_EQ(euler_number(mesh), 2 * static_cast<long>(axes)) << seed;
  }
}

TEST(Flare, WidensARootTowardTheGroundAndNothingElse) {
  const Skeleton skeleton = fork(90, 0.05F);
  const SurfaceOptions surface{.sides = 16, .smooth = 0, .collar = 0, .flare = 0.5F};
  const Mesh mesh = tubes(skeleton, surface);
  ASSERT_TRUE(check_mesh(mesh));
  const Mesh plain = tubes(skeleton, {.sides = 16, .smooth = 0, .collar = 0, .flare = 0});
  float at_ground = 0;
  for (const Vec3 point : mesh.positions) {
    if (point.y < -1.999F) at_ground = std::max(at_ground, std::hypot(point.x, point.z));
  }
  EXPECT_NEAR(at_ground, 0.3F, 1e-5F);
  EXPECT_GT(signed_volume(mesh), signed_volume(plain) * 1.02);
  EXPECT_EQ(mesh.positions.back(), plain.positions.back());
}

TEST(SmoothRadii, SpreadAStepAndKeepTheEnds) {
  Skeleton stem;
  for (int i = 0; i <= 40; ++i) {
    const NodeIndex node = stem.add_node(i == 0 ? kNoNode : static_cast<NodeIndex>(i - 1), {0, 0.1F * i, 0}, 0);
    stem.radius[node] = i <= 20 ? 0.1F : 0.06F;
  }
  const SurfaceOptions surface{.sides = 8, .error = 0, .smooth = 3, .collar = 0, .flare = 0};
  const TubePlan plan(stem, {{surface}});
  const AxisPath path = plan.path(0);
  EXPECT_EQ(path.radius(0), 0.1F);
  EXPECT_EQ(path.radius(40), 0.06F);
  EXPECT_NEAR(path.radius(10), 0.1F, 1e-6F);
  float steepest = 0;
  for (std::size_t i = 1; i <= 40; ++i) {
    EXPECT_LE(path.radius(i), path.radius(i - 1) + 1e-6F);
    steepest = std::max(steepest, path.radius(i - 1) - path.radius(i));
  }
  EXPECT_LT(steepest, 0.015F);  // 0.04 in the skeleton
}

}  // namespace meristem::collar_test
