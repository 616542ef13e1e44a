// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/node_light.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/graph/table/node_condition.h"
#include "meristem/scene/obstacle/obstacles.h"

namespace meristem::node_light_test {

Scene lit_from_above() {
  Scene scene;
  scene.light.sun = {{kUp, 1}};
  return scene;
}

/// A stem of 2 m with level branches of 1 m at every 0.2 m, in nodes of 0.1 m.
Skeleton ladder() {
  Skeleton tree;
  NodeIndex stem = tree.add_node(kNoNode, Vec3(0), 0);
  for (int k = 1; k <= 20; ++k) {
    stem = tree.add_node(stem, Vec3(0, 0.1F * static_cast<float>(k), 0), 0);
    if (k % 2 != 0) continue;
    NodeIndex branch = stem;
    for (int out = 1; out <= 10; ++out) {
      branch = tree.add_node(branch, tree.position[stem] + Vec3(0.1F * static_cast<float>(out), 0, 0), 0);
    }
  }
  return tree;
}

TEST(NodeLight, FallsFromTheTopOfACrownToItsBase) {
  const Skeleton tree = ladder();
  const std::vector<float> light = light_at_nodes(tree, lit_from_above());
  const auto at = [&](float height) {
    for (NodeIndex node = 0; node < tree.node_count(); ++node) {
      if (glm::distance(tree.position[node], Vec3(0.5F, height, 0)) < 1e-4F) return light[node];
    }
    return -1.0F;
  };
  EXPECT_NEAR(at(2), 1, 0.05);
  EXPECT_LT(at(1.8F), at(2));
  EXPECT_LT(at(1), 0.95F);
  EXPECT_GE(*std::ranges::min_element(light), 0);
  EXPECT_LE(*std::ranges::max_element(light), 1);
}

TEST(NodeLight, IsTheSameForATwiceAsLargeTree) {
  Skeleton large = ladder();
  for (Vec3& position : large.position) position *= 2;
  EXPECT_EQ(light_at_nodes(ladder(), lit_from_above()), light_at_nodes(large, lit_from_above()));
}

TEST(NodeLight, IsNoneBehindAnObstacle) {
  Scene scene = lit_from_above();
  Obstacle roof;
  roof.mesh = box_mesh({-0.05F, 3, -1}, {2, 3.2F, 1});
  scene.obstacles = Obstacles({roof});
  for (const float light : light_at_nodes(ladder(), scene)) EXPECT_EQ(light, 0);
}

TEST(NodeLight, IsTheSameOnAnyNumberOfThreads) {
  const auto on = [](int threads) {
    const ThreadLimit limit(threads);
    return light_at_nodes(ladder(), lit_from_above());
  };
  EXPECT_EQ(on(1), on(4));
}

TEST(NodeLight, ConditionsPreferTheLightThatGrowthHasComputed) {
  Skeleton tree = ladder();
  tree.radius.assign(tree.node_count(), 0.01F);
  tree.axis.assign(tree.node_count(), 0);
  tree.order.assign(tree.node_count(), 0);
  const SiteCondition bright{"light > 0.9", Expression::compile("light > 0.9", {node_variables(), {}})};
  const Scene scene = lit_from_above();
  const auto count = [&](const Scene* light) {
    const std::vector<std::uint8_t> holds = nodes_where(tree, SkeletonAxes(tree), bright, RandomKey(1), light);
    return static_cast<std::size_t>(std::ranges::count(holds, 1));
  };
  EXPECT_EQ(count(nullptr), 0U);
  EXPECT_GT(count(&scene), 20U);
  EXPECT_LT(count(&scene), tree.node_count());
  tree.extra["light"].assign(tree.node_count(), 1);
  EXPECT_EQ(count(&scene), tree.node_count());
}

}  // namespace meristem::node_light_test
