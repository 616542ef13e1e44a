// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/nearest_axis.h"

#include <limits>

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::nearest_axis_test {

/// A trunk of 2 m and twigs that stand off it, thinner toward the tip.
Stem trunk_with_twigs(int twigs, float x) {
  Stem stem;
  Skeleton& skeleton = stem.skeleton;
  NodeIndex last = kNoNode;
  for (int k = 0; k <= 20; ++k) {
    last = skeleton.add_node(last, Vec3(x, 0.1F * static_cast<float>(k), 0), 0);
    skeleton.radius[last] = 0.05F - 0.002F * static_cast<float>(k);
  }
  for (int k = 0; k < twigs; ++k) {
    const auto from = static_cast<NodeIndex>(1 + k % 19);
    const float side = k % 2 == 0 ? 1.0F : -1.0F;
    NodeIndex node = from;
    for (int step = 1; step <= 4; ++step) {
      const float reach = 0.1F * static_cast<float>(step);
      node = skeleton.add_node(node, skeleton.position[from] + Vec3(side * reach, 0.01F * reach, 0.3F * reach), 0);
      skeleton.radius[node] = 0.004F;
      skeleton.axis[node] = static_cast<AxisIndex>(k + 1);
      skeleton.order[node] = 1;
    }
  }
  return stem;
}

TEST(NearestAxis, FindsTheAxisWhoseSurfaceAPositionLiesOn) {
  Plant plant;
  plant.stems = {trunk_with_twigs(18, 0), trunk_with_twigs(18, 5)};
  const NearestAxis nearest(plant);
  EXPECT_EQ(nearest.find(Vec3(0.049F, 0.05F, 0)), (StemAxis{0, 0}));
  EXPECT_EQ(nearest.find(Vec3(0.01F, 0.05F, 0)), (StemAxis{0, 0})) << "within the wood";
  for (const std::uint32_t stem : {0U, 1U}) {
    const Skeleton& skeleton = plant.stems[stem].skeleton;
    for (NodeIndex node = 21; node < skeleton.node_count(); ++node) {
      if ((node - 21) % 4 == 0) continue;  // beside the trunk
      EXPECT_EQ(nearest.find(skeleton.position[node] + Vec3(0, 0.004F, 0)), (StemAxis{stem, skeleton.axis[node]}));
    }
  }
}

TEST(NearestAxis, AnOrganWithinWoodStandsOnTheFirstAxisThatHoldsIt) {
  Plant plant;
  plant.stems = {trunk_with_twigs(18, 0)};
  const NearestAxis nearest(plant);
  // Beside the centre line of a twig, and within the trunk that it springs from.
  const Vec3 base = plant.stems[0].skeleton.position[5] + Vec3(0.02F, 0.002F, 0.006F);
  EXPECT_EQ(nearest.find_bearer(base), (StemAxis{0, 0}));
  EXPECT_NE(nearest.find(base)->axis, 0U);
  EXPECT_EQ(nearest.find_bearer(Vec3(0.2F, 0.1F, 0.065F))->axis, nearest.find(Vec3(0.2F, 0.1F, 0.065F))->axis);
}

TEST(NearestAxis, HasNothingInAPlantWithoutStems) { EXPECT_FALSE(NearestAxis(Plant()).find(Vec3(0))); }

TEST(NearestAxis, OfEqualOnesTheFirstWins) {
  Plant plant;
  plant.stems = {trunk_with_twigs(0, 1), trunk_with_twigs(0, -1)};
  EXPECT_EQ(NearestAxis(plant).find(Vec3(0, 1, 0)), (StemAxis{0, 0}));
}

}  // namespace meristem::nearest_axis_test
