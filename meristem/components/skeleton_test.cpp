// SPDX-License-Identifier: Apache-2.0
// Plants from skeleton files as components: units, up axis, origin, radii, finishing, and children on them.
#include "meristem/components/skeleton.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace meristem::skeleton_test {

using testing::HasSubstr;

/// A trunk with one branch: x, y, z in centimetres, z up, not at the origin.
constexpr const char* kTable = "x,y,z,radius,parent\n100,0,0,10,-1\n100,0,100,8,0\n100,0,200,6,1\n200,0,100,3,1\n";

constexpr const char* kMtg =
    "CODE:\tFORM-A\nCLASSES:\nSYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n$\t0\tFREE\tFREE\tIMPLICIT\n"
    "P\t1\tFREE\tFREE\tIMPLICIT\nS\t2\tFREE\tFREE\tIMPLICIT\nDESCRIPTION:\nLEFT\tRIGHT\tRELTYPE\tMAX\nS\tS\t+\t?\n"
    "FEATURES:\nNAME\tTYPE\nXX\tREAL\nYY\tREAL\nZZ\tREAL\nTopDia\tREAL\nMTG:\nENTITY-CODE\tXX\tYY\tZZ\tTopDia\n"
    "/P1\t100\t0\t0\t\n^/S1\t100\t0\t100\t80\n^<S2\t100\t0\t200\t60\n";

class SkeletonComponent : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }

  static GraphBuilder builder(Value::Object parameters, const std::string& file) {
    parameters.emplace_back("file", file);
    GraphBuilder made(builtin_components());
    made.component("view", "camera").component("tree", "skeleton", parameters).link("view", "tree");
    return made;
  }

  static Skeleton only(const Plant& plant) {
    EXPECT_EQ(plant.stems.size(), 1U);
    return plant.stems.at(0).skeleton;
  }

  TemporaryFolder folder_;
};

TEST_F(SkeletonComponent, StandsAtItsOriginInMetres) {
  const std::string file = write("tree.csv", kTable);
  const Skeleton tree = only(builder({{"unit", 0.01}}, file).grow());
  EXPECT_TRUE(check_skeleton(tree));
  EXPECT_EQ(tree.position[0], Vec3(0));
  EXPECT_EQ(tree.position[2], Vec3(0, 2, 0));
  EXPECT_EQ(tree.position[3], Vec3(1, 1, 0));
  EXPECT_FLOAT_EQ(tree.radius[0], 0.1F);
  EXPECT_EQ(tree.axis[3], 1U);
  const Skeleton as_is = only(builder({{"unit", 0.01}, {"at_origin", false}, {"up", "y"}}, file).grow());
  EXPECT_EQ(as_is.position[2], Vec3(1, 0, 2));
}

TEST_F(SkeletonComponent, ItsFrameMovesTurnsAndScalesIt) {
  const std::string file = write("tree.csv", kTable);
  const Value::Object frame{{"translate", Value::List{5, 0, 0}}, {"scale", Value::List{2, 2, 2}}};
  const Skeleton tree = only(builder({{"unit", 0.01}, {"frame", frame}}, file).grow());
  EXPECT_EQ(tree.position[2], Vec3(5, 4, 0));
  EXPECT_FLOAT_EQ(tree.radius[0], 0.2F);
}

TEST_F(SkeletonComponent, MtgHasUnitsOfItsOwnForDiameters) {
  const std::string file = write("tree.mtg", kMtg);
  const Skeleton tree = only(builder({{"unit", 0.01}, {"diameter_unit", 0.001}}, file).grow());
  ASSERT_EQ(tree.node_count(), 3U);
  EXPECT_EQ(tree.position[2], Vec3(0, 2, 0));
  EXPECT_FLOAT_EQ(tree.radius[2], 0.03F);
}

