// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/mtg_skeleton.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "tests/support/check_skeleton.h"

namespace meristem {
namespace {

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
  return skeleton_of(read_mtg(kHeader + codes, "plant.mtg"), "plant.mtg", geometry);
}

std::string fault(const std::string& codes, const MtgGeometry& geometry = {}) {
  try {
    read(codes, geometry);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

// A stem of two segments from a base, with a lateral of two.
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
  EXPECT_EQ(fault(kForked, {.position = {"XX", "YY", "Z"}}),
            "plant.mtg: there is no feature 'Z'; expected features with the coordinates (XX, YY, Z) and diameters of "
            "entities");
  EXPECT_NE(fault(kForked, {.diameter = "TopDai"}).find("did you mean 'TopDia'?"), std::string::npos);
  EXPECT_EQ(fault("/P1/A1\n^/S1\t\t0\t0\n"),
            "plant.mtg:14: S1 has no coordinates; expected XX, YY, ZZ of the first entity "
            "of a plant");
  EXPECT_EQ(fault("/P1/A1\n^/S1\t\t0\t0\t1e300\n"),
            "plant.mtg:14: S1 is too far away; expected coordinates within 1000000 m");
  EXPECT_EQ(fault("/P1/A1\n^/S1\t\t0\t0\t1\t-2\n"),
            "plant.mtg:14: S1 has a diameter of -2 m; expected one from 0 to 1000000 m");
  EXPECT_THROW(read(kForked, {.length_unit = 0}), std::invalid_argument);
}

TEST(MtgSkeleton, AFileWithoutEntitiesHasNoNodes) { EXPECT_EQ(read("").skeleton.node_count(), 0U); }

}  // namespace
}  // namespace meristem
