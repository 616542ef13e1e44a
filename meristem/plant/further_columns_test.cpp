// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/further_columns.h"

#include <gtest/gtest.h>

namespace meristem::further_columns_test {

/// Three nodes in a row.
Skeleton row_of_nodes() {
  Skeleton skeleton;
  for (NodeIndex node = 0; node < 3; ++node) {
    skeleton.add_node(node == 0 ? kNoNode : node - 1, {0, static_cast<float>(node), 0}, 0);
  }
  skeleton.extra["light"] = {1, 3, 2};
  skeleton.extra["end"] = {0, 1, 1};
  skeleton.extra["shed"] = {0, 4, 2};
  return skeleton;
}

TEST(FurtherColumns, QuantitiesGoEvenlyFromNodeToNode) {
  const Skeleton skeleton = row_of_nodes();
  EXPECT_EQ(inner_value(skeleton, "light", 0, 1, 0.25F), 1.5F);
  EXPECT_EQ(inner_value(skeleton, "light", 1, 2, 1), 2);
}

TEST(FurtherColumns, MarksOfNodesAreNotOneOfThoseBetweenThem) {
  const Skeleton skeleton = row_of_nodes();
  EXPECT_EQ(inner_value(skeleton, "end", 1, 2, 0.5F), 0);
  EXPECT_EQ(inner_value(skeleton, "shed", 1, 2, 0.5F), 0);
}

TEST(FurtherColumns, ASegmentIsPartOfTheMetamerThatItEndsWith) {
  Skeleton skeleton = row_of_nodes();
  skeleton.extra["metamer"] = {0, 0, 5};
  EXPECT_EQ(inner_value(skeleton, "metamer", 1, 2, 0.1F), 5);
  EXPECT_EQ(inner_value(skeleton, "light", 1, 2, 0.1F), 2);
  EXPECT_EQ(inner_value(skeleton, "shed", 1, 2, 0.1F), 0);
  // The previous segment has no metamer number, so its values are interpolated.
  EXPECT_EQ(inner_value(skeleton, "light", 0, 1, 0.5F), 2);
}

}  // namespace meristem::further_columns_test
