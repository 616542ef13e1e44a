// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/tree_form.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/check_skeleton.h"

namespace meristem::tree_form_test {

TreeForm form_of(const Skeleton& skeleton) { return measure_form(skeleton, NodeChildren(skeleton)); }

/// Adds a lateral of one segment.
void add_lateral(Skeleton& skeleton, NodeIndex parent, Vec3 end, AxisIndex axis) {
  const NodeIndex node = skeleton.add_node(parent, end, 0);
  skeleton.axis[node] = axis;
  skeleton.order[node] = static_cast<std::uint16_t>(skeleton.order[parent] + 1);
  skeleton.radius[node] = 0.01F;
}

/// A stem from (1, 10, 1) that is 2 m high and tapers from 0.2 to 0.1 m radius. At its top, it has four horizontal
/// laterals of 1 m toward the four winds, and above them a tip at 3 m.
Skeleton candelabra() {
  Skeleton skeleton;
  const Vec3 root(1, 10, 1);
  skeleton.radius[skeleton.add_node(kNoNode, root, 0)] = 0.2F;
  skeleton.radius[skeleton.add_node(0, root + Vec3(0, 2, 0), 0)] = 0.1F;
  skeleton.radius[skeleton.add_node(1, root + Vec3(0, 3, 0), 0)] = 0.02F;
  add_lateral(skeleton, 1, root + Vec3(1, 2, 0), 1);
  add_lateral(skeleton, 1, root + Vec3(-1, 2, 0), 2);
  add_lateral(skeleton, 1, root + Vec3(0, 2, 1), 3);
  add_lateral(skeleton, 1, root + Vec3(0, 2, -1), 4);
  return skeleton;
}

TEST(TreeForm, CountsByOrder) {
  const TreeForm form = form_of(candelabra());
  EXPECT_EQ(form.nodes, 7U);
  EXPECT_EQ(form.metamers, 6U);
  EXPECT_EQ(form.tips, 5U);
  EXPECT_EQ(form.forks, 1U);
  EXPECT_EQ(form.axes_by_order, (std::vector<std::uint64_t>{1, 4}));
  EXPECT_EQ(form.length_by_order, (std::vector<double>{3, 4}));
}

TEST(TreeForm, SizesOfACandelabra) {
  const TreeForm form = form_of(candelabra());
  EXPECT_DOUBLE_EQ(form.height, 3);
  EXPECT_EQ(form.fork, NodeIndex{1});
  EXPECT_DOUBLE_EQ(form.crown_height, 1);
  // From above, the crown is a square with diagonals of 2 m.
  EXPECT_DOUBLE_EQ(form.crown_width, 2);
  EXPECT_NEAR(form.crown_mean_width, 4 * std::sqrt(2.0) / kPi, 1e-6);
  EXPECT_NEAR(form.crown_ground_area, 2, 1e-6);
  // The hull is a pyramid 1 m high on that square.
  EXPECT_NEAR(form.crown_hull_volume, 2.0 / 3, 1e-6);
  EXPECT_NEAR(form.crown_hull_area, 2 + 4 * std::sqrt(3.0) / 2, 1e-6);
  // 1.3 m is 0.65 of the length from 0.2 to 0.1 m radius.
  EXPECT_NEAR(*form.diameter, 2 * (0.2 - 0.65 * 0.1), 1e-6);
}

TEST(TreeForm, SumsOfVectors) {
  const TreeForm form = form_of(candelabra());
  EXPECT_EQ(form.segment_sum, DVec3(0, 3, 0));
  EXPECT_EQ(form.node_sum, DVec3(0, 2 + 3 + 4 * 2, 0));
}

TEST(TreeForm, AStemWithoutAForkHasNoCrown) {
  Skeleton stem;
  stem.add_node(kNoNode, {0, 0, 0}, 0);
  stem.add_node(0, {0, 1, 0}, 0);
  const TreeForm form = form_of(stem);
  EXPECT_FALSE(form.fork);
  EXPECT_EQ(form.crown_width + form.crown_height + form.crown_hull_volume, 0);
  EXPECT_FALSE(form.diameter) << "below breast height";
  EXPECT_EQ(form.stems, 0U);
  EXPECT_EQ(form_of({}).nodes, 0U);
}

/// Adds a line of two segments up to a height, with one radius. The line gets its own axis if it leaves another line.
void add_stem(Skeleton& skeleton, NodeIndex parent, Vec3 base, Vec3 end, float radius) {
  const AxisIndex axis = skeleton.node_count() == 0 ? 0 : skeleton.axis.back() + 1;
  for (const Vec3 position : {base, end}) {
    parent = skeleton.add_node(parent, position, 0);
    skeleton.axis[parent] = axis;
    skeleton.radius[parent] = radius;
  }
}

TEST(TreeForm, TheThickestStemCountsAndNotTheFirstAxis) {
  Skeleton bush;
  add_stem(bush, kNoNode, {0, 0, 0}, {0.1F, 2, 0}, 0.002F);  // the main axis is a twig
  add_stem(bush, 0, {0.1F, 0.1F, 0}, {0.2F, 3, 0}, 0.04F);
  add_stem(bush, 0, {-0.1F, 0.1F, 0}, {-0.2F, 3, 0}, 0.03F);
  const TreeForm form = form_of(bush);
  EXPECT_NEAR(*form.diameter, 0.08, 1e-7);
  EXPECT_EQ(form.stems, 2U) << "the twig is thinner than a third of the thickest";
  EXPECT_NEAR(std::sqrt(form.diameter_squares), 0.1, 1e-7);  // 8 and 6 cm together equal one of 10 cm
  EXPECT_NEAR(form.base_diameter, 0.004, 1e-7);
}

TEST(TreeForm, WhatHangsDownPastBreastHeightIsNoStem) {
  Skeleton weeping;
  add_stem(weeping, kNoNode, {0, 0, 0}, {0, 4, 0}, 0.1F);
  add_stem(weeping, 1, {0.5F, 4, 0}, {0.5F, 0.2F, 0}, 0.09F);
  add_stem(weeping, 3, {0.6F, 0.2F, 0}, {0.7F, 2, 0}, 0.09F);  // and up again
  const TreeForm form = form_of(weeping);
  EXPECT_EQ(form.stems, 1U);
  EXPECT_NEAR(*form.diameter, 0.2, 1e-7);
}

TEST(TreeForm, ALateralIsAsThickAsItselfAndNotAsItsParent) {
  Skeleton skeleton;
  add_stem(skeleton, kNoNode, {0, 0, 0}, {0, 1.2F, 0}, 0.1F);
  add_stem(skeleton, 1, {0.2F, 1.4F, 0}, {0.3F, 2, 0}, 0.02F);
  EXPECT_NEAR(*form_of(skeleton).diameter, 0.04, 1e-7);
}

TEST(TreeForm, BreastHeightIsAboveTheRootWhereverThatStands) {
  Skeleton skeleton = candelabra();
  const double on_a_hill = *form_of(skeleton).diameter;
  for (Vec3& position : skeleton.position) position.y -= 10;
  EXPECT_NEAR(*form_of(skeleton).diameter, on_a_hill, 1e-6);
}

TEST(TreeForm, WithoutRadiiThereIsNoDiameter) {
  Skeleton skeleton = candelabra();
  skeleton.radius.assign(skeleton.node_count(), 0);
  EXPECT_FALSE(form_of(skeleton).diameter);
}

TEST(TreeForm, ACrownInAPlaneHasNoVolume) {
  Skeleton skeleton = candelabra();
  for (Vec3& position : skeleton.position) position.z = 0;
  const TreeForm form = form_of(skeleton);
  EXPECT_EQ(form.crown_hull_volume, 0);
  EXPECT_EQ(form.crown_hull_area, 0);
  EXPECT_EQ(form.crown_ground_area, 0);
  EXPECT_DOUBLE_EQ(form.crown_width, 2);
}

TEST(TreeForm, MetamersAreThoseThatAreNumberedOnEachAxis) {
  Skeleton skeleton;
  for (NodeIndex node = 0; node < 7; ++node) skeleton.add_node(node == 0 ? kNoNode : node - 1, Vec3(0, node, 0), 0);
  skeleton.axis = {0, 0, 0, 0, 1, 1, 1};
  skeleton.order = {0, 0, 0, 0, 1, 1, 1};
  // The stem's second metamer has two nodes. The first metamer of the branch also has two. The last node belongs to no
  // metamer.
  skeleton.extra["metamer"] = {0, 1, 2, 2, 1, 1, -1};
  EXPECT_EQ(form_of(skeleton).metamers, 3U);
}

TEST(TreeForm, TwiceTheSizeHasTwiceTheLengthsAndFourTimesTheAreas) {
  Skeleton skeleton = candelabra();
  const TreeForm small = form_of(skeleton);
  for (Vec3& position : skeleton.position) position *= 2;
  const TreeForm large = form_of(skeleton);
  EXPECT_NEAR(large.height, 2 * small.height, 1e-6);
  EXPECT_NEAR(large.crown_width, 2 * small.crown_width, 1e-6);
  EXPECT_NEAR(large.crown_hull_area, 4 * small.crown_hull_area, 1e-5);
  EXPECT_NEAR(large.crown_hull_volume, 8 * small.crown_hull_volume, 1e-5);
  EXPECT_EQ(large.axes_by_order, small.axes_by_order);
}

}  // namespace meristem::tree_form_test
