// SPDX-License-Identifier: Apache-2.0
// Growth in its plainest form, with a loop over all pairs of points and nodes in every step, against the incremental
// one.
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "meristem/grow/colonize/colonize.h"
#include "tests/support/check_skeleton.h"

namespace meristem {
namespace {

struct PlainTree {
  std::vector<NodeIndex> parent{kNoNode};
  std::vector<Vec3> position{Vec3(0)};
  std::vector<int> birth{0};
  std::vector<int> turns{0};

  bool is_free(NodeIndex node, Vec3 place, double step) const {
    for (NodeIndex other = 0; other < parent.size(); ++other) {
      const bool is_near_kin = other == node || other == parent[node] || parent[other] == node;
      if (is_near_kin && glm::distance(position[other], place) < 0.01 * step) return false;
    }
    return true;
  }
};

float distance2(Vec3 a, Vec3 b) {
  const Vec3 offset = a - b;
  return offset.x * offset.x + offset.y * offset.y + offset.z * offset.z;
}

std::optional<NodeIndex> nearest_node(const PlainTree& tree, Vec3 point, double influence) {
  NodeIndex nearest = 0;
  for (NodeIndex node = 1; node < tree.position.size(); ++node) {
    if (distance2(point, tree.position[node]) < distance2(point, tree.position[nearest])) nearest = node;
  }
  const auto reach = static_cast<float>(influence);
  if (distance2(point, tree.position[nearest]) > reach * reach) return std::nullopt;
  return nearest;
}

std::optional<Vec3> place_child(PlainTree& tree, NodeIndex node, DVec3 sum, double step, RandomKey key) {
  DVec3 direction(0);
  if (glm::length(sum) > 1e-5) {
    direction = sum / glm::length(sum);
    const Vec3 place(DVec3(tree.position[node]) + step * direction);
    if (tree.is_free(node, place, step)) return place;
  }
  if (tree.turns[node] == 4) return std::nullopt;
  const int turn = ++tree.turns[node];
  const DVec3 turned = direction + 1.0 * turn * DVec3(key.child(node).direction(static_cast<std::uint64_t>(turn)));
  const Vec3 place(DVec3(tree.position[node]) + step / glm::length(turned) * turned);
  return tree.is_free(node, place, step) ? std::optional(place) : std::nullopt;
}

// One step; returns whether any point pulled.
bool grow_step(PlainTree& tree, std::vector<Vec3>& points, const ColonizeParameters& parameters, RandomKey key,
               int birth) {
  std::vector<DVec3> sum(tree.position.size(), DVec3(0));
  std::vector<bool> is_pulled(tree.position.size(), false);
  for (const Vec3 point : points) {
    const std::optional<NodeIndex> node = nearest_node(tree, point, parameters.influence);
    if (!node) continue;
    is_pulled[*node] = true;
    sum[*node] += glm::normalize(DVec3(point) - DVec3(tree.position[*node]));
  }
  bool any = false;
  for (NodeIndex node = 0; node < sum.size(); ++node) {
    if (!is_pulled[node]) continue;
    any = true;
    const std::optional<Vec3> place = place_child(tree, node, sum[node], parameters.step, key);
    if (!place) continue;
    tree.parent.push_back(node);
    tree.position.push_back(*place);
    tree.birth.push_back(birth);
    tree.turns.push_back(0);
  }
  std::erase_if(points, [&](Vec3 point) { return nearest_node(tree, point, parameters.kill).has_value(); });
  return any;
}

TEST(ColonizeReference, IncrementalGrowthEqualsBruteForceNodeByNode) {
  for (const double influence : {0.25, 0.6, 10.0}) {
    const RandomKey key(static_cast<std::uint64_t>(100 * influence));
    std::vector<Vec3> points;
    for (std::uint64_t k = 0; k < 1000; ++k) {
      const double out = std::cbrt(key.uniform(k));
      points.push_back(Vec3(0, 0.5F, 0) + key.child("way").direction(k) * static_cast<float>(0.5 * out));
    }
    ColonizeParameters parameters{.step = 0.03, .influence = influence, .kill = 0.06, .iterations = 80};
    parameters.finish.relax = false;
    Progress progress;
    Stand stand;
    stand.add(make_colonizer(stand, {{Vec3(0), points}}, parameters, key, Limits(), "tree"));
    stand.grow(progress);
    const Skeleton skeleton = stand.take_skeletons(progress)[0];
    ASSERT_TRUE(check_skeleton(skeleton));
    PlainTree tree;
    for (int step = 1; step <= parameters.iterations && grow_step(tree, points, parameters, key, step); ++step) {
    }
    ASSERT_GT(skeleton.node_count(), 400U);
    ASSERT_EQ(skeleton.parent, tree.parent);
    for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
      ASSERT_LT(glm::distance(skeleton.position[node], tree.position[node]), 1e-5F) << "node " << node;
      ASSERT_EQ(skeleton.birth[node], static_cast<float>(tree.birth[node]));
    }
  }
}

}  // namespace
}  // namespace meristem
