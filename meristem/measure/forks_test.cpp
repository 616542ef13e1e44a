// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/forks.h"

#include <cmath>

#include <gtest/gtest.h>

#include "meristem/plant/pipe_radii.h"

namespace meristem::forks_test {

/// A stem with laterals at the given angles (degrees) from the vertical, one above the other; radii 0.
Skeleton with_laterals(const std::vector<double>& angles) {
  Skeleton skeleton;
  NodeIndex last = skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  AxisIndex axis = 0;
  for (const double angle : angles) {
    last = skeleton.add_node(last, skeleton.position[last] + Vec3(0, 1, 0), 0);
    const Vec3 away(std::sin(radians(angle)), std::cos(radians(angle)), 0);
    const NodeIndex lateral = skeleton.add_node(last, skeleton.position[last] + 0.5F * away, 0);
    skeleton.axis[lateral] = ++axis;
    skeleton.order[lateral] = 1;
  }
  skeleton.add_node(last, skeleton.position[last] + Vec3(0, 1, 0), 0);
  return skeleton;
}

ForkSamples sample(const Skeleton& skeleton, double fork_diameter = 0) {
  return sample_forks(skeleton, NodeChildren(skeleton), fork_diameter);
}

TEST(Forks, BranchingAnglesAreThoseBuilt) {
  const std::vector<double> angles{0, 20, 45, 90, 135, 180};
  const ForkSamples samples = sample(with_laterals(angles));
  ASSERT_EQ(samples.branching_angles.size(), angles.size());
  for (std::size_t k = 0; k < angles.size(); ++k) {
    EXPECT_NEAR(degrees(samples.branching_angles[k]), angles[k], 1e-4);
  }
}

TEST(Forks, SegmentsWithoutLengthAndLateralsOnTheRootHaveNoAngle) {
  Skeleton skeleton = with_laterals({30, 60});
  skeleton.position[2] = skeleton.position[1];
  skeleton.axis[skeleton.add_node(0, {1, 0, 0}, 0)] = 3;
  const ForkSamples samples = sample(skeleton);
  ASSERT_EQ(samples.branching_angles.size(), 1U);
  EXPECT_NEAR(degrees(samples.branching_angles[0]), 60, 1e-4);
}

TEST(Forks, PipeExponentIsTheOneThatRadiiWereMadeWith) {
  for (const double exponent : {1.5, 2.0, 2.4, 3.0, 3.5}) {
    Skeleton skeleton = with_laterals({10, 20, 30, 40, 50});
    assign_pipe_radii(skeleton, {.tip_radius = 0.004, .exponent = exponent});
    const ForkSamples samples = sample(skeleton);
    ASSERT_EQ(samples.pipe_exponents.size(), 5U);
    // Radii are stored in 32 bits.
    for (const double found : samples.pipe_exponents) EXPECT_NEAR(found, exponent, 1e-5);
    EXPECT_EQ(samples.pipe_unsolved, 0U);
  }
}

TEST(Forks, TwoEqualChildrenHaveAClosedForm) {
  for (const double ratio : {0.5, 0.7, 0.9}) {
    EXPECT_NEAR(*pipe_exponent(1, std::vector<double>{ratio, ratio}), std::log(0.5) / std::log(ratio), 1e-10);
  }
  EXPECT_NEAR(*pipe_exponent(5, std::vector<double>{3, 4}), 2, 1e-10);
}

TEST(Forks, NoExponentFitsAChildAsThickAsItsParent) {
  EXPECT_FALSE(pipe_exponent(1, std::vector<double>{1, 0.5}));
  EXPECT_FALSE(pipe_exponent(1, std::vector<double>{0.2, 1.5}));
  EXPECT_FALSE(pipe_exponent(1, std::vector<double>{0.9999, 0.9999})) << "above 100";
  EXPECT_FALSE(pipe_exponent(1, std::vector<double>{0.5}));
  Skeleton skeleton = with_laterals({10, 20});
  skeleton.radius.assign(skeleton.node_count(), 0.01F);
  EXPECT_EQ(sample(skeleton).pipe_unsolved, 2U);
  EXPECT_TRUE(sample(skeleton).pipe_exponents.empty());
}

TEST(Forks, AreaRatioIsOneWhereThePipeExponentIsTwo) {
  Skeleton skeleton = with_laterals({10, 20, 30});
  assign_pipe_radii(skeleton, {.tip_radius = 0.004, .exponent = 2});
  for (const double ratio : sample(skeleton).area_ratios) EXPECT_NEAR(ratio, 1, 1e-6);
}

TEST(Forks, AreaRatiosCountFromTheGivenThickness) {
  Skeleton skeleton = with_laterals({10, 20, 30});
  assign_pipe_radii(skeleton, {.tip_radius = 0.01, .exponent = 2});
  // The forks' radii are 0.02, 0.0173 and 0.0141 m.
  EXPECT_EQ(sample(skeleton, 0).area_ratios.size(), 3U);
  EXPECT_EQ(sample(skeleton, 0.03).area_ratios.size(), 2U);
  EXPECT_EQ(sample(skeleton, 0.04).area_ratios.size(), 1U) << "the bound counts";
  EXPECT_EQ(sample(skeleton, 0.05).area_ratios.size(), 0U);
}

TEST(Forks, WithoutRadiiNothingIsSaidAboutThem) {
  const ForkSamples samples = sample(with_laterals({10}));
  EXPECT_EQ(samples.area_ratios.size() + samples.pipe_exponents.size() + samples.pipe_unsolved, 0U);
}

}  // namespace meristem::forks_test