TEST_F(SkeletonComponent, MissingRadiiComeFromThePipeModel) {
  const std::string file = write("bare.csv", "x,y,z,parent\n0,0,0,-1\n0,0,1,0\n1,0,2,1\n-1,0,2,1\n");
  const Skeleton tree = only(builder({{"tip_radius", 0.01}, {"pipe_exponent", 2}}, file).grow());
  EXPECT_FLOAT_EQ(tree.radius[2], 0.01F);
  EXPECT_FLOAT_EQ(tree.radius[0], static_cast<float>(0.01 * std::sqrt(2.0)));
}

TEST_F(SkeletonComponent, FinishingThinsAndRefines) {
  std::string many = "x,y,z,radius,parent\n0,0,0,0.1,-1\n";
  for (int k = 0; k < 40; ++k) many += "0,0," + std::to_string(0.1 * (k + 1)) + ",0.1," + std::to_string(k) + "\n";
  const std::string file = write("pole.csv", many);
  EXPECT_EQ(only(builder({}, file).grow()).node_count(), 41U);
  const auto finished = [&](const Value::Object& finish) {
    return only(builder({{"finish", finish}}, file).grow()).node_count();
  };
  EXPECT_LT(finished({{"decimate", 1}}), 8U);
  EXPECT_GT(finished({{"subdivide", 0.02}}), 180U);
}

TEST_F(SkeletonComponent, LeavesStandOnItsTwigs) {
  const std::string file = write("tree.csv", kTable);
  GraphBuilder tree = builder({{"unit", 0.01}}, file);
  tree.component("leaf", "leaf").link("tree", "leaf", LinkKind::branch, {{"density", 20}});
  const std::vector<Organ> leaves = organs_of(tree.grow(), "leaf");
  // Twigs are the last segments of both axes, 1 m each.
  EXPECT_NEAR(static_cast<double>(leaves.size()), 40, 2);
  for (const Organ& leaf : leaves) EXPECT_GT(leaf.frame.origin.y, 0.9F);
}

TEST_F(SkeletonComponent, FaultsNameTheFileAndTheLine) {
  const auto error_of = [&](const Value::Object& parameters, const std::string& file) {
    const std::vector<Diagnostic> errors = errors_of([&] { builder(parameters, file); });
    return errors.empty() ? "no fault" : errors[0].text();
  };
  EXPECT_THAT(error_of({}, write("a.csv", "x,y,z,radius,parent\n0,0,0,1,-1\n0,0,1,1,9\n")),
              HasSubstr("a.csv:3': there is no parent 9"));
  EXPECT_THAT(error_of({{"features", Value::Object{{"x", "XXX"}}}}, write("a.mtg", kMtg)),
              HasSubstr("there is no feature 'XXX'"));
  EXPECT_THAT(error_of({{"scale", 7}}, write("a.mtg", kMtg)), HasSubstr("there are no entities of scale 7"));
  EXPECT_THAT(error_of({}, (folder_ / "none.csv").string()), HasSubstr("none.csv"));
}

struct TreeFacts {
  std::size_t segments;
  unsigned laterals;
  int highest_order;
  double height;
};

TEST_F(SkeletonComponent, DigitisedTreesAreAsTheirReaderHasThem) {
  for (const auto& [file, facts] : data_sets<TreeFacts>({{"tests/data/trees/sapling.mtg", {874, 333, 4, 4.66}}},
                                                        {{"trees/noylum2.mtg", {6427, 1874, 7, 7.95}}})) {
    SCOPED_TRACE(file);
    const Skeleton tree = only(builder({{"unit", 0.01}, {"diameter_unit", 0.001}}, file).grow());
    EXPECT_EQ(tree.node_count(), facts.segments + 1) << "and the base of the trunk";
    EXPECT_EQ(*std::ranges::max_element(tree.order), facts.highest_order);
    EXPECT_EQ(*std::ranges::max_element(tree.axis), facts.laterals);
    EXPECT_NEAR(bounds(tree).high.y, facts.height, 0.02);
    EXPECT_EQ(tree.position[0], Vec3(0));
  }
}

}  // namespace meristem::skeleton_test
