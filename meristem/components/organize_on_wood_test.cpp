// SPDX-License-Identifier: Apache-2.0
// Self-organizing trees that continue from the wood of a file.
#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "meristem/components/organize_in_a_test.h"
#include "meristem/components/parts/organize_table.h"
#include "meristem/graph/batch.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/temporary_folder.h"

namespace meristem::organize_on_wood_test {

using namespace organize_test;

class OrganizeOnWood : public testing::Test {
 protected:
  /// Returns the parameters of a tree that continues from a table.
  Value::Object on(const std::string& table, Value::Object more = {}, Value::Object source = {}) const {
    std::ofstream(folder_ / "wood.csv") << table;
    source.emplace_back("file", (folder_ / "wood.csv").string());
    more.emplace_back("skeleton", std::move(source));
    return more;
  }

  TemporaryFolder folder_;
};

// A trunk of 3 m with a branch, in centimetres, z up, away from the origin.
const std::string kWood =
    "x,y,z,radius,parent\n100,0,0,10,-1\n100,0,100,8,0\n100,0,200,6,1\n100,0,300,4,2\n200,0,150,3,1\n";

TEST_F(OrganizeOnWood, GoesOnFromATable) {
  const Skeleton tree = skeleton_of(on(kWood, {{"iterations", 4}, {"length", 0.2}}, {{"unit", 0.01}}));
  EXPECT_TRUE(check_skeleton(tree));
  EXPECT_EQ(tree.position[0], Vec3(0));
  EXPECT_GE(tree.radius[0], 0.1F);
  EXPECT_GT(bounds(tree).high.y, 3) << "its top has grown";
  EXPECT_TRUE(std::ranges::find(tree.position, Vec3(0, 3, 0)) != tree.position.end()) << "and is where it was";
  EXPECT_GT(*std::ranges::max_element(tree.birth), 3);
}

TEST_F(OrganizeOnWood, StandsAtEachRootAndInFrames) {
  Value::Object parameters = on(kWood, {{"iterations", 0}, {"length", 0.2}}, {{"unit", 0.01}});
  parameters.emplace_back("roots", Value::List{Value::List{0, 0, 0}, Value::List{9, 0, 0}});
  parameters.emplace_back("frame", Value::Object{{"scale", Value::List{2, 2, 2}}, {"translate", Value::List{0, 0, 5}}});
  const Skeleton trees = skeleton_of(parameters);
  EXPECT_TRUE(std::ranges::find(trees.position, Vec3(0, 6, 5)) != trees.position.end());
  EXPECT_TRUE(std::ranges::find(trees.position, Vec3(18, 6, 5)) != trees.position.end());
  EXPECT_FLOAT_EQ(trees.radius[0], 0.2F);
}

TEST_F(OrganizeOnWood, AFileMayHaveSeveralTrees) {
  const std::string two = "x,y,z,radius,parent\n0,0,0,10,-1\n0,0,100,8,0\n500,0,0,10,-1\n500,0,100,8,2\n";
  const Skeleton trees = skeleton_of(on(two, {{"iterations", 3}}, {{"unit", 0.01}}));
  EXPECT_EQ(std::ranges::count(trees.parent, kNoNode), 2);
  Value::Object third{{"do", "cut"}, {"at", 2}, {"shoots", "leader"}, {"above", 2}, {"tree", 2}};
  const Diagnostic found =
      error(on(two, {{"iterations", 3}, {"operations", Value::List{Value(third)}}}, {{"unit", 0.01}}));
  EXPECT_EQ(found.path, "components.tree.operations[0].tree");
  EXPECT_EQ(found.expected, "a number of the trees at 'roots', from 0 to 1");
}

TEST_F(OrganizeOnWood, RejectsFilesWithTheirLine) {
  const Diagnostic found = error(on("x,y,z,radius,parent\n0,0,0,1,-1\n0,0,1,1,9\n"));
  EXPECT_EQ(found.path, "components.tree.skeleton.file");
  EXPECT_NE(found.message.find("wood.csv:3"), std::string::npos) << found.message;
}

TEST_F(OrganizeOnWood, CountsWhatStandsBeforeItIsMade) {
  const std::string tall = "x,y,z,radius,parent\n0,0,0,1,-1\n0,0,100000,1,0\n";
  const auto errors = errors_of([&] { tree(on(tall, {{"length", 0.001}})).node_limit(20'000).grow(); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "components.tree.length");
}

}  // namespace meristem::organize_on_wood_test
