// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/operation_record.h"

#include <gtest/gtest.h>

#include "meristem/base/frame.h"

namespace meristem::operation_record_test {

/// A quarter turn about y, twice as large, and a shift.
const Frame kFrame{.axes = Mat3(Vec3(0, 0, -2), Vec3(0, 2, 0), Vec3(2, 0, 0)), .origin = {10, 0, 0}};

TEST(OperationRecord, PositionsLengthsAndVolumesMoveWithTheFrame) {
  OperationRecord record{.position = {1, 2, 3},
                         .bud = {1, 0, 0},
                         .bud_position = {0, 1, 0},
                         .diameter = 0.1,
                         .metamers = 7,
                         .length = 3,
                         .wood = 0.5,
                         .light = 4};
  move_record(record, kFrame, 2);
  EXPECT_EQ(record.position, Vec3(16, 4, -2));
  EXPECT_EQ(record.bud_position, Vec3(10, 2, 0));
  EXPECT_EQ(record.bud, Vec3(0, 0, -1)) << "a direction stays a unit vector";
  EXPECT_DOUBLE_EQ(record.diameter, 0.2);
  EXPECT_DOUBLE_EQ(record.length, 6);
  EXPECT_DOUBLE_EQ(record.wood, 4);
  EXPECT_EQ(record.metamers, 7U);
  EXPECT_EQ(record.light, 4);
}

TEST(OperationRecord, WhereThereIsNoBudNoneAppears) {
  OperationRecord record{.position = {1, 0, 0}, .bud_position = {1, 0, 0}};
  move_record(record, kFrame, 2);
  EXPECT_EQ(record.bud, Vec3(0));
}

}  // namespace meristem::operation_record_test
