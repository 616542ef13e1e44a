// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/mtg/mtg_skeleton.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "tests/support/check_skeleton.h"

namespace meristem::mtg_skeleton_test {

// The codes begin on line 13.
constexpr const char* kHeader =
    "CODE:\tFORM-A\n"
    "CLASSES:\n"
    "P 1 FREE\n"
    "A 2 FREE\n"
    "S 3 FREE\n"
    "FEATURES:\n"
    "XX REAL\n"
    "YY REAL\n"
    "ZZ REAL\n"
    "TopDia REAL\n"
    "MTG:\n"
    "TOPO\t\tXX\tYY\tZZ\tTopDia\n";

MtgSkeleton read(const std::string& codes, const MtgGeometry& geometry = {}) {
  return skeleton_of(read_mtg(kHeader + codes, "plant.mtg", {}), "plant.mtg", geometry, {});
}

std::string error(const std::string& codes, const MtgGeometry& geometry = {}) {
  try {
    read(codes, geometry);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

// A stem of two segments from a base, with a lateral of two segments.
constexpr const char* kForked =
    "/P1\n"
    "^/A1\t\t100\t200\t0\t20\n"
    "^/S1\t\t100\t200\t50\t16\n"
    "\t+A1\t101\t200\t51\n"
    "\t^/S1\t110\t200\t60\t6\n"
    "\t^<S2\t120\t200\t70\t4\n"
    "^<S2\t\t100\t200\t100\t8\n";

TEST(MtgSkeleton, EntitiesOfTheFinestScaleAreSegments) {
  const MtgSkeleton read_plant = read(kForked, {.length_unit = 0.01, .diameter_unit = 0.001});
  const Skeleton& skeleton = read_plant.skeleton;
  EXPECT_TRUE(check_skeleton(skeleton));
  EXPECT_EQ(skeleton.parent, (std::vector<NodeIndex>{kNoNode, 0, 1, 2, 1}));
  EXPECT_EQ(skeleton.axis, (std::vector<AxisIndex>{0, 0, 1, 1, 0}));
  EXPECT_EQ(skeleton.order, (std::vector<std::uint16_t>{0, 0, 1, 1, 0}));
  EXPECT_EQ(skeleton.radius, (std::vector<float>{0.010F, 0.008F, 0.003F, 0.002F, 0.004F}));
  EXPECT_EQ(read_plant.vertex, (std::vector<MtgVertex>{2, 3, 5, 6, 7}));
  EXPECT_EQ(read_plant.guessed, 0U);
  // North (YY) is -z, up (ZZ) is y.
  EXPECT_EQ(skeleton.position[0], Vec3(1, 0, -2));
  EXPECT_EQ(skeleton.position[4], Vec3(1, 1, -2));
}

TEST(MtgSkeleton, WithoutABaseTheFirstEntityIsTheRoot) {
  const MtgSkeleton plant = read("/P1/A1\n^/S1\t\t0\t0\t1\t2\n^<S2\t\t0\t0\t2\t1\n");
  EXPECT_EQ(plant.skeleton.parent, (std::vector<NodeIndex>{kNoNode, 0}));
  EXPECT_EQ(plant.skeleton.position[0], Vec3(0, 1, 0));
}

TEST(MtgSkeleton, WhatIsMissingIsTheParents) {
  const MtgSkeleton plant = read("/P1/A1\n^/S1\t\t0\t0\t1\t2\n^<S2\n^<S3\t\t0\t0\t3\n");
  EXPECT_EQ(plant.guessed, 1U);
  EXPECT_EQ(plant.skeleton.position[1], plant.skeleton.position[0]);
  EXPECT_EQ(plant.skeleton.radius, (std::vector<float>{1, 1, 1}));
}

TEST(MtgSkeleton, ASecondSuccessorBeginsALateral) {
  const MtgSkeleton plant = read("/P1/A1\n^/S1\t\t0\t0\t1\n\t<S2\t0\t0\t2\n\t<S3\t0\t1\t2\n");
  EXPECT_EQ(plant.skeleton.axis, (std::vector<AxisIndex>{0, 0, 1}));
  EXPECT_EQ(plant.skeleton.order, (std::vector<std::uint16_t>{0, 0, 1}));
}

TEST(MtgSkeleton, SeveralPlantsAreAForest) {
  const MtgSkeleton plants = read("/P1/A1/S1\t\t0\t0\t1\n/P2/A1/S1\t\t5\t0\t1\n^<S2\t\t5\t0\t2\n");
  EXPECT_EQ(plants.skeleton.parent, (std::vector<NodeIndex>{kNoNode, kNoNode, 1}));
  EXPECT_EQ(plants.skeleton.axis, (std::vector<AxisIndex>{0, 1, 1}));
}

TEST(MtgSkeleton, FaultsNameTheFeatureOrTheLine) {
  EXPECT_EQ(error(kForked, {.position = {"XX", "YY", "Z"}}),
            "plant.mtg: there is no feature 'Z'; expected features with the coordinates (XX, YY, Z) and diameters of "
            "entities");
  EXPECT_NE(error(kForked, {.diameter = "TopDai"}).find("did you mean 'TopDia'?"), std::string::npos);
  EXPECT_EQ(error("/P1/A1\n^/S1\t\t0\t0\n"),
            "plant.mtg:14: S1 has no coordinates; expected XX, YY, ZZ of the first entity "
            "of a plant");
  EXPECT_EQ(error("/P1/A1\n^/S1\t\t0\t0\t1e300\n"),
            "plant.mtg:14:11: '1e300', the ZZ of S1, is out of range; expected a number from -3.4e+38 to 3.4e+38");
  EXPECT_EQ(error("/P1/A1\n^/S1\t\t0\t0\t1e7\n"),
            "plant.mtg:14: S1 is too far away; expected coordinates within 1000000 m");
  EXPECT_EQ(error("/P1/A1\n^/S1\t\t0\t0\t1\t-2\n"),
            "plant.mtg:14: S1 has a diameter of -2 m; expected one from 0 to 2000 m");
  EXPECT_THROW(read(kForked, {.length_unit = 0}), std::invalid_argument);
}

/// Returns a file with these features in addition to the positions. The codes begin on line 11 or later.
std::string file_with(const std::vector<std::string>& features, const std::string& codes) {
  std::string text = "CODE:\tFORM-A\nCLASSES:\nP 1 FREE\nA 2 FREE\nS 3 FREE\nFEATURES:\nXX REAL\nYY REAL\nZZ REAL\n";
  std::string names = "TOPO\t\tXX\tYY\tZZ";
  for (const std::string& feature : features) {
    text += feature + '\n';
    names += '\t' + feature.substr(0, feature.find(' '));
  }
  return text + "MTG:\n" + names + '\n' + codes;
}

Skeleton read_with(const std::vector<std::string>& features, const std::string& codes, const SizeLimits& limits = {}) {
  return skeleton_of(read_mtg(file_with(features, codes), "plant.mtg", {}), "plant.mtg", {}, limits).skeleton;
}

/// A stem of three segments from a base, with a lateral of one segment.
std::string forked_with(const std::array<std::string, 5>& values) {
  return "/P1\n^/A1\t\t0\t0\t0\t" + values[0] + "\n^/S1\t\t0\t0\t1\t" + values[1] + "\n\t+A1/S1\t1\t0\t1\t" +
         values[2] + "\n^<S2\t\t0\t0\t2\t" + values[3] + "\n^<S3\t\t0\t0\t3\t" + values[4] + '\n';
}

TEST(MtgSkeleton, FeaturesThatAreNumbersAreColumns) {
  Skeleton skeleton = read_with({"light REAL", "leaves INT", "kind ALPHA", "empty REAL"},
                                forked_with({"0.1\t2\tx", "0.3", "", "\t7", "\t-1"}));
  ASSERT_EQ(skeleton.extra.size(), 3U) << "and the numbers of metamers";
  const std::vector<float>& light = skeleton.extra["light"];
  EXPECT_EQ(light[0], 0.1F) << "the base is the axis's";
  EXPECT_EQ(light[1], 0.3F);
  for (const std::size_t unknown : {2, 3, 4}) EXPECT_TRUE(std::isnan(light[unknown]));
  EXPECT_EQ(skeleton.extra["leaves"][3], 7);
  EXPECT_EQ(skeleton.extra["leaves"][4], -1);
}

TEST(MtgSkeleton, AgesAreTheParentsWhereTheyAreMissing) {
  const Skeleton skeleton = read_with({"birth REAL"}, forked_with({"", "2", "5.5", "", "4"}));
  EXPECT_EQ(skeleton.birth, (std::vector<float>{0, 2, 5.5F, 2, 4}));
  EXPECT_FALSE(skeleton.extra.contains("birth"));
}

TEST(MtgSkeleton, ColumnsOfOtherMeaningAreNotTaken) {
  const Skeleton skeleton = read_with({"axis INT", "radius REAL", "instance INT", "TopDia REAL"},
                                      forked_with({"1\t1\t1\t1", "", "", "", ""}));
  EXPECT_EQ(skeleton.extra.size(), 1U) << "the numbers of metamers";
  EXPECT_EQ(skeleton.axis, (std::vector<AxisIndex>{0, 0, 1, 0, 0})) << "axes are those of the codes";
}

TEST(MtgSkeleton, EntitiesThatCountTheirAxesNumberMetamers) {
  using Numbers = std::vector<float>;
  const auto numbers = [](const std::string& codes) {
    const Skeleton skeleton = read_with({"note ALPHA"}, codes);
    const auto column = skeleton.extra.find("metamer");
    return column == skeleton.extra.end() ? Numbers{} : column->second;
  };
  const std::string codes = forked_with({});
  EXPECT_EQ(numbers(codes), (Numbers{0, 1, 1, 2, 3}));
  for (const auto& [from, to] : {std::pair("^<S3", "^<S4"), {"+A1/S1", "+A1/S0"}, {"^<S2", "^<S"}, {"^<S3", "^<S2"}}) {
    std::string other = codes;
    other.replace(other.find(from), std::string(from).size(), to);
    EXPECT_EQ(numbers(other), Numbers{}) << to;
  }
  EXPECT_EQ(numbers("/P1/A1/S1\t\t0\t0\t1\n^<S2\t\t0\t0\t2\n"), (Numbers{1, 2})) << "a root that is a segment's end";
}

TEST(MtgSkeleton, AFeatureMetamerGoesBeforeTheNumbersOfEntities) {
  Skeleton skeleton = read_with({"metamer INT"}, forked_with({"0", "4", "1", "5", "6"}));
  EXPECT_EQ(skeleton.extra["metamer"], (std::vector<float>{0, 4, 1, 5, 6}));
}

TEST(MtgSkeleton, NodesHaveTheOrderInWhichTheyAreNumbered) {
  const Skeleton plain = read_with({"node INT"}, forked_with({}));
  const Skeleton numbered =
      read_with({"node INT", "light REAL"}, forked_with({"0\t5", "10\t6", "40\t7", "20\t8", "30\t9"}));
  EXPECT_EQ(numbered.parent, (std::vector<NodeIndex>{kNoNode, 0, 1, 2, 1}));
  EXPECT_EQ(numbered.position[4], plain.position[2]);
  EXPECT_EQ(numbered.axis, (std::vector<AxisIndex>{0, 0, 0, 0, 1}));
  EXPECT_EQ(numbered.order, (std::vector<std::uint16_t>{0, 0, 0, 0, 1}));
  EXPECT_EQ(numbered.extra.find("light")->second, (std::vector<float>{5, 6, 8, 9, 7}));
  EXPECT_FALSE(numbered.extra.contains("node"));
  EXPECT_FALSE(numbered.extra.contains("metamer")) << "what numbers its nodes says all it knows";
  // A child before its parent, duplicates, a missing number, a fraction.
  for (const std::array<std::string, 5>& wrong : {std::array<std::string, 5>{"0", "4", "3", "2", "1"},
                                                  {"0", "1", "2", "2", "3"},
                                                  {"0", "1", "", "2", "3"},
                                                  {"0", "1", "2", "2.5", "3"}}) {
    EXPECT_EQ(read_with({"node REAL"}, forked_with(wrong)).parent, plain.parent);
  }
}

TEST(MtgSkeleton, NumberedNodesMayHaveAxesAndOrdersOfTheirOwn) {
  const std::vector<std::string> features{"node INT", "axis INT", "order INT"};
  Skeleton skeleton = read_with(features, forked_with({"0\t0\t0", "1\t0\t0", "2\t0\t3", "3\t1\t2", "4\t1\t2"}));
  EXPECT_EQ(skeleton.axis, (std::vector<AxisIndex>{0, 0, 0, 1, 1}));
  EXPECT_EQ(skeleton.order, (std::vector<std::uint16_t>{0, 0, 3, 2, 2}));
  skeleton = read_with(features, forked_with({"0\t0\t0", "1\t0\t0", "2\t2\t3", "3\t1\t2", "4\t1\t2"}));
  EXPECT_EQ(skeleton.axis, (std::vector<AxisIndex>{0, 0, 1, 0, 0})) << "axis 2 would come before axis 1";
}

TEST(MtgSkeleton, MoreNumbersThanTheLimitAllowsAreRefused) {
  std::vector<std::string> features;
  std::string values;
  for (int k = 0; k < 17; ++k) {
    features.push_back("f" + std::to_string(k) + "x REAL");
    values += "1\t";
  }
  SizeLimits limits;
  limits.nodes = 5;
  try {
    read_with(features, forked_with({values, "", "", "", ""}), limits);
    ADD_FAILURE() << "85 numbers are read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].message, "85 numbers of nodes are too many");
    EXPECT_EQ(error.diagnostics()[0].file, "plant.mtg");
  }
  limits.nodes = 6;
  EXPECT_EQ(read_with(features, forked_with({values, "", "", "", ""}), limits).extra.size(), 18U);
}

TEST(MtgSkeleton, MetresAreRoundedToFloatsOnce) {
  // The text is nearer to the upper float, by less than the precision of a double.
  const std::string tie = "1.00000005960464477540";
  const Skeleton skeleton = read_with({"light REAL"}, "/P1/A1/S1\t\t" + tie + "\t0\t1\t" + tie + "\n");
  EXPECT_EQ(skeleton.position[0].x, std::nextafter(1.0F, 2.0F));
  EXPECT_EQ(skeleton.extra.find("light")->second[0], std::nextafter(1.0F, 2.0F));
}

TEST(MtgSkeleton, AFileWithoutEntitiesHasNoNodes) { EXPECT_EQ(read("").skeleton.node_count(), 0U); }

}  // namespace meristem::mtg_skeleton_test
