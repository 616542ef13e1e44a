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

namespace meristem::nearest_nodes_test {

std::vector<Vec3> random_points(std::size_t count, RandomKey key, Vec3 size) {
  std::vector<Vec3> points;
  for (std::uint64_t k = 0; k < count; ++k) {
    const Vec3 unit(key.uniform(3 * k), key.uniform(3 * k + 1), key.uniform(3 * k + 2));
    points.push_back(unit * size);
  }
  return points;
}

using Assignment = std::tuple<float, float, float, NodeIndex>;

std::vector<Assignment> assignments(NearestNodes& nearest) {
  std::vector<Assignment> all;
  nearest.sweep([&](Vec3 p, NodeIndex node, float) {
    all.emplace_back(p.x, p.y, p.z, node);
    return true;
  });
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<Assignment> brute_force(const std::vector<Vec3>& points, const std::vector<Vec3>& nodes, float influence) {
  std::vector<Assignment> all;
  for (const Vec3 p : points) {
    float min = std::numeric_limits<float>::infinity();
    NodeIndex nearest = kNoNode;
    for (NodeIndex node = 0; node < nodes.size(); ++node) {
      const float square = squared_length(p - nodes[node]);
      if (square < min && square <= influence * influence) std::tie(min, nearest) = std::tie(square, node);
    }
    if (nearest != kNoNode) all.emplace_back(p.x, p.y, p.z, nearest);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void add(NearestNodes& nearest, NodeIndex first, std::span<const Vec3> positions, float influence) {
  std::vector<NearestNodes::NewNode> nodes;
  for (const Vec3 position : positions) nodes.push_back({position, influence});
  Progress progress;
  nearest.add_nodes(first, nodes, progress);
}

// Adds nodes in batches of increasing size, as growth does.
void add_in_batches(NearestNodes& nearest, const std::vector<Vec3>& nodes, float influence) {
  for (std::size_t first = 0, size = 1; first < nodes.size(); first += size, size += 7) {
    const std::size_t count = std::min(size, nodes.size() - first);
    add(nearest, static_cast<NodeIndex>(first), std::span(nodes).subspan(first, count), influence);
  }
}

std::size_t remove_within(NearestNodes& nearest, float distance) {
  const std::size_t before = nearest.living();
  nearest.sweep([&](Vec3, NodeIndex, float distance2) { return distance2 > distance * distance; });
  return before - nearest.living();
}

TEST(NearestNodes, AgreeWithBruteForceInEveryShapeOfCloud) {
  Progress progress;
  const std::vector<Vec3> nodes = random_points(700, RandomKey(8), {1.4F, 1.4F, 1.4F});
  for (const Vec3 size : {Vec3(1, 1, 1), Vec3(1, 0.01F, 1), Vec3(0, 1, 0), Vec3(0, 0, 0), Vec3(1e-9F, 1, 1)}) {
    for (const float influence : {0.02F, 0.15F, 3.0F, std::numeric_limits<float>::infinity()}) {
      const std::vector<Vec3> points = random_points(2000, RandomKey(7), size);
      NearestNodes nearest(points, progress);
      add_in_batches(nearest, nodes, influence);
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
    NearestNodes nearest(points, progress);
    add_in_batches(nearest, nodes, 0.3F);
    EXPECT_EQ(assignments(nearest), expected) << threads << " threads";
  }
}

TEST(NearestNodes, TheLowerNumberKeepsPointsAtEqualDistance) {
  Progress progress;
  NearestNodes nearest({{0, 0, 0}}, progress);
  add(nearest, 0, std::vector<Vec3>{{1, 0, 0}, {-1, 0, 0}}, 5);
  add(nearest, 2, std::vector<Vec3>{{0, 1, 0}}, 5);
  EXPECT_EQ(std::get<3>(assignments(nearest)[0]), 0U);
}

TEST(NearestNodes, TheInfluenceDistanceItselfIsWithin) {
  Progress progress;
  NearestNodes nearest({{3, 4, 0}}, progress);
  add(nearest, 0, std::vector<Vec3>{{0, 0, 0}}, 5);
  EXPECT_EQ(assignments(nearest).size(), 1U);
  NearestNodes beyond({{3, 4.00001F, 0}}, progress);
  add(beyond, 0, std::vector<Vec3>{{0, 0, 0}}, 5);
  EXPECT_TRUE(assignments(beyond).empty());
}

TEST(NearestNodes, ANodeOutOfReachOfAPointLeavesItToOneThatReachesFarther) {
  Progress progress;
  NearestNodes nearest({{0, 0, 0}}, progress);
  const std::vector<NearestNodes::NewNode> nodes{{{1, 0, 0}, 0.5F}, {{0, 2, 0}, 3}, {{0, 0, 2.5F}, 3}};
  nearest.add_nodes(0, nodes, progress);
  EXPECT_EQ(std::get<3>(assignments(nearest)[0]), 1U);
}

TEST(NearestNodes, RemovedPointsAreGoneForGood) {
  Progress progress;
  const std::vector<Vec3> points = random_points(3000, RandomKey(4), {1, 1, 1});
  const std::vector<Vec3> nodes{{0.5F, 0.5F, 0.5F}, {0.1F, 0.1F, 0.1F}};
  NearestNodes nearest(points, progress);
  add(nearest, 0, nodes, 2);
  const std::size_t removed = remove_within(nearest, 0.3F);
  std::vector<Vec3> left;
  for (const Vec3 p : points) {
    if (std::min(glm::distance(p, nodes[0]), glm::distance(p, nodes[1])) > 0.3F) left.push_back(p);
  }
  EXPECT_EQ(removed, points.size() - left.size());
  EXPECT_EQ(nearest.living(), left.size());
  EXPECT_EQ(assignments(nearest), brute_force(left, nodes, 2));
  EXPECT_EQ(remove_within(nearest, 0.3F), 0U);
}

TEST(NearestNodes, FindTheNearestLivingPoint) {
  Progress progress;
  const std::vector<Vec3> points = random_points(5000, RandomKey(6), {1, 4, 0.1F});
  NearestNodes nearest(points, progress);
  for (const Vec3 point : random_points(50, RandomKey(9), {2, 5, 1})) {
    const auto nearer = [&](Vec3 a, Vec3 b) { return glm::distance(a, point) < glm::distance(b, point); };
    EXPECT_EQ(nearest.nearest_point(point), *std::min_element(points.begin(), points.end(), nearer));
  }
  EXPECT_FALSE(NearestNodes({}, progress).nearest_point(Vec3(0)).has_value());
}

TEST(NearestNodes, WithoutPointsNothingIsInfluenced) {
  Progress progress;
  NearestNodes nearest({}, progress);
  add(nearest, 0, std::vector<Vec3>{{0, 0, 0}}, 1);
  EXPECT_TRUE(assignments(nearest).empty());
  EXPECT_EQ(nearest.living(), 0U);
}

TEST(NearestNodes, RejectPointsThatAreNotFinite) {
  Progress progress;
  EXPECT_THROW(NearestNodes({{0, NAN, 0}}, progress), std::invalid_argument);
  EXPECT_THROW(NearestNodes({{INFINITY, 0, 0}}, progress), std::invalid_argument);
}

TEST(PointTree, HalvesCloudsOfEveryShapeIntoLeavesOfEqualSize) {
  Progress progress;
  for (const Vec3 size : {Vec3(1, 1, 1), Vec3(1e6F, 1, 1), Vec3(1e6F, 1e6F, 1e-6F), Vec3(0, 0, 1), Vec3(0, 0, 0)}) {
    std::vector<Vec3> points = random_points(10'000, RandomKey(4), size);
    const PointTree tree(points, progress);
    for (std::uint32_t leaf = 0; leaf < tree.leaf_count(); ++leaf) {
      const std::uint32_t begin = tree.first_point(tree.leaf_level(), leaf);
      const std::uint32_t end = tree.first_point(tree.leaf_level(), leaf + 1);
      ASSERT_LE(end - begin, PointTree::kLeafPoints);
      ASSERT_GE(end - begin, PointTree::kLeafPoints / 2 - 1);
      for (std::uint32_t node = PointTree::place(tree.leaf_level(), leaf), k = begin; k < end; ++k) {
        ASSERT_EQ(distance2(tree.boxes()[node], points[k]), 0);
      }
    }
    EXPECT_EQ(tree.first_point(tree.leaf_level(), tree.leaf_count()), points.size());
  }
}

TEST(PointTree, BoxesHoldTheirHalves) {
  Progress progress;
  std::vector<Vec3> points = random_points(1000, RandomKey(5), {3, 2, 1});
  const PointTree tree(points, progress);
  for (std::uint32_t node = 0; 2 * node + 2 < tree.node_count(); ++node) {
    Box both = tree.boxes()[2 * node + 1];
    both.add(tree.boxes()[2 * node + 2]);
    EXPECT_EQ(tree.boxes()[node].low, both.low);
    EXPECT_EQ(tree.boxes()[node].high, both.high);
  }
}

}  // namespace meristem::nearest_nodes_test
