// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/nearest_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/base/random.h"

namespace meristem {
namespace {

std::vector<Vec3> random_points(std::size_t count, RandomKey key, Vec3 size) {
  std::vector<Vec3> points;
  for (std::uint64_t k = 0; k < count; ++k) {
    const Vec3 unit(key.uniform(3 * k), key.uniform(3 * k + 1), key.uniform(3 * k + 2));
    points.push_back(unit * size);
  }
  return points;
}

using Assignment = std::tuple<float, float, float, NodeIndex>;

std::vector<Assignment> assignments(const NearestNodes& nearest) {
  std::vector<Assignment> all;
  nearest.for_each_influenced([&](Vec3 p, NodeIndex node) { all.emplace_back(p.x, p.y, p.z, node); });
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<Assignment> brute_force(const std::vector<Vec3>& points, const std::vector<Vec3>& nodes, float influence) {
  std::vector<Assignment> all;
  for (const Vec3 p : points) {
    float least = std::numeric_limits<float>::infinity();
    NodeIndex nearest = kNoNode;
    for (NodeIndex node = 0; node < nodes.size(); ++node) {
      const Vec3 offset = p - nodes[node];
      const float square = offset.x * offset.x + offset.y * offset.y + offset.z * offset.z;
      if (square < least && square <= influence * influence) std::tie(least, nearest) = std::tie(square, node);
    }
    if (nearest != kNoNode) all.emplace_back(p.x, p.y, p.z, nearest);
  }
  std::sort(all.begin(), all.end());
  return all;
}

// Nodes in batches of growing size, as growth adds them.
void add_in_batches(NearestNodes& nearest, const std::vector<Vec3>& nodes) {
  Progress progress;
  for (std::size_t first = 0, size = 1; first < nodes.size(); first += size, size += 7) {
    const std::size_t count = std::min(size, nodes.size() - first);
    nearest.add_nodes(static_cast<NodeIndex>(first), std::span(nodes).subspan(first, count), progress);
  }
}

TEST(NearestNodes, AgreeWithBruteForceInEveryShapeOfCloud) {
  Progress progress;
  const std::vector<Vec3> nodes = random_points(700, RandomKey(8), {1.4F, 1.4F, 1.4F});
  for (const Vec3 size : {Vec3(1, 1, 1), Vec3(1, 0.01F, 1), Vec3(0, 1, 0), Vec3(0, 0, 0), Vec3(1e-9F, 1, 1)}) {
    for (const float influence : {0.02F, 0.15F, 3.0F, std::numeric_limits<float>::infinity()}) {
      const std::vector<Vec3> points = random_points(2000, RandomKey(7), size);
      NearestNodes nearest(points, influence, progress);
      add_in_batches(nearest, nodes);
      EXPECT_EQ(assignments(nearest), brute_force(points, nodes, influence)) << size.y << " " << influence;
    }
  }
}

TEST(NearestNodes, AssignTheSameOnAnyNumberOfThreads) {
  Progress progress;
  const std::vector<Vec3> points = random_points(5000, RandomKey(1), {1, 2, 3});
  const std::vector<Vec3> nodes = random_points(3000, RandomKey(2), {1, 2, 3});
  std::vector<Assignment> expected = brute_force(points, nodes, 0.3F);
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    NearestNodes nearest(points, 0.3F, progress);
    add_in_batches(nearest, nodes);
    EXPECT_EQ(assignments(nearest), expected) << threads << " threads";
  }
}

TEST(NearestNodes, TheLowerIndexKeepsPointsAtEqualDistance) {
  Progress progress;
  NearestNodes nearest({{0, 0, 0}}, 5, progress);
  EXPECT_EQ(nearest.add_nodes(0, std::vector<Vec3>{{1, 0, 0}, {-1, 0, 0}}, progress), 1U);
  EXPECT_EQ(nearest.add_nodes(2, std::vector<Vec3>{{0, 1, 0}}, progress), 0U);
  EXPECT_EQ(std::get<3>(assignments(nearest)[0]), 0U);
}

TEST(NearestNodes, TheInfluenceDistanceItselfIsWithin) {
  Progress progress;
  NearestNodes nearest({{3, 4, 0}}, 5, progress);
  EXPECT_EQ(nearest.add_nodes(0, std::vector<Vec3>{{0, 0, 0}}, progress), 1U);
  NearestNodes beyond({{3, 4.00001F, 0}}, 5, progress);
  EXPECT_EQ(beyond.add_nodes(0, std::vector<Vec3>{{0, 0, 0}}, progress), 0U);
}

TEST(NearestNodes, RemoveReachedPointsForGood) {
  Progress progress;
  const std::vector<Vec3> points = random_points(3000, RandomKey(4), {1, 1, 1});
  const std::vector<Vec3> nodes{{0.5F, 0.5F, 0.5F}, {0.1F, 0.1F, 0.1F}};
  NearestNodes nearest(points, 2, progress);
  nearest.add_nodes(0, nodes, progress);
  const std::size_t removed = nearest.remove_within(0.3F);
  std::vector<Vec3> left;
  for (const Vec3 p : points) {
    if (std::min(glm::distance(p, nodes[0]), glm::distance(p, nodes[1])) > 0.3F) left.push_back(p);
  }
  EXPECT_EQ(removed, points.size() - left.size());
  EXPECT_EQ(nearest.living(), left.size());
  EXPECT_EQ(assignments(nearest), brute_force(left, nodes, 2));
  EXPECT_EQ(nearest.remove_within(0.3F), 0U);
}

TEST(NearestNodes, WithoutPointsNothingIsInfluenced) {
  Progress progress;
  NearestNodes nearest({}, 1, progress);
  EXPECT_EQ(nearest.add_nodes(0, std::vector<Vec3>{{0, 0, 0}}, progress), 0U);
  EXPECT_EQ(nearest.remove_within(1), 0U);
  EXPECT_TRUE(assignments(nearest).empty());
}

TEST(NearestNodes, RejectPointsThatAreNotFinite) {
  Progress progress;
  EXPECT_THROW(NearestNodes({{0, NAN, 0}}, 1, progress), std::invalid_argument);
  EXPECT_THROW(NearestNodes({{INFINITY, 0, 0}}, 1, progress), std::invalid_argument);
}

TEST(PointGrid, NeverHasMoreCellsThanPoints) {
  for (const Vec3 size : {Vec3(1, 1, 1), Vec3(1e6F, 1, 1), Vec3(1e6F, 1e6F, 1e-6F), Vec3(0, 0, 1), Vec3(0, 0, 0)}) {
    const std::vector<Vec3> points = random_points(10'000, RandomKey(4), size);
    const PointGrid grid(points);
    EXPECT_LE(grid.cell_count(), points.size());
    for (const Vec3 point : points) ASSERT_LT(grid.cell_of(point), grid.cell_count());
  }
}

}  // namespace
}  // namespace meristem
