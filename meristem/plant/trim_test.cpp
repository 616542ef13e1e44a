// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/trim.h"

#include <gtest/gtest.h>

#include "meristem/plant/operation_record.h"
#include "meristem/plant/pipe_radii.h"
#include "tests/support/check_skeleton.h"

namespace meristem::trim_test {

/// The region below a height.
auto below(float height) {
  return [height](Vec3 from, Vec3 to) {
    if (from.y > height) return 0.0F;
    return to.y <= height ? 1.0F : (height - from.y) / (to.y - from.y);
  };
}

/// A stem 4 m high, from 0.4 to 0.1 m thick, with a level branch at each metre.
Skeleton ladder() {
  Skeleton tree;
  NodeIndex last = tree.add_node(kNoNode, Vec3(0), 0);
  tree.radius[0] = 0.4F;
  std::vector<NodeIndex> stem = {0};
  for (int k = 1; k <= 4; ++k) {
    last = tree.add_node(last, {0, k, 0}, static_cast<float>(k));
    tree.radius[last] = 0.4F - 0.075F * static_cast<float>(k);
    stem.push_back(last);
  }
  for (int k = 1; k <= 4; ++k) {
    const NodeIndex first = tree.add_node(stem[k], {1, k, 0}, 5);
    const NodeIndex tip = tree.add_node(first, {2, static_cast<float>(k) + 0.2F, 0}, 6);
    for (const NodeIndex node : {first, tip}) {
      tree.radius[node] = 0.05F;
      tree.axis[node] = static_cast<AxisIndex>(k);
      tree.order[node] = 1;
    }
  }
  return tree;
}

TEST(TrimSkeleton, LeavesASkeletonInsideAsItIs) {
  EXPECT_TRUE(trim_skeleton(ladder(), below(10), TrimMode::cut).is_whole);
  EXPECT_TRUE(trim_skeleton(ladder(), below(10), TrimMode::fit).is_whole);
}

TEST(TrimSkeleton, ACutStemEndsAtTheBoundaryAsThickAsItWasThere) {
  const Skeleton whole = ladder();
  const TrimmedSkeleton trimmed = trim_skeleton(whole, below(2.5F), TrimMode::cut);
  ASSERT_FALSE(trimmed.is_whole);
  ASSERT_TRUE(check_skeleton(trimmed.skeleton));
  const NodeIndex end = trimmed.node[3];
  EXPECT_FLOAT_EQ(trimmed.skeleton.position[end].y, 2.5F);
  EXPECT_FLOAT_EQ(trimmed.skeleton.radius[end], 0.5F * (whole.radius[2] + whole.radius[3]));
  EXPECT_EQ(trimmed.skeleton.extra.at("cut")[end], 1);
  EXPECT_FLOAT_EQ(trimmed.kept[3], 0.5F);
  EXPECT_EQ(trimmed.node[4], kNoNode);
  for (NodeIndex node = 0; node < trimmed.skeleton.node_count(); ++node) {
    EXPECT_EQ(trimmed.skeleton.extra.at("cut")[node], node == end ? 1 : 0) << node;
    EXPECT_LE(trimmed.skeleton.position[node].y, 2.5F);
  }
}

TEST(TrimSkeleton, KeepsWhatWasDoneToTheTree) {
  Skeleton whole = ladder();
  whole.operations.add({.operation = "components.tree.operations[0]", .act = "cut", .position = {0, 3, 0}});
  EXPECT_EQ(trim_skeleton(whole, below(2.5F), TrimMode::fit).skeleton.operations, whole.operations);
}

TEST(TrimSkeleton, WhatGrowsBeyondIsGone) {
  const TrimmedSkeleton trimmed = trim_skeleton(ladder(), below(2.5F), TrimMode::cut);
  // The stem up to 2.5 m, and two branches with two nodes each.
  EXPECT_EQ(trimmed.skeleton.node_count(), 4U + 4U);
  EXPECT_EQ(SkeletonAxes(trimmed.skeleton).count(), 3U);
}

TEST(TrimSkeleton, AStemThatFitsHasTheFormOfTheWholeStem) {
  const Skeleton whole = ladder();
  const TrimmedSkeleton trimmed = trim_skeleton(whole, below(2), TrimMode::fit);
  ASSERT_TRUE(check_skeleton(trimmed.skeleton));
  const NodeIndex tip = trimmed.node[2];
  // Half as long, so half as thick at equal shares of the length.
  EXPECT_FLOAT_EQ(trimmed.skeleton.radius[tip], 0.5F * whole.radius[4]);
  EXPECT_FLOAT_EQ(trimmed.skeleton.radius[trimmed.node[1]], 0.5F * whole.radius[2]);
  EXPECT_FLOAT_EQ(trimmed.skeleton.radius[trimmed.node[0]], 0.5F * whole.radius[0]);
  EXPECT_EQ(trimmed.skeleton.extra.count("cut"), 0U);
}

TEST(TrimSkeleton, NoBranchOfAStemThatFitsIsThickerThanTheStem) {
  Skeleton whole = ladder();
  whole.radius[4] = 0.01F;
  const TrimmedSkeleton trimmed = trim_skeleton(whole, below(3.05F), TrimMode::fit);
  ASSERT_TRUE(check_skeleton(trimmed.skeleton));
}

TEST(TrimSkeleton, ARootOutsideIsGoneWithAllThatGrowsOnIt) {
  const TrimmedSkeleton trimmed = trim_skeleton(ladder(), below(-1), TrimMode::cut);
  EXPECT_FALSE(trimmed.is_whole);
  EXPECT_EQ(trimmed.skeleton.node_count(), 0U);
}

TEST(TrimSkeleton, EachRootOfAForestStandsForItself) {
  Skeleton forest = ladder();
  Skeleton second = ladder();
  for (Vec3& position : second.position) position.y += 3;
  forest.append(second);
  const TrimmedSkeleton trimmed = trim_skeleton(forest, below(2.5F), TrimMode::cut);
  ASSERT_TRUE(check_skeleton(trimmed.skeleton));
  EXPECT_EQ(trimmed.skeleton.node_count(), 8U);
}

TEST(TrimSkeleton, AnAxisThatLeavesAndComesBackEndsWhereItFirstLeaves) {
  Skeleton arch;
  NodeIndex last = arch.add_node(kNoNode, Vec3(0), 0);
  for (const Vec3 at : {Vec3(1, 1, 0), Vec3(2, 3, 0), Vec3(3, 1, 0), Vec3(4, 0, 0)}) last = arch.add_node(last, at, 1);
  assign_pipe_radii(arch, {});
  assign_axes(arch);
  const TrimmedSkeleton trimmed = trim_skeleton(arch, below(2), TrimMode::cut);
  EXPECT_EQ(trimmed.skeleton.node_count(), 3U);
  EXPECT_EQ(trimmed.skeleton.position[2], Vec3(1.5F, 2, 0));
}

TEST(TrimSkeleton, FurtherColumnsAreThoseOfTheSegmentThatIsCut) {
  Skeleton whole = ladder();
  whole.extra["light"] = std::vector<float>(whole.node_count(), 0);
  for (NodeIndex node = 0; node < 5; ++node) whole.extra["light"][node] = static_cast<float>(node);
  const TrimmedSkeleton trimmed = trim_skeleton(whole, below(2.5F), TrimMode::cut);
  EXPECT_FLOAT_EQ(trimmed.skeleton.extra.at("light")[trimmed.node[3]], 2.5F);
}

}  // namespace meristem::trim_test
