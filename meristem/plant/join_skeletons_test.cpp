// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/join_skeletons.h"

#include <utility>

#include <gtest/gtest.h>

namespace meristem::join_skeletons_test {

/// A stem of `nodes` nodes with a branch at its foot.
Skeleton tree(int nodes, float at, const char* column) {
  Skeleton made;
  for (int k = 0; k < nodes; ++k) {
    made.add_node(k == 0 ? kNoNode : static_cast<NodeIndex>(k - 1), {at, static_cast<float>(k), 0}, 1);
  }
  const NodeIndex tip = made.add_node(0, {at + 1, 0, 0}, 2);
  made.axis[tip] = 1;
  made.order[tip] = 1;
  if (column != nullptr) made.extra[column].assign(made.node_count(), at);
  return made;
}

Skeleton appended(const std::vector<Skeleton>& trees) {
  Skeleton all;
  for (const Skeleton& each : trees) all.append(each);
  return all;
}

TEST(JoinSkeletons, IsTheSameAsOneAppendedAfterAnother) {
  const std::vector<Skeleton> trees{tree(3, 0, "light"), tree(1, 5, "shed"), Skeleton(), tree(7, 9, nullptr),
                                    tree(2, 11, "light")};
  EXPECT_EQ(skeleton_hash(join_skeletons(trees)), skeleton_hash(appended(trees)));
  EXPECT_EQ(join_skeletons(trees).extra.size(), 2U);
}

TEST(JoinSkeletons, OneTreeStaysAsItIs) {
  EXPECT_EQ(skeleton_hash(join_skeletons({tree(4, 2, "light")})), skeleton_hash(tree(4, 2, "light")));
}

TEST(JoinSkeletons, OfNoneIsNone) {
  EXPECT_EQ(join_skeletons({}).node_count(), 0U);
  EXPECT_EQ(join_skeletons({Skeleton(), Skeleton()}).node_count(), 0U);
}

}  // namespace meristem::join_skeletons_test
