// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/split_trees.h"

#include <gtest/gtest.h>

#include "tests/support/check_skeleton.h"

namespace meristem::split_trees_test {

/// A stem of two segments with one lateral.
Skeleton fork() {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, Vec3(1, 0, 1), 0);
  skeleton.add_node(0, Vec3(1, 1, 1), 1);
  skeleton.add_node(1, Vec3(1, 2, 1), 2);
  skeleton.add_node(1, Vec3(2, 2, 1), 2);
  skeleton.axis[3] = 1;
  skeleton.order[3] = 1;
  skeleton.radius = {0.2F, 0.1F, 0.05F, 0.04F};
  return skeleton;
}

TEST(SplitTrees, AForestFallsIntoItsTrees) {
  // Two trees with alternating nodes; the second tree is moved.
  const Skeleton one = fork();
  Skeleton forest;
  for (NodeIndex node = 0; node < one.node_count(); ++node) {
    for (NodeIndex which = 0; which < 2; ++which) {
      const NodeIndex parent = one.is_root(node) ? kNoNode : 2 * one.parent[node] + which;
      const NodeIndex added = forest.add_node(parent, one.position[node] + Vec3(which, 0, 0), one.birth[node]);
      forest.axis[added] = 2 * one.axis[node] + which;
      forest.order[added] = one.order[node];
      forest.radius[added] = one.radius[node];
    }
  }
  forest.extra["light"].resize(forest.node_count());
  for (NodeIndex node = 0; node < forest.node_count(); ++node) forest.extra["light"][node] = static_cast<float>(node);
  const std::vector<Skeleton> trees = split_trees(forest);
  ASSERT_EQ(trees.size(), 2U);
  for (std::size_t which = 0; which < 2; ++which) {
    EXPECT_TRUE(check_skeleton(trees[which]));
    EXPECT_EQ(trees[which].parent, one.parent);
    EXPECT_EQ(trees[which].axis, one.axis);
    EXPECT_EQ(trees[which].radius, one.radius);
    EXPECT_EQ(trees[which].extra.at("light")[3], static_cast<float>(6 + which));
    EXPECT_EQ(trees[which].position[3], one.position[3] + Vec3(which, 0, 0));
  }
}

}  // namespace meristem::split_trees_test
