// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/growth_direction.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem {
namespace {

class PulledNodes {
 public:
  PulledNodes(const std::vector<Vec3>& points, std::vector<Vec3> nodes)
      : nodes_(std::move(nodes)), nearest_(points, 100, progress_) {
    nearest_.add_nodes(0, nodes_, progress_);
    const auto pulls = sums_.gather(nearest_, nodes_);
    pulls_.assign(pulls.begin(), pulls.end());
  }
  const std::vector<Pull>& pulls() const { return pulls_; }

 private:
  Progress progress_;
  std::vector<Vec3> nodes_;
  NearestNodes nearest_;
  PullSums sums_;
  std::vector<Pull> pulls_;
};

TEST(PullSums, AddUnitVectorsHoweverFarThePointsAre) {
  const PulledNodes nodes({{3, 0, 0}, {0, 0.5F, 0}}, {{0, 0, 0}});
  ASSERT_EQ(nodes.pulls().size(), 1U);
  EXPECT_NEAR(glm::distance(nodes.pulls()[0].sum, DVec3(1, 1, 0)), 0, 1e-11);
}

TEST(PullSums, ListPulledNodesInOrderAndNoOthers) {
  const PulledNodes nodes({{9, 1, 0}, {0, 1, 0}}, {{0, 0, 0}, {4, -9, 0}, {9, 0, 0}});
  ASSERT_EQ(nodes.pulls().size(), 2U);
  EXPECT_EQ(nodes.pulls()[0].node, 0U);
  EXPECT_EQ(nodes.pulls()[1].node, 2U);
}

TEST(PullSums, DoNotDependOnTheOrderOfPoints) {
  std::vector<Vec3> points;
  for (std::uint64_t k = 0; k < 1000; ++k) points.push_back(RandomKey(3).direction(k) * static_cast<float>(1 + k));
  const DVec3 sum = PulledNodes(points, {Vec3(0)}).pulls()[0].sum;
  std::reverse(points.begin(), points.end());
  EXPECT_EQ(PulledNodes(points, {Vec3(0)}).pulls()[0].sum, sum);
}

TEST(PullSums, APointOnItsNodePullsNowhere) {
  const PulledNodes nodes({{1, 1, 1}}, {{1, 1, 1}});
  ASSERT_EQ(nodes.pulls().size(), 1U);
  EXPECT_EQ(nodes.pulls()[0].sum, DVec3(0));
}

TEST(GrowthDirection, IsTheUnitSumPlusBias) {
  const auto plain = growth_direction({0, {0, 5, 0}}, DVec3(0));
  ASSERT_TRUE(plain.has_value());
  EXPECT_EQ(*plain, DVec3(0, 1, 0));
  const auto biased = growth_direction({0, {0, 5, 0}}, DVec3(1, 0, 0));
  ASSERT_TRUE(biased.has_value());
  EXPECT_NEAR(biased->x, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(biased->y, std::sqrt(0.5), 1e-15);
}

TEST(GrowthDirection, IsNothingWhereSumOrBiasedSumVanishes) {
  EXPECT_FALSE(growth_direction({0, {0, 0, 0}}, DVec3(0, 1, 0)).has_value());
  EXPECT_FALSE(growth_direction({0, {0, 2, 0}}, DVec3(0, -1, 0)).has_value());
  EXPECT_FALSE(growth_direction({0, {1e-9, 0, 0}}, DVec3(0)).has_value());
}

}  // namespace
}  // namespace meristem
