// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/moving_points.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/base/random.h"

namespace meristem::moving_points_test {

using NewNode = MovingPoints::NewNode;

Vec3 random_position(RandomKey key, std::uint64_t k) {
  return {key.uniform(3 * k), key.uniform(3 * k + 1), key.uniform(3 * k + 2)};
}

MovingPoints random_points(std::size_t count) {
  std::vector<MovingPoint> points(count);
  for (std::size_t k = 0; k < count; ++k) points[k].position = random_position(RandomKey(4), k);
  return MovingPoints(std::move(points));
}

NodeIndex nearest_by_force(Vec3 position, const std::vector<NewNode>& nodes) {
  NodeIndex nearest = kNoNode;
  float min = std::numeric_limits<float>::infinity();
  for (NodeIndex k = 0; k < nodes.size(); ++k) {
    const float square = squared_length(position - nodes[k].position);
    if (square >= min || square > nodes[k].influence * nodes[k].influence) continue;
    nearest = k;
    min = square;
  }
  return nearest;
}

// Runs rounds in which nodes are added in a growing chain and all points move by up to `stride`. Returns how often a
// point's node differs from the result of testing all pairs.
int disagreements(float stride, const std::vector<float>& influences, int rounds = 40) {
  MovingPoints points = random_points(300);
  std::vector<NewNode> nodes;
  const RandomKey key(9);
  Progress progress;
  int wrong = 0;
  for (int round = 0; round < rounds; ++round) {
    const auto first = static_cast<NodeIndex>(nodes.size());
    for (int k = 0; k < 12; ++k) {
      const std::size_t number = nodes.size();
      const Vec3 from = number < 12 ? Vec3(0.5F, 0, 0.5F) : nodes[number - 12].position;
      nodes.push_back({from + 0.03F * key.child(k).direction(static_cast<std::uint64_t>(round)) + Vec3(0, 0.02F, 0),
                       influences[number % influences.size()]});
    }
    points.add_nodes(first, std::span(nodes).subspan(first), progress);
    for (const MovingPoint& point : points.points())
      wrong += point.node != nearest_by_force(point.position, nodes) ? 1 : 0;
    for (std::size_t k = 0; k < points.living(); ++k) {
      const Vec3 way = stride * key.child("move").child(static_cast<std::uint64_t>(round)).direction(k);
      points.move(k, points.points()[k].position + way);
    }
  }
  return wrong;
}

constexpr float kFar = std::numeric_limits<float>::infinity();

TEST(MovingPoints, KnowTheirNearestNodeHoweverTheyMove) {
  for (const float stride : {0.0F, 1e-6F, 0.001F, 0.02F, 0.5F}) EXPECT_EQ(disagreements(stride, {kFar}), 0) << stride;
}

TEST(MovingPoints, AreInfluencedWithinTheNodesReachOnly) {
  for (const float stride : {0.0F, 0.01F}) EXPECT_EQ(disagreements(stride, {0.2F}), 0) << stride;
}

TEST(MovingPoints, AreInfluencedByNodesThatReachPastNearerOnes) {
  for (const float stride : {0.0F, 0.01F}) EXPECT_EQ(disagreements(stride, {0.15F, 0.4F, kFar}), 0) << stride;
}

TEST(MovingPoints, KeepTheNodeWithTheLowerNumberOfTwoAtTheSameDistance) {
  std::vector<MovingPoint> one(1);
  MovingPoints points(one);
  Progress progress;
  const std::vector<NewNode> nodes{{{2, 0, 0}, kFar}, {{0, 1, 0}, kFar}, {{1, 0, 0}, kFar}, {{0, 0, 1}, kFar}};
  points.add_nodes(0, nodes, progress);
  EXPECT_EQ(points.points()[0].node, 1U);
  points.add_nodes(4, std::vector<NewNode>{{{0, -1, 0}, kFar}}, progress);
  EXPECT_EQ(points.points()[0].node, 1U);
}

TEST(MovingPoints, RestWhileInert) {
  MovingPoints points = random_points(2);
  Progress progress;
  points.add_nodes(0, std::vector<NewNode>{{{0, 0, 0}, kFar}}, progress);
  points.set_inert(0, true);
  int seen = 0;
  points.sweep([&](Vec3 position, NodeIndex, float) {
    EXPECT_EQ(position, points.points()[1].position);
    ++seen;
    return false;
  });
  EXPECT_EQ(seen, 1);
  EXPECT_EQ(points.living(), 1U);
}

TEST(MovingPoints, AreTheSameOnAnyNumberOfThreads) {
  const auto nodes_of = [](int threads) {
    const ThreadLimit limit(threads);
    MovingPoints points = random_points(2000);
    std::vector<NewNode> nodes;
    for (std::uint64_t k = 0; k < 500; ++k) nodes.push_back({random_position(RandomKey(5), k), 0.3F});
    Progress progress;
    points.add_nodes(0, nodes, progress);
    std::vector<NodeIndex> found;
    for (const MovingPoint& point : points.points()) found.push_back(point.node);
    return found;
  };
  const auto one = nodes_of(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(nodes_of(threads), one);
}

TEST(MovingPoints, MustBeFinite) {
  std::vector<MovingPoint> points(1);
  points[0].position.y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(MovingPoints{points}, std::invalid_argument);
}

}  // namespace meristem::moving_points_test
