// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/finish.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/random.h"
#include "meristem/plant/pipe_radii.h"
#include "tests/support/check_skeleton.h"

namespace meristem::finish_test {

constexpr double kStep = 0.05;

// A stem of `nodes` steps with a fork in the middle; the lateral is as long as the upper half of the stem.
Skeleton forked_stem(int nodes) {
  Skeleton skeleton;
  NodeIndex last = skeleton.add_node(kNoNode, Vec3(0), 0);
  const int fork = nodes / 2;
  for (int k = 1; k <= nodes; ++k) last = skeleton.add_node(last, Vec3(0, k * kStep, 0), static_cast<float>(k));
  last = static_cast<NodeIndex>(fork);
  for (int k = 1; k <= nodes - fork; ++k) {
    last = skeleton.add_node(last, Vec3(k * kStep, fork * kStep, 0), static_cast<float>(fork + k));
  }
  return skeleton;
}

// A branch along a circle of radius 1 in the xy plane.
Skeleton arc(int nodes, double angle) {
  Skeleton skeleton;
  NodeIndex last = kNoNode;
  for (int k = 0; k <= nodes; ++k) {
    const double at = angle * k / nodes;
    last = skeleton.add_node(last, Vec3(std::cos(at), std::sin(at), 0), static_cast<float>(k));
  }
  return skeleton;
}

testing::AssertionResult check_finished(Skeleton skeleton) {
  assign_pipe_radii(skeleton, {});
  assign_axes(skeleton);
  return check_skeleton(skeleton);
}

std::vector<float> births(const Skeleton& skeleton) { return skeleton.birth; }

TEST(Decimate, KeepsEveryFourthInnerNodeAtFourSteps) {
  Skeleton stem;
  NodeIndex last = stem.add_node(kNoNode, Vec3(0), 0);
  for (int k = 1; k <= 13; ++k) last = stem.add_node(last, Vec3(0, k * kStep, 0), static_cast<float>(k));
  EXPECT_EQ(births(decimate(stem, 4 * kStep, kStep)), (std::vector<float>{0, 4, 8, 12, 13}));
}

TEST(Decimate, KeepsRootForkAndTips) {
  const Skeleton skeleton = forked_stem(6);
  const Skeleton result = decimate(skeleton, 100, kStep);
  EXPECT_TRUE(check_finished(result));
  EXPECT_EQ(result.parent, (std::vector<NodeIndex>{kNoNode, 0, 1, 1}));
  EXPECT_EQ(births(result), (std::vector<float>{0, 3, 6, 6}));
  EXPECT_EQ(result.position[1], skeleton.position[3]);
}

TEST(Decimate, KeepsAllBelowHalfAStep) {
  const Skeleton skeleton = forked_stem(8);
  EXPECT_EQ(skeleton_hash(decimate(skeleton, 1.49 * kStep, kStep)), skeleton_hash(skeleton));
}

TEST(Decimate, CarriesExtraColumns) {
  Skeleton skeleton = forked_stem(4);
  skeleton.extra["light"] = skeleton.birth;
  const Skeleton result = decimate(skeleton, 100, kStep);
  EXPECT_EQ(result.extra.at("light"), result.birth);
}

/// A forked stem with assigned axes, and radii that fall linearly.
Skeleton clothed_stem(int nodes) {
  Skeleton skeleton = forked_stem(nodes);
  assign_axes(skeleton);
  for (std::size_t k = 0; k < skeleton.node_count(); ++k) skeleton.radius[k] = 0.1F - 0.01F * skeleton.birth[k];
  return skeleton;
}

FinishContext free_context(double step, const Progress& progress) {
  static const auto is_open = [](Vec3, Vec3) { return true; };
  static const auto require_nodes = [](std::uint64_t) {};
  return {step, is_open, require_nodes, progress};
}

TEST(Finish, CarriesAxesOrdersAndRadii) {
  const Skeleton stem = clothed_stem(8);
  const Progress progress;
  const Skeleton done = finish(stem, {.decimate = 2, .relax = false, .subdivide = 0.25}, free_context(kStep, progress));
  EXPECT_TRUE(check_skeleton(done));
  EXPECT_EQ(*std::max_element(done.axis.begin(), done.axis.end()), 1U);
  for (NodeIndex node = 0; node < done.node_count(); ++node) {
    const Vec3 position = done.position[node];
    EXPECT_EQ(done.axis[node], position.x > 0 ? 1U : 0U);
    EXPECT_EQ(done.order[node], position.x > 0 ? 1 : 0);
    // On straight branches, births and radii change linearly. A lateral starts with the radius of its own first node.
    const double steps = (position.x + position.y) / kStep;
    if (position.x == 0) {
      EXPECT_NEAR(done.radius[node], 0.1 - 0.01 * steps, 1e-6);
    } else {
      EXPECT_LE(done.radius[node], 0.1 - 0.01 * 4);
    }
  }
}

TEST(Finish, KeepsAndFollowsNodesThatSomethingStandsOn) {
  const Skeleton stem = clothed_stem(8);
  TrackedNodes tracked;
  tracked.stays.resize(stem.node_count(), 0);
  tracked.stays[2] = tracked.stays[7] = 1;
  const Progress progress;
  const Skeleton done = finish(stem, {.decimate = 100, .relax = false}, free_context(kStep, progress), &tracked);
  EXPECT_EQ(births(done), (std::vector<float>{0, 2, 4, 7, 8, 8}));
  EXPECT_EQ(tracked.now[2], 1U);
  EXPECT_EQ(tracked.now[7], 3U);
  EXPECT_EQ(done.position[tracked.now[7]], stem.position[7]);

  tracked.now.clear();
  const Skeleton fine = finish(stem, {.relax = false, .subdivide = 0.3}, free_context(kStep, progress), &tracked);
  EXPECT_GT(fine.node_count(), stem.node_count());
  EXPECT_EQ(fine.position[tracked.now[2]], stem.position[2]);
  EXPECT_EQ(fine.position[tracked.now[7]], stem.position[7]);
}

TEST(Finish, KeepsMarkedEnds) {
  Skeleton stem = clothed_stem(8);
  stem.extra["end"].assign(stem.node_count(), 0);
  stem.extra["end"][2] = 1;
  const Progress progress;
  const Skeleton done = finish(stem, {.decimate = 100, .subdivide = 0.4}, free_context(kStep, progress));
  const std::vector<float>& end = done.extra.find("end")->second;
  EXPECT_EQ(std::count(end.begin(), end.end(), 1), 1);
}

TEST(Relax, MovesNodesHalfwayToTheirParentsOldPlaces) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  skeleton.add_node(0, {0, 2, 0}, 1);
  skeleton.add_node(1, {2, 2, 0}, 2);
  skeleton.add_node(1, {0, 2, 2}, 2);
  relax_angles(skeleton);
  EXPECT_EQ(skeleton.position, (std::vector<Vec3>{{0, 0, 0}, {0, 1, 0}, {1, 2, 0}, {0, 2, 1}}));
}

