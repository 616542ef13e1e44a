// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/growth_in_time.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/check_skeleton.h"

namespace meristem::growth_in_time_test {

/// A stem of five upward segments, born in steps 1 to 5, with a lateral of two from its second node, born in steps 4
/// and 5.
Skeleton forked_stem() {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  for (int k = 1; k <= 5; ++k) skeleton.add_node(static_cast<NodeIndex>(k - 1), {0, static_cast<float>(k), 0}, k);
  skeleton.add_node(2, {1, 2, 0}, 4);
  skeleton.add_node(6, {2, 2, 0}, 5);
  skeleton.radius = {0.2F, 0.2F, 0.2F, 0.1F, 0.1F, 0.1F, 0.1F, 0.1F};
  skeleton.axis = {0, 0, 0, 0, 0, 0, 1, 1};
  skeleton.order = {0, 0, 0, 0, 0, 0, 1, 1};
  return skeleton;
}

TEST(GrowthInTime, SegmentsLengthenFromTheirParentsBirthToTheirOwn) {
  const Skeleton whole = forked_stem();
  const GrowthSpans spans(whole);
  for (double step = 0; step <= 5; step += 0.125) {
    const Skeleton standing = standing_at(whole, spans, step, 2).skeleton;
    float top = 0;
    for (const Vec3 position : standing.position) top = std::max(top, position.y);
    EXPECT_NEAR(top, step, 1e-6) << "after " << step << " steps";
    if (standing.node_count() > 1) check_skeleton(standing);
  }
}

TEST(GrowthInTime, AtTheEndAllStandsAsItHasGrown) {
  const Skeleton whole = forked_stem();
  const TrimmedSkeleton end = standing_at(whole, GrowthSpans(whole), 5, 2.4);
  EXPECT_EQ(skeleton_hash(end.skeleton), skeleton_hash(whole));
  EXPECT_EQ(skeleton_hash(standing_at(whole, GrowthSpans(whole), 100, 2.4).skeleton), skeleton_hash(whole));
}

TEST(GrowthInTime, WoodThickensWithTheTipsThatItBears) {
  const Skeleton whole = forked_stem();
  const GrowthSpans spans(whole);
  // One of the two final tips has grown: half the cross-section.
  EXPECT_NEAR(standing_at(whole, spans, 3, 2).skeleton.radius[0], 0.2 * std::sqrt(0.5), 1e-6);
  double last = 0;
  for (double step = 0.05; step <= 5; step += 0.05) {
    const double radius = standing_at(whole, spans, step, 2).skeleton.radius[0];
    EXPECT_GE(radius, last);
    if (last > 0) {
      EXPECT_LT(radius - last, 0.01) << "after " << step << " steps";
    }
    last = radius;
  }
}

TEST(GrowthInTime, SegmentsOfOneStepFollowEachOther) {
  Skeleton shoot;
  shoot.add_node(kNoNode, {0, 0, 0}, 0);
  for (int k = 1; k <= 4; ++k) shoot.add_node(static_cast<NodeIndex>(k - 1), {0, static_cast<float>(k), 0}, 7);
  shoot.radius.assign(5, 0.1F);
  shoot.axis.assign(5, 0);
  shoot.order.assign(5, 0);
  const GrowthSpans spans(shoot);
  for (NodeIndex node = 1; node < 5; ++node) {
    EXPECT_FLOAT_EQ(spans.begin[node], 7.0F * static_cast<float>(node - 1) / 4);
    EXPECT_FLOAT_EQ(spans.end[node], 7.0F * static_cast<float>(node) / 4);
  }
}

TEST(GrowthInTime, ABranchThatIsShedFallsAfterItsLastGrowth) {
  Skeleton whole = forked_stem();
  let_fall(whole, std::vector<std::uint8_t>(whole.node_count(), 1), 1.5);
  const GrowthSpans spans(whole);
  EXPECT_EQ(standing_at(whole, spans, 5.7, 2).skeleton.node_count(), 8U);
  const Skeleton after = standing_at(whole, spans, 6.5, 2).skeleton;
  EXPECT_EQ(after.node_count(), 6U) << "the stem's own marks mean nothing";
  EXPECT_FLOAT_EQ(after.radius[0], 0.2F) << "wood does not shrink";
}

TEST(GrowthInTime, ABranchWithersBackToItsBaseBeforeItFalls) {
  Skeleton whole = forked_stem();
  let_fall(whole, std::vector<std::uint8_t>(whole.node_count(), 1), 1.5);
  const GrowthSpans spans(whole);
  // The last growth ends at 5, the fall is at 6.5, so withering begins at 5.75.
  const auto reach = [&](double step) {
    float max = 0;
    for (const Vec3 position : standing_at(whole, spans, step, 2).skeleton.position) max = std::max(max, position.x);
    return max;
  };
  EXPECT_FLOAT_EQ(reach(5.75), 2);
  EXPECT_NEAR(reach(6.125), 1, 1e-5) << "half way back";
  constexpr double kStep = 0.01;
  for (double step = 5; step < 7; step += kStep) {
    EXPECT_LE(std::abs(reach(step + kStep) - reach(step)), 2.0 * kStep / 0.75 + 1e-5) << "after " << step;
  }
  EXPECT_EQ(reach(6.5), 0);
}

TEST(GrowthInTime, BirthsThatDoNotRiseKeepTheirOrder) {
  Skeleton odd;
  odd.add_node(kNoNode, {0, 0, 0}, 3);
  odd.add_node(0, {0, 1, 0}, 2);
  odd.add_node(1, {0, 2, 0}, 1);
  odd.radius.assign(3, 0.1F);
  odd.axis.assign(3, 0);
  odd.order.assign(3, 0);
  const GrowthSpans spans(odd);
  for (NodeIndex node = 1; node < 3; ++node) {
    EXPECT_GE(spans.begin[node], spans.end[odd.parent[node]]);
    EXPECT_GT(spans.end[node], spans.begin[node]);
  }
}

}  // namespace meristem::growth_in_time_test
