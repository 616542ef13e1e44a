// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/further_columns.h"

#include <gtest/gtest.h>

namespace meristem {
namespace {

TEST(FurtherColumns, QuantitiesGoEvenlyFromNodeToNode) {
  const Skeleton skeleton;
  EXPECT_EQ(inner_value(skeleton, "light", 1, 3, 0.25F), 1.5F);
  EXPECT_EQ(inner_value(skeleton, "light", 3, 1, 1), 1);
}

TEST(FurtherColumns, MarksOfNodesAreNotOneOfThoseBetweenThem) {
  const Skeleton skeleton;
  EXPECT_EQ(inner_value(skeleton, "end", 1, 1, 0.5F), 0);
  EXPECT_EQ(inner_value(skeleton, "shed", 4, 2, 0.5F), 0);
}

TEST(FurtherColumns, ASegmentIsPartOfTheMetamerThatItEndsWith) {
  Skeleton skeleton;
  skeleton.extra["metamer"];
  EXPECT_EQ(inner_value(skeleton, "metamer", 4, 5, 0.1F), 5);
  EXPECT_EQ(inner_value(skeleton, "lateral_bud", 0, 3, 0.1F), 3);
  EXPECT_EQ(inner_value(skeleton, "shed", 4, 2, 0.1F), 0);
}

}  // namespace
}  // namespace meristem
