// SPDX-License-Identifier: Apache-2.0
// A digitised walnut (the data of OpenAlea's MTG package; coordinates in cm, diameters in mm) and its published
// figures. Readers can interpret the data differently:
// - Height: the trunk's base has the coordinates of the axis, 1.49 m below the end of the first segment. We begin at
//   the base, so the tree is 7.95 m high. From the end of the first segment, which is the first fork, the height is
//   6.47 m.
// - Forks from 2 cm: five forks are exactly 2 cm thick and count here. Without them the ratios are 0.80 to 1.35.
// - Angles: laterals do not count if either segment has no length, so 1711 of 1874 laterals count.
// - Line 2727 has no values: that segment stands at its parent's node.
#include <gtest/gtest.h>

#include "meristem/base/read_file.h"
#include "meristem/measure/measures.h"
#include "meristem/plant/mtg/mtg_skeleton.h"
#include "tests/support/shared_data.h"

namespace meristem::mtg_walnut_test {

class Walnut : public testing::Test {
 protected:
  void SetUp() override {
    const auto path = find_shared_data("trees/noylum2.mtg");
    if (!path) GTEST_SKIP() << kNoSharedData;
    tree_ = read_mtg(read_file(*path, Limits{}.file_bytes), *path, {});
    read_ = skeleton_of(tree_, *path, {.length_unit = 0.01, .diameter_unit = 0.001}, {});
    Progress progress;
    const Skeleton* const skeleton = &read_.skeleton;
    measures_ = measure_skeletons(std::span(&skeleton, 1), nullptr, {}, progress).whole;
  }

  MtgTree tree_;
  MtgSkeleton read_;
  Measures measures_;
};

TEST_F(Walnut, HasItsSegmentsAndAxes) {
  EXPECT_EQ(measures_.metamers, 6427U);
  EXPECT_EQ(measures_.nodes, 6428U) << "and the base of the trunk";
  EXPECT_EQ(measures_.axes, 1U + 1874U);
  EXPECT_EQ(measures_.axes_by_order.size(), 8U) << "orders 0 to 7";
  EXPECT_EQ(measures_.trees, 1U);
  EXPECT_EQ(read_.guessed, 1U);
}

TEST_F(Walnut, HasItsHeight) {
  EXPECT_NEAR(measures_.height, 7.95, 0.005);
  EXPECT_NEAR(measures_.crown_height, 6.47, 0.005);
}

TEST_F(Walnut, HasItsStreamsAndBifurcationRatios) {
  EXPECT_EQ(measures_.strahler_streams, (std::vector<std::uint64_t>{1868, 596, 182, 50, 16, 6, 1}));
  ASSERT_EQ(measures_.bifurcation_ratios.size(), 6U);
  for (int k = 0; k < 5; ++k) {
    EXPECT_GT(measures_.bifurcation_ratios[k], 2.65);
    EXPECT_LT(measures_.bifurcation_ratios[k], 3.65);
  }
  EXPECT_NEAR(*measures_.bifurcation_ratio, 3.5, 0.05);
}

TEST_F(Walnut, HasItsAreaRatios) {
  EXPECT_EQ(measures_.area_ratio.count, 454U);
  EXPECT_NEAR(measures_.area_ratio.low, 0.81, 0.005);
  EXPECT_NEAR(measures_.area_ratio.median, 1.05, 0.005);
  EXPECT_NEAR(measures_.area_ratio.high, 1.36, 0.005);
}

TEST_F(Walnut, HasItsBranchingAngles) {
  EXPECT_EQ(measures_.branching_angle.count, 1711U);
  EXPECT_NEAR(degrees(measures_.branching_angle.low), 18, 0.5);
  EXPECT_NEAR(degrees(measures_.branching_angle.median), 53, 0.5);
  EXPECT_NEAR(degrees(measures_.branching_angle.high), 110, 0.5);
}

TEST_F(Walnut, HasAPipeExponentWithinTheBandOfTrees) {
  EXPECT_GT(measures_.pipe_exponent.median, 1.8);
  EXPECT_LT(measures_.pipe_exponent.median, 3);
  EXPECT_EQ(measures_.pipe_exponent.count + measures_.pipe_unsolved, measures_.forks);
}

}  // namespace meristem::mtg_walnut_test