TEST(Relax, TurnsARightAngleIntoHalfOfOne) {
  // Both segments after the fork lean back toward the stem: (1, 1) instead of (1, 0).
  Skeleton skeleton;
  skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  skeleton.add_node(0, {0, 1, 0}, 1);
  skeleton.add_node(1, {1, 1, 0}, 2);
  relax_angles(skeleton);
  EXPECT_EQ(skeleton.position[2] - skeleton.position[1], Vec3(0.5F, 0.5F, 0));
}

TEST(Subdivide, PlacesNodesAtEqualArcDistance) {
  const Skeleton result = subdivide(arc(12, 1.5), 0.03);
  ASSERT_TRUE(check_finished(result));
  ASSERT_EQ(result.node_count(), 51U);
  for (std::size_t node = 1; node < result.node_count(); ++node) {
    const double segment = glm::distance(DVec3(result.position[node]), DVec3(result.position[node - 1]));
    EXPECT_NEAR(segment, 0.03, 0.0003);
  }
}

TEST(Subdivide, StaysOnTheCircleThroughItsNodes) {
  // The error is largest at the straight ends of the natural spline; inside the arc it is a hundred times smaller.
  const Skeleton result = subdivide(arc(24, 1.5), 0.01);
  for (const Vec3 position : result.position) EXPECT_NEAR(glm::length(position), 1, 3e-4);
}

TEST(Subdivide, KeepsTheEndsOfBranches) {
  const Skeleton skeleton = forked_stem(7);
  const Skeleton result = subdivide(skeleton, kStep / 3);
  ASSERT_TRUE(check_finished(result));
  EXPECT_EQ(result.node_count(), 1U + 3 * 3 + 4 * 3 + 4 * 3);
  EXPECT_EQ(result.position[0], skeleton.position[0]);
  const NodeChildren children(result);
  std::vector<Vec3> ends;
  for (NodeIndex node = 0; node < result.node_count(); ++node) {
    if (children.of(node).size() != 1) ends.push_back(result.position[node]);
  }
  EXPECT_EQ(ends, (std::vector<Vec3>{skeleton.position[3], skeleton.position[7], skeleton.position[11]}));
}

TEST(Subdivide, BirthsLieBetweenTheirNeighbours) {
  Skeleton skeleton = forked_stem(9);
  skeleton.extra["light"] = skeleton.birth;
  const Skeleton result = subdivide(skeleton, kStep / 4.5);
  for (NodeIndex node = 1; node < result.node_count(); ++node) {
    EXPECT_GE(result.birth[node], result.birth[result.parent[node]]);
    // On these straight branches, births are proportional to the length along them.
    const Vec3 position = result.position[node];
    EXPECT_NEAR(result.birth[node] * kStep, position.x + position.y, 1e-4);
  }
  EXPECT_EQ(result.extra.at("light"), result.birth);
}

TEST(Subdivide, JoinsBranchesOfOneSegmentStraight) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  skeleton.add_node(0, {0, 1, 0}, 1);
  const Skeleton result = subdivide(skeleton, 0.25);
  ASSERT_EQ(result.node_count(), 5U);
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(result.position[k].y, 0.25 * k, 1e-6);
}

TEST(Subdivide, PassesOverNodesThatStandOnTheirParents) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  skeleton.add_node(0, {0, 0, 0}, 1);
  skeleton.add_node(1, {0, 1, 0}, 2);
  skeleton.add_node(2, {0, 2, 0}, 3);
  skeleton.add_node(3, {0, 2, 0}, 4);
  const Skeleton result = subdivide(skeleton, 0.5);
  EXPECT_TRUE(check_finished(result));
  EXPECT_EQ(result.node_count(), 5U);
  EXPECT_EQ(result.birth.back(), 4);
}

TEST(Subdivide, KeepsLoneRootsAndRejectsNoSpacing) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, {1, 2, 3}, 0);
  EXPECT_EQ(skeleton_hash(subdivide(skeleton, 1)), skeleton_hash(skeleton));
  EXPECT_THROW(subdivide(skeleton, 0), std::invalid_argument);
  EXPECT_THROW(subdivide(skeleton, NAN), std::invalid_argument);
}

}  // namespace meristem::finish_test
