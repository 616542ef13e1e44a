// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/mtg/mtg_layout.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace meristem::mtg_layout_test {

using testing::ElementsAre;

/// Adds a node that continues the axis of its parent, or begins an axis.
NodeIndex add(Skeleton& skeleton, NodeIndex parent, bool continues) {
  const AxisIndex next = skeleton.axis.empty() ? 0 : *std::ranges::max_element(skeleton.axis) + 1;
  const NodeIndex node = skeleton.add_node(parent, Vec3(0), 0);
  skeleton.axis[node] = continues && parent != kNoNode ? skeleton.axis[parent] : next;
  return node;
}

/// A trunk of three nodes. The second node bears two laterals, and the first lateral bears another one.
Skeleton small_tree() {
  Skeleton tree;
  const NodeIndex root = add(tree, kNoNode, true);
  const NodeIndex fork = add(tree, root, true);
  add(tree, fork, true);                             // 2: the trunk goes on
  const NodeIndex lateral = add(tree, fork, false);  // 3
  add(tree, fork, false);                            // 4
  add(tree, lateral, false);                         // 5
  return tree;
}

std::vector<NodeIndex> nodes_of(const MtgLayout& layout) {
  std::vector<NodeIndex> nodes;
  for (const MtgEntry& entry : layout.places()) nodes.push_back(entry.node);
  return nodes;
}

std::vector<int> columns_of(const MtgLayout& layout) {
  std::vector<int> columns;
  for (const MtgEntry& entry : layout.places()) columns.push_back(entry.column);
  return columns;
}

MtgLayout layout_of(const Skeleton& skeleton) {
  const Skeleton* const one = &skeleton;
  const Progress progress;
  return MtgLayout(std::span(&one, 1), progress);
}

TEST(MtgLayout, LateralsComeBeforeTheNodeThatContinuesTheirAxis) {
  const MtgLayout layout = layout_of(small_tree());
  EXPECT_THAT(nodes_of(layout), ElementsAre(0, 1, 3, 5, 4, 2));
  EXPECT_THAT(columns_of(layout), ElementsAre(0, 0, 1, 2, 1, 0));
  EXPECT_EQ(layout.column_count(), 3U);
  EXPECT_TRUE(layout.places()[5].is_successor);
  EXPECT_TRUE(layout.places()[5].stays);
  EXPECT_FALSE(layout.places()[2].is_successor);
}

TEST(MtgLayout, TheFirstOfTwoChildrenOnAnAxisContinuesIt) {
  Skeleton tree;
  const NodeIndex root = add(tree, kNoNode, true);
  add(tree, root, true);
  add(tree, root, true);
  EXPECT_THAT(find_successors(tree), ElementsAre(false, true, false));
}

TEST(MtgLayout, SkeletonsFollowOneAnother) {
  const Skeleton one = small_tree(), other = small_tree();
  const std::vector<const Skeleton*> both{&one, &other};
  const MtgLayout layout(both, Progress());
  ASSERT_EQ(layout.places().size(), 12U);
  EXPECT_EQ(layout.places()[6].node, 0U);
  EXPECT_EQ(layout.places()[6].column, 0);
}

/// A stem whose every node bears a lateral that does the same.
Skeleton stairs(NodeIndex steps) {
  Skeleton tree;
  NodeIndex bearer = add(tree, kNoNode, true);
  for (NodeIndex k = 0; k < steps; ++k) {
    add(tree, bearer, true);
    bearer = add(tree, bearer, false);
  }
  return tree;
}

TEST(MtgLayout, HighOrdersTakeFewColumns) {
  EXPECT_EQ(layout_of(stairs(63)).column_count(), 64U) << "a column for each order";
  for (const NodeIndex steps : {64U, 1000U}) {
    const MtgLayout layout = layout_of(stairs(steps));
    EXPECT_LE(layout.column_count(), 32U) << steps;
    const std::vector<NodeIndex> nodes = nodes_of(layout);
    EXPECT_EQ(std::set(nodes.begin(), nodes.end()).size(), 2 * steps + 1) << "each node once";
  }
}

TEST(MtgLayout, ParentsComeBeforeTheirChildren) {
  const Skeleton tree = stairs(100);
  std::set<NodeIndex> before;
  for (const NodeIndex node : nodes_of(layout_of(tree))) {
    EXPECT_TRUE(tree.is_root(node) || before.contains(tree.parent[node])) << node;
    before.insert(node);
  }
}

TEST(MtgLayout, StopsWhenCancelled) {
  const Skeleton tree = small_tree();
  const Skeleton* const one = &tree;
  Progress progress;
  progress.cancel();
  EXPECT_THROW(MtgLayout(std::span(&one, 1), progress), Cancelled);
}

}  // namespace meristem::mtg_layout_test
