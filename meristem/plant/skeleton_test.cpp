// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/skeleton.h"

#include <cmath>

#include <gtest/gtest.h>

#include "meristem/plant/plant.h"
#include "tests/support/check_skeleton.h"

namespace meristem::skeleton_test {

// A stem 0-1-2-4 with a lateral 3-5 from node 1, and a second root 6.
Skeleton two_plants() {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  skeleton.add_node(0, {0, 1, 0}, 1);
  skeleton.add_node(1, {0, 2, 0}, 2);
  skeleton.add_node(1, {1, 1, 0}, 2);
  skeleton.add_node(2, {0, 5, 0}, 3);
  skeleton.add_node(3, {1, 1, 1}, 3);
  skeleton.add_node(kNoNode, {7, 0, 0}, 0);
  skeleton.axis = {0, 0, 0, 1, 0, 1, 2};
  skeleton.order = {0, 0, 0, 1, 0, 1, 0};
  skeleton.radius = {0.5F, 0.5F, 0.25F, 0.25F, 0.125F, 0.125F, 0.125F};
  return skeleton;
}

TEST(Skeleton, CountsItsAxes) {
  EXPECT_EQ(Skeleton().axis_count(), 0U);
  EXPECT_EQ(two_plants().axis_count(), 3U);
}

TEST(Skeleton, AddsNodesWithEveryColumn) {
  Skeleton skeleton;
  skeleton.extra["light"];
  skeleton.add_node(kNoNode, {1, 2, 3}, 0.5F);
  EXPECT_EQ(skeleton.add_node(0, {1, 3, 3}, 1), 1U);
  EXPECT_TRUE(skeleton.is_root(0));
  EXPECT_FALSE(skeleton.is_root(1));
  EXPECT_EQ(skeleton.extra["light"].size(), 2U);
  skeleton.radius = {1, 1};
  EXPECT_TRUE(check_skeleton(skeleton));
}

TEST(Skeleton, ChildrenAreListedByRisingIndex) {
  const Skeleton skeleton = two_plants();
  const NodeChildren children(skeleton);
  ASSERT_EQ(children.of(1).size(), 2U);
  EXPECT_EQ(children.of(1)[0], 2U);
  EXPECT_EQ(children.of(1)[1], 3U);
  EXPECT_EQ(children.of(3)[0], 5U);
  EXPECT_TRUE(children.of(4).empty());
  EXPECT_TRUE(children.of(6).empty());
}

TEST(Skeleton, AxesRunFromBaseToTip) {
  const Skeleton skeleton = two_plants();
  const SkeletonAxes axes(skeleton);
  ASSERT_EQ(axes.count(), 3U);
  const auto stem = axes.of(0);
  EXPECT_EQ(std::vector(stem.begin(), stem.end()), (std::vector<NodeIndex>{0, 1, 2, 4}));
  const auto lateral = axes.of(1);
  EXPECT_EQ(std::vector(lateral.begin(), lateral.end()), (std::vector<NodeIndex>{3, 5}));
}

TEST(Skeleton, EmptySkeletonsHaveNoAxesAndNoBounds) {
  const Skeleton empty;
  EXPECT_EQ(SkeletonAxes(empty).count(), 0U);
  EXPECT_TRUE(bounds(empty).is_empty());
  EXPECT_TRUE(tip_distance(empty).empty());
  EXPECT_TRUE(check_skeleton(empty));
}

TEST(Skeleton, TipDistanceFollowsTheLongestWay) {
  EXPECT_EQ(tip_distance(two_plants()), (std::vector<float>{5, 4, 3, 1, 0, 0, 0}));
}

TEST(Skeleton, BoundsIncludeRadii) {
  const Box box = bounds(two_plants());
  EXPECT_EQ(box.low, Vec3(-0.5F, -0.5F, -0.5F));
  EXPECT_EQ(box.high, Vec3(7.125F, 5.125F, 1.125F));
}

TEST(Skeleton, HashChangesWithEveryColumn) {
  const Skeleton original = two_plants();
  const std::string hash = skeleton_hash(original);
  EXPECT_EQ(skeleton_hash(two_plants()), hash);
  const auto changed = [&](auto change) {
    Skeleton skeleton = original;
    change(skeleton);
    return skeleton_hash(skeleton) != hash;
  };
  EXPECT_TRUE(changed([](Skeleton& s) { s.parent[5] = 2; }));
  EXPECT_TRUE(changed([](Skeleton& s) { s.position[5].z = 2; }));
  EXPECT_TRUE(changed([](Skeleton& s) { s.radius[5] = 2; }));
  EXPECT_TRUE(changed([](Skeleton& s) { s.axis[5] = 2; }));
  EXPECT_TRUE(changed([](Skeleton& s) { s.order[5] = 2; }));
  EXPECT_TRUE(changed([](Skeleton& s) { s.birth[5] = 2; }));
  EXPECT_TRUE(changed([](Skeleton& s) { s.extra["light"].assign(7, 1); }));
}

TEST(CheckSkeleton, NamesEachKindOfFault) {
  EXPECT_TRUE(check_skeleton(two_plants()));
  const auto error = [](auto change) {
    Skeleton skeleton = two_plants();
    change(skeleton);
    const testing::AssertionResult result = check_skeleton(skeleton);
    return result ? std::string("none") : std::string(result.message());
  };
  EXPECT_EQ(error([](Skeleton& s) { s.birth.pop_back(); }), "column 'birth' has 6 entries for 7 nodes");
  EXPECT_EQ(error([](Skeleton& s) { s.position[2].x = NAN; }), "node 2 has a number that is not finite");
  EXPECT_EQ(error([](Skeleton& s) { s.radius[4] = 0; }), "node 4 has radius 0");
  EXPECT_EQ(error([](Skeleton& s) { s.radius[4] = 1; }), "node 4 has radius 1, above its parent's 0.25");
  EXPECT_EQ(error([](Skeleton& s) { s.parent[3] = 5; }), "node 3 comes before its parent 5");
  EXPECT_EQ(error([](Skeleton& s) { s.birth[4] = 1; }), "node 4 is born at 1, before its parent at 2");
  EXPECT_EQ(error([](Skeleton& s) { s.position[5] = s.position[3]; }), "node 5 is 0 m from its parent");
  EXPECT_EQ(error([](Skeleton& s) { s.axis[6] = 3; }), "node 6 begins axis 3 where 2 is next");
  EXPECT_EQ(error([](Skeleton& s) { s.axis[5] = 0; }),
            "node 5 is on axis 0, but its parent is not that axis's last node");
  EXPECT_EQ(error([](Skeleton& s) { s.order[5] = 2; }), "node 5 has another order than its axis");
  EXPECT_EQ(error([](Skeleton& s) { s.order[3] = 2; }), "node 3 begins an axis of order 2 where 1 is due");
}

TEST(Plant, CountsTheNodesOfAllStems) {
  Plant plant;
  EXPECT_EQ(plant.node_count(), 0U);
  plant.stems.resize(2);
  plant.stems[0].skeleton = two_plants();
  plant.stems[1].skeleton = two_plants();
  EXPECT_EQ(plant.node_count(), 14U);
}

}  // namespace meristem::skeleton_test
