// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/child_positions.h"

#include <gtest/gtest.h>

namespace meristem::child_positions_test {

// A root, its child 1, and two children of node 1: 2 and 3.
class ChildPositionsTest : public testing::Test {
 protected:
  ChildPositionsTest() {
    add(kNoNode, {0, 0, 0});
    add(0, {0, 1, 0});
    add(1, {0, 2, 0});
    add(1, {1, 1, 0});
  }
  void add(NodeIndex parent, Vec3 position) {
    skeleton_.add_node(parent, position, 0);
    places_.add_node(parent);
  }

  Skeleton skeleton_;
  ChildPositions places_{1};
};

TEST_F(ChildPositionsTest, RefuseTheNodesOwnChildren) {
  EXPECT_FALSE(places_.is_free(skeleton_, 1, {0, 2, 0}));
  EXPECT_FALSE(places_.is_free(skeleton_, 1, {1, 1.009F, 0}));
  EXPECT_TRUE(places_.is_free(skeleton_, 1, {1, 1.011F, 0}));
}

TEST_F(ChildPositionsTest, RefuseTheNodeAndItsParent) {
  EXPECT_FALSE(places_.is_free(skeleton_, 1, {0, 1, 0}));
  EXPECT_FALSE(places_.is_free(skeleton_, 1, {0, 0.005F, 0}));
  EXPECT_FALSE(places_.is_free(skeleton_, 0, {0, 1, 0}));
}

TEST_F(ChildPositionsTest, AllowWhatOthersHold) { EXPECT_TRUE(places_.is_free(skeleton_, 2, {1, 1, 0})); }

}  // namespace meristem::child_positions_test
