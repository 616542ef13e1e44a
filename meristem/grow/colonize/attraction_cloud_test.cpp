// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/attraction_cloud.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::attraction_cloud_test {

const Scene kOpenScene;

// One tree with its root at the first of `nodes`, after its first round.
class OneTree {
 public:
  OneTree(const std::vector<Vec3>& points, const std::vector<Vec3>& nodes) {
    cloud_.join(nodes[0], points, {100, 0.01, {}}, kOpenScene);
    for (std::size_t k = 1; k < nodes.size(); ++k) cloud_.add_node(0, nodes[k] - nodes[0]);
    Progress progress;
    cloud_.begin_round(progress);
  }
  std::span<const Pull> pulls() const { return cloud_.pulls(0); }

 private:
  AttractionCloud cloud_;
};

TEST(AttractionCloud, AddsUnitVectorsHoweverFarThePointsAre) {
  const OneTree tree({{3, 0, 0}, {0, 0.5F, 0}}, {{0, 0, 0}});
  ASSERT_EQ(tree.pulls().size(), 1U);
  EXPECT_NEAR(glm::distance(tree.pulls()[0].sum, DVec3(1, 1, 0)), 0, 1e-11);
}

TEST(AttractionCloud, ListsPulledNodesInOrderAndNoOthers) {
  const OneTree tree({{9, 1, 0}, {0, 1, 0}}, {{0, 0, 0}, {4, -9, 0}, {9, 0, 0}});
  ASSERT_EQ(tree.pulls().size(), 2U);
  EXPECT_EQ(tree.pulls()[0].node, 0U);
  EXPECT_EQ(tree.pulls()[1].node, 2U);
}

TEST(AttractionCloud, PullsDoNotDependOnTheOrderOfPoints) {
  std::vector<Vec3> points;
  for (std::uint64_t k = 0; k < 1000; ++k) points.push_back(RandomKey(3).direction(k) * (1 + 0.05F * k));
  const DVec3 sum = OneTree(points, {Vec3(0)}).pulls()[0].sum;
  std::reverse(points.begin(), points.end());
  EXPECT_EQ(OneTree(points, {Vec3(0)}).pulls()[0].sum, sum);
}

TEST(AttractionCloud, APointOnItsNodePullsNowhere) {
  const OneTree tree({{1, 1, 1}}, {{1, 1, 1}});
  ASSERT_EQ(tree.pulls().size(), 1U);
  EXPECT_EQ(tree.pulls()[0].sum, DVec3(0));
}

TEST(AttractionCloud, APointBelongsToTheNearestNodeWhicheverTreeBroughtIt) {
  AttractionCloud cloud;
  const auto first = cloud.join({0, 0, 0}, {{9, 1, 0}}, {100, 0.1, {}}, kOpenScene);
  const auto second = cloud.join({10, 0, 0}, {{1, 1, 0}}, {100, 0.1, {}}, kOpenScene);
  Progress progress;
  cloud.begin_round(progress);
  // Each tree gets the other tree's point, one metre to its side and one metre up.
  ASSERT_EQ(cloud.pulls(first).size(), 1U);
  ASSERT_EQ(cloud.pulls(second).size(), 1U);
  EXPECT_NEAR(glm::distance(cloud.pulls(first)[0].sum, glm::normalize(DVec3(1, 1, 0))), 0, 1e-11);
  EXPECT_NEAR(glm::distance(cloud.pulls(second)[0].sum, glm::normalize(DVec3(-1, 1, 0))), 0, 1e-11);
}

TEST(AttractionCloud, PointsAreUsedUpWithinTheirTreesKillDistance) {
  AttractionCloud cloud;
  const auto greedy = cloud.join({0, 0, 0}, {{0, 1, 0}}, {100, 0.5, {}}, kOpenScene);
  const auto modest = cloud.join({10, 0, 0}, {{10, 1, 0}}, {100, 0.1, {}}, kOpenScene);
  Progress progress;
  cloud.begin_round(progress);
  for (const auto tree : {greedy, modest}) cloud.add_node(tree, {0, 0.7F, 0});
  cloud.begin_round(progress);
  EXPECT_EQ(cloud.point_count(), 1U);
  EXPECT_TRUE(cloud.pulls(greedy).empty());
  EXPECT_EQ(cloud.pulls(modest)[0].node, 1U);
  EXPECT_TRUE(cloud.has_advanced(greedy));
  EXPECT_TRUE(cloud.has_advanced(modest));
  // A node that comes nearer to no point is no advance.
  cloud.add_node(modest, {0, -1, 0});
  cloud.begin_round(progress);
  EXPECT_FALSE(cloud.has_advanced(modest));
}

TEST(AttractionCloud, FindsTheNearestPointFromEachRoot) {
  AttractionCloud cloud;
  cloud.join({0, 0, 0}, {{0, 3, 0}, {8, 1, 0}}, {0.5, 0.1, {}}, kOpenScene);
  const auto other = cloud.join({10, 0, 0}, {}, {0.5, 0.1, {}}, kOpenScene);
  Progress progress;
  cloud.begin_round(progress);
  EXPECT_EQ(cloud.nearest_point(0), Vec3(0, 3, 0));
  EXPECT_EQ(cloud.nearest_point(other), Vec3(-2, 1, 0));
}

}  // namespace meristem::attraction_cloud_test
