// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/grow/colonize/child_positions.h"
#include "meristem/grow/colonize/colonize.h"
#include "meristem/grow/colonize/growth_direction.h"

namespace meristem {

/// The living points of a simple colonizer.
struct PlainPoints {
  std::vector<Vec3> position;
  std::vector<NodeIndex> nearest;  ///< kNoNode before the first round
  std::vector<float> distance2;    ///< squared distance to the nearest node
};

inline float plain_distance2(Vec3 a, Vec3 b) { return squared_length(a - b); }

/// Space colonization in its simplest form: one tree from the origin, a test of all points in every step, and no
/// finishing. `find_nearest(nodes, first_new, points)` updates the nearest node of each point; it already knows nodes
/// before `first_new`. Points must be within the influence distance of the root.
template <class FindNearest>
Skeleton grow_plainly(const std::vector<Vec3>& cloud, const ColonizeParameters& parameters, RandomKey key,
                      FindNearest find_nearest) {
  constexpr double kUnit = 274'877'906'944;  // sums of whole numbers do not depend on the order
  constexpr int kMaxTurns = 4;
  PlainPoints points{cloud, std::vector<NodeIndex>(cloud.size(), kNoNode),
                     std::vector<float>(cloud.size(), std::numeric_limits<float>::infinity())};
  const auto influence = static_cast<float>(parameters.influence);
  const auto kill = static_cast<float>(parameters.kill);
  Skeleton tree;
  ChildPositions places(parameters.step);
  std::vector<int> turns;
  const auto add_node = [&](NodeIndex parent, Vec3 position, int birth) {
    tree.add_node(parent, position, static_cast<float>(birth));
    places.add_node(parent);
    turns.push_back(0);
  };
  struct Sum {
    bool any = false;
    std::int64_t x = 0, y = 0, z = 0;
  };
  std::vector<Sum> sums;
  add_node(kNoNode, Vec3(0), 0);
  NodeIndex first_new = 0;
  for (int step = 1; step <= parameters.iterations; ++step) {
    find_nearest(tree.position, first_new, points);
    first_new = static_cast<NodeIndex>(tree.node_count());
    // Use up points, except in the first step, and add the pulls of the others.
    sums.assign(tree.node_count(), Sum());
    std::size_t left = 0;
    for (std::size_t k = 0; k < points.position.size(); ++k) {
      const NodeIndex node = points.nearest[k];
      if (step > 1 && points.distance2[k] <= kill * kill) continue;
      points.position[left] = points.position[k];
      points.nearest[left] = node;
      points.distance2[left++] = points.distance2[k];
      if (node == kNoNode || points.distance2[k] > influence * influence) continue;
      sums[node].any = true;
      const DVec3 offset = DVec3(points.position[k]) - DVec3(tree.position[node]);
      const double length2 = squared_length(offset);
      if (length2 == 0) continue;
      const double scale = 1 / std::sqrt(length2);
      sums[node].x += static_cast<std::int64_t>(offset.x * scale * kUnit);
      sums[node].y += static_cast<std::int64_t>(offset.y * scale * kUnit);
      sums[node].z += static_cast<std::int64_t>(offset.z * scale * kUnit);
    }
    points.position.resize(left);
    points.nearest.resize(left);
    points.distance2.resize(left);
    // Grow a child at each pulled node.
    bool any = false;
    for (NodeIndex node = 0; node < first_new; ++node) {
      if (!sums[node].any) continue;
      any = true;
      const DVec3 sum(static_cast<double>(sums[node].x) / kUnit, static_cast<double>(sums[node].y) / kUnit,
                      static_cast<double>(sums[node].z) / kUnit);
      const DVec3 from(tree.position[node]);
      const std::optional<DVec3> direction = growth_direction(sum, parameters.bias);
      Vec3 point(0);
      bool is_placed = false;
      if (direction) {
        point = Vec3(from + parameters.step * *direction);
        is_placed = places.is_free(tree, node, point);
      }
      if (!is_placed && turns[node] < kMaxTurns) {
        const int turn = ++turns[node];
        const DVec3 random(key.child(node).direction(static_cast<std::uint64_t>(turn)));
        const DVec3 turned = direction.value_or(DVec3(0)) + 1.0 * turn * random;
        point = Vec3(from + parameters.step / std::sqrt(glm::dot(turned, turned)) * turned);
        is_placed = places.is_free(tree, node, point);
      }
      if (is_placed) add_node(node, point, step);
    }
    if (!any || tree.node_count() == first_new) break;
  }
  return tree;
}

}  // namespace meristem
