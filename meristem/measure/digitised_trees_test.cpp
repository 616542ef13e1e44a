// SPDX-License-Identifier: Apache-2.0
// Digitised trees (coordinates in cm, diameters in mm) and their known figures. A synthetic tree comes with the
// project. `tests/data/make_tree.py --facts` prints its figures. A walnut, the data of OpenAlea's MTG package, has
// published figures. Readers can interpret the walnut differently:
// - Height: the trunk's base has the coordinates of the axis, 1.49 m below the end of the first segment. We begin at
//   the base, so the tree is 7.95 m high. From the end of the first segment, which is the first fork, the height is
//   6.47 m.
// - Forks from 2 cm: five forks are exactly 2 cm thick and count here. Without them the ratios are 0.80 to 1.35.
// - Angles: laterals do not count if either segment has no length, so 1711 of 1874 laterals count.
// - Line 2727 has no values: that segment stands at its parent's node. The synthetic tree has such a segment as well.
#include <gtest/gtest.h>

#include "meristem/base/read_file.h"
#include "meristem/measure/measures.h"
#include "meristem/plant/mtg/mtg_skeleton.h"
#include "tests/support/test_data.h"

namespace meristem::digitised_trees_test {

/// The number of values, and their 5th, 50th and 95th percentiles.
struct Spread {
  std::uint64_t count;
  double low, median, high;
};

struct TreeFacts {
  std::uint64_t segments, laterals;
  std::size_t orders;
  double height, crown_height;  ///< metres
  std::vector<std::uint64_t> streams;
  double lowest_ratio, highest_ratio;  ///< of the bifurcation ratios below the top
  double mean_ratio;
  double mean_tolerance;
  Spread area_ratios;
  double area_tolerance;
  Spread angles;  ///< degrees
  double angle_tolerance;
  std::uint64_t unsolved;  ///< forks without a pipe exponent
};

const std::vector<DataSet<TreeFacts>>& trees() {
  static const auto kTrees = data_sets<TreeFacts>({{"tests/data/trees/sapling.mtg",
                                                    {.segments = 874,
                                                     .laterals = 333,
                                                     .orders = 5,
                                                     .height = 4.6587,
                                                     .crown_height = 3.1285,
                                                     .streams = {334, 103, 28, 5, 1},
                                                     .lowest_ratio = 3.24,
                                                     .highest_ratio = 5.61,
                                                     .mean_ratio = 4.275,
                                                     .mean_tolerance = 1e-3,
                                                     .area_ratios = {26, 0.9427, 1.0051, 1.0676},
                                                     .area_tolerance = 2e-4,
                                                     .angles = {333, 34.7530, 53.3333, 73.3029},
                                                     .angle_tolerance = 2e-3,
                                                     .unsolved = 1}}},
                                                  {{"trees/noylum2.mtg",
                                                    {.segments = 6427,
                                                     .laterals = 1874,
                                                     .orders = 8,
                                                     .height = 7.95,
                                                     .crown_height = 6.47,
                                                     .streams = {1868, 596, 182, 50, 16, 6, 1},
                                                     .lowest_ratio = 2.65,
                                                     .highest_ratio = 3.65,
                                                     .mean_ratio = 3.5,
                                                     .mean_tolerance = 0.05,
                                                     .area_ratios = {454, 0.81, 1.05, 1.36},
                                                     .area_tolerance = 0.005,
                                                     .angles = {1711, 18, 53, 110},
                                                     .angle_tolerance = 0.5,
                                                     .unsolved = 599}}});
  return kTrees;
}

struct Measured {
  MtgSkeleton read;
  Measures measures;
};

Measured measured(const std::string& file) {
  const MtgTree tree = read_mtg(read_file(file, SizeLimits{}.file_bytes), file, {});
  Measured result{.read = skeleton_of(tree, file, {.length_unit = 0.01, .diameter_unit = 0.001}, {}), .measures = {}};
  Progress progress;
  const Skeleton* const skeleton = &result.read.skeleton;
  result.measures = measure_skeletons(std::span(&skeleton, 1), nullptr, {}, progress).whole;
  return result;
}

void expect_spread(const SampleStatistics& found, const Spread& known, double unit, double tolerance) {
  EXPECT_EQ(found.count, known.count);
  EXPECT_NEAR(found.low * unit, known.low, tolerance);
  EXPECT_NEAR(found.median * unit, known.median, tolerance);
  EXPECT_NEAR(found.high * unit, known.high, tolerance);
}

TEST(DigitisedTrees, HaveTheirSegmentsAndAxes) {
  for (const auto& [file, known] : trees()) {
    SCOPED_TRACE(file);
    const auto [read, measures] = measured(file);
    EXPECT_EQ(measures.metamers, known.segments);
    EXPECT_EQ(measures.nodes, known.segments + 1) << "and the base of the trunk";
    EXPECT_EQ(measures.axes, 1 + known.laterals);
    EXPECT_EQ(measures.axes_by_order.size(), known.orders);
    EXPECT_EQ(measures.trees, 1U);
    EXPECT_EQ(read.guessed, 1U);
  }
}

TEST(DigitisedTrees, HaveTheirHeights) {
  for (const auto& [file, known] : trees()) {
    SCOPED_TRACE(file);
    const Measures measures = measured(file).measures;
    EXPECT_NEAR(measures.height, known.height, 0.005);
    EXPECT_NEAR(measures.crown_height, known.crown_height, 0.005);
  }
}

TEST(DigitisedTrees, HaveTheirStreamsAndBifurcationRatios) {
  for (const auto& [file, known] : trees()) {
    SCOPED_TRACE(file);
    const Measures measures = measured(file).measures;
    EXPECT_EQ(measures.strahler_streams, known.streams);
    ASSERT_EQ(measures.bifurcation_ratios.size(), known.streams.size() - 1);
    for (std::size_t k = 0; k + 1 < measures.bifurcation_ratios.size(); ++k) {
      EXPECT_GT(measures.bifurcation_ratios[k], known.lowest_ratio);
      EXPECT_LT(measures.bifurcation_ratios[k], known.highest_ratio);
    }
    EXPECT_NEAR(*measures.bifurcation_ratio, known.mean_ratio, known.mean_tolerance);
  }
}

TEST(DigitisedTrees, HaveTheirAreaRatios) {
  for (const auto& [file, known] : trees()) {
    SCOPED_TRACE(file);
    expect_spread(measured(file).measures.area_ratio, known.area_ratios, 1, known.area_tolerance);
  }
}

TEST(DigitisedTrees, HaveTheirBranchingAngles) {
  for (const auto& [file, known] : trees()) {
    SCOPED_TRACE(file);
    expect_spread(measured(file).measures.branching_angle, known.angles, degrees(1), known.angle_tolerance);
  }
}

TEST(DigitisedTrees, HaveAPipeExponentWithinTheBandOfTrees) {
  for (const auto& [file, known] : trees()) {
    SCOPED_TRACE(file);
    const Measures measures = measured(file).measures;
    EXPECT_GT(measures.pipe_exponent.median, 1.8);
    EXPECT_LT(measures.pipe_exponent.median, 3);
    EXPECT_EQ(measures.pipe_exponent.count + measures.pipe_unsolved, measures.forks);
    EXPECT_EQ(measures.pipe_unsolved, known.unsolved);
  }
}

}  // namespace meristem::digitised_trees_test
