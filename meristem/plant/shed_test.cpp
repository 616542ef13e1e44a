// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/shed.h"

#include <cmath>

#include <gtest/gtest.h>

#include "meristem/plant/pipe_radii.h"
#include "tests/support/check_skeleton.h"

namespace meristem::shed_test {

// A stem of four nodes. From the second grows a lateral with a fork, from the third a single twig.
Skeleton small_tree() {
  Skeleton tree;
  tree.add_node(kNoNode, {0, 0, 0}, 0);
  tree.add_node(0, {0, 1, 0}, 1);
  tree.add_node(1, {0, 2, 0}, 2);
  tree.add_node(2, {0, 3, 0}, 3);
  tree.add_node(1, {1, 1, 0}, 2);
  tree.add_node(4, {2, 1, 0}, 3);
  tree.add_node(4, {1, 2, 0}, 3);
  tree.add_node(2, {-1, 2, 0}, 3);
  tree.add_node(3, {0, 4, 0}, 4);
  tree.add_node(8, {0.5F, 5, 0}, 5);
  tree.add_node(8, {-0.5F, 5, 0}, 5);
  assign_pipe_radii(tree, {.tip_radius = 0.01, .exponent = 2});
  assign_axes(tree);
  return tree;
}

std::vector<std::uint8_t> marks(const Skeleton& tree, NodeIndex node) {
  std::vector<std::uint8_t> marked(tree.node_count(), 0);
  marked[node] = 1;
  return marked;
}

TEST(ShedBranches, TakesABranchWithAllThatGrowsOnIt) {
  const Skeleton tree = small_tree();
  const Skeleton kept = shed_branches(tree, marks(tree, 4));
  ASSERT_TRUE(check_skeleton(kept));
  EXPECT_EQ(kept.node_count(), tree.node_count() - 3);
  for (const Vec3 position : kept.position) EXPECT_LT(position.x, 0.9F);
  EXPECT_EQ(kept.extra.at("shed")[1], 2);
}

TEST(ShedBranches, LeavesStemsAndBranchesMarkedElsewhereThanAtTheirBase) {
  const Skeleton tree = small_tree();
  for (const NodeIndex node : {0U, 1U, 3U}) {
    EXPECT_EQ(shed_branches(tree, marks(tree, node)).node_count(), tree.node_count());
  }
}

TEST(ShedBranches, CountsOnWhatWasLostBefore) {
  const Skeleton tree = small_tree();
  const Skeleton once = shed_branches(tree, marks(tree, 5));  // node 5 or its twin, whichever is the lateral
  const Skeleton twice = shed_branches(once, std::vector<std::uint8_t>(once.node_count(), 1));
  ASSERT_TRUE(check_skeleton(twice));
  float lost = 0;
  for (const float tips : twice.extra.at("shed")) lost += tips;
  EXPECT_EQ(lost, 4);  // of five tips, only the stem's tip remains
}

TEST(ShedBranches, WoodRemembersWhatItBoreAsFarAsItsMemoryGoes) {
  const Skeleton tree = small_tree();
  for (const double memory : {0.0, 0.5, 1.0}) {
    Skeleton kept = shed_branches(tree, marks(tree, 4));
    assign_pipe_radii(kept, {.tip_radius = 0.01, .exponent = 2, .memory = memory});
    EXPECT_NEAR(kept.radius[0], 0.01 * std::sqrt(3 + 2 * memory), 1e-7);
    EXPECT_EQ(kept.radius[1], kept.radius[0]);
    EXPECT_NEAR(kept.radius[2], 0.01 * std::sqrt(3), 1e-7);
  }
}

}  // namespace meristem::shed_test
