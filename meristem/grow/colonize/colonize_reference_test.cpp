// SPDX-License-Identifier: Apache-2.0
// Compares the incremental growth with the simplest implementation, which tests all pairs of points and nodes in every
// step.
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/grow/colonize/colonize.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/plain_colonizer.h"

namespace meristem::colonize_reference_test {

const Scene kOpenScene;

void search_all_pairs(const std::vector<Vec3>& nodes, NodeIndex, PlainPoints& points) {
  for (std::size_t k = 0; k < points.position.size(); ++k) {
    points.nearest[k] = 0;
    points.distance2[k] = plain_distance2(points.position[k], nodes[0]);
    for (NodeIndex node = 1; node < nodes.size(); ++node) {
      const float distance2 = plain_distance2(points.position[k], nodes[node]);
      if (distance2 >= points.distance2[k]) continue;
      points.nearest[k] = node;
      points.distance2[k] = distance2;
    }
  }
}

std::vector<Vec3> ball(std::size_t count, RandomKey key) {
  std::vector<Vec3> points;
  for (std::uint64_t k = 0; k < count; ++k) {
    const double out = std::cbrt(key.uniform(k));
    points.push_back(Vec3(0, 0.5F, 0) + key.child("way").direction(k) * static_cast<float>(0.5 * out));
  }
  return points;
}

TEST(ColonizeReference, IncrementalGrowthEqualsBruteForceNodeByNode) {
  for (const double influence : {0.25, 0.6, 10.0}) {
    const RandomKey key(static_cast<std::uint64_t>(100 * influence));
    const std::vector<Vec3> points = ball(1000, key);
    ColonizeParameters parameters{.step = 0.03, .influence = influence, .kill = 0.06, .iterations = 80};
    parameters.finish = {.decimate = 0, .relax = false, .subdivide = 0};
    Stand stand;
    stand.add(
        make_colonizer(stand, {{Vec3(0), points}}, parameters, key, kOpenScene, SizeLimits(), "tree", Progress()));
    Progress progress;
    stand.grow(progress);
    const Skeleton skeleton = stand.take_skeletons(progress)[0];
    ASSERT_TRUE(check_skeleton(skeleton));
    const Skeleton plain = grow_plainly(points, parameters, key.child("tree").child(0), search_all_pairs);
    ASSERT_GT(skeleton.node_count(), 400U);
    EXPECT_EQ(skeleton.parent, plain.parent);
    EXPECT_EQ(skeleton.position, plain.position);
    EXPECT_EQ(skeleton.birth, plain.birth);
  }
}

}  // namespace meristem::colonize_reference_test
