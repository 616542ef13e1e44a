// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/skeleton/operation_csv.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/read_file.h"

namespace meristem::operation_csv_test {

Plant pruned() {
  Plant plant;
  Stem& stem = plant.stems.emplace_back();
  stem.skeleton.add_node(kNoNode, Vec3(0), 0);
  stem.skeleton.operations.add({.operation = "components.apple.operations[3]",
                                .act = "cut",
                                .iteration = 8,
                                .tree = 2,
                                .shoot = "main.4",
                                .rank = 1,
                                .metamer = 3,
                                .position = {1, 2.5F, 0},
                                .bud = {0, -1, 0},
                                .bud_position = {1, 2.25F, 0},
                                .diameter = 0.125,
                                .metamers = 12,
                                .length = 0.5,
                                .wood = 0.25,
                                .light = 7});
  return plant;
}

TEST(OperationCsv, HasARowForEachThingDone) {
  const std::string path = testing::TempDir() + "pruned.operations.csv";
  Progress progress;
  write_operation_csv(pruned(), {}, path, progress);
  EXPECT_EQ(read_file(path, 1000),
            "operation,act,iteration,tree,shoot,rank,metamer,x,y,z,bud_x,bud_y,bud_z,bud_position_x,bud_position_y,"
            "bud_position_z,diameter,metamers,length,wood,light\n"
            "components.apple.operations[3],cut,8,2,main.4,1,3,1,2.5,0,0,-1,0,1,2.25,0,0.125,12,0.5,0.25,7\n");
}

TEST(OperationCsv, OfAPlantThatNobodyPrunedHasItsHeadAlone) {
  const std::string path = testing::TempDir() + "wild.operations.csv";
  Progress progress;
  write_operation_csv({}, {}, path, progress);
  EXPECT_EQ(read_file(path, 1000).find('\n') + 1, read_file(path, 1000).size());
}

TEST(OperationCsv, RefusesAPathThatCannotBeWritten) {
  Progress progress;
  EXPECT_THROW(write_operation_csv(pruned(), {}, "/no/such/folder/x.operations.csv", progress), MachineError);
}

}  // namespace meristem::operation_csv_test
