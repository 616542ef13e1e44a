// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "meristem/plant/skeleton.h"

namespace meristem {

inline constexpr float kThinnestTube = 1e-6F;  ///< metres: thinner tubes would have degenerate triangles

/// As normalized_or, but in floats: it is asked for a million times per tree.
inline Vec3 unit_or(Vec3 vector, Vec3 fallback) {
  const float square = glm::dot(vector, vector);
  return square > 1e-24F && square < 1e24F ? vector * (1 / std::sqrt(square)) : fallback;
}

/// The points of an axis from its start to its tip: its nodes, after the parent node if there is one.
struct AxisPath {
  const Skeleton* skeleton = nullptr;
  std::span<const float> radii;  ///< by node of the skeleton
  std::span<const NodeIndex> nodes;
  NodeIndex parent = kNoNode;
  float base_radius = 0;  ///< with which it begins

  bool is_lateral() const { return parent != kNoNode; }
  std::size_t size() const { return nodes.empty() ? 0 : nodes.size() + (is_lateral() ? 1 : 0); }
  /// The node at point i; 0 is the parent of a lateral axis.
  NodeIndex node(std::size_t i) const { return is_lateral() ? (i == 0 ? parent : nodes[i - 1]) : nodes[i]; }
  Vec3 position(std::size_t i) const { return skeleton->position[node(i)]; }
  float radius(std::size_t i) const { return std::max(i == 0 ? base_radius : radii[node(i)], kThinnestTube); }
  /// The direction from point i to the next, or `fallback` where they coincide.
  Vec3 direction(std::size_t i, Vec3 fallback) const { return unit_or(position(i + 1) - position(i), fallback); }
};

}  // namespace meristem
