// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "meristem/plant/skeleton.h"

namespace meristem {

inline constexpr float kThinnestTube = 1e-6F;  ///< metres; thinner tubes would have degenerate triangles

/// Like normalized_or, but in floats, because it is called a million times per tree.
inline Vec3 unit_or(Vec3 vector, Vec3 fallback) {
  const float square = glm::dot(vector, vector);
  return square > 1e-24F && square < 1e24F ? vector * (1 / std::sqrt(square)) : fallback;
}

/// The points of an axis from its start to its tip: the parent node if there is one, then its nodes.
struct AxisPath {
  const Skeleton* skeleton = nullptr;
  std::span<const float> radii;  ///< indexed by node of the skeleton
  std::span<const NodeIndex> nodes;
  NodeIndex parent = kNoNode;
  float base_radius = 0;  ///< radius at the start

  bool is_lateral() const { return parent != kNoNode; }
  std::size_t size() const { return nodes.empty() ? 0 : nodes.size() + (is_lateral() ? 1 : 0); }
  /// Returns the node at point i. Point 0 of a lateral axis is the parent.
  NodeIndex node(std::size_t i) const { return is_lateral() ? (i == 0 ? parent : nodes[i - 1]) : nodes[i]; }
  Vec3 position(std::size_t i) const { return skeleton->position[node(i)]; }
  float radius(std::size_t i) const { return std::max(i == 0 ? base_radius : radii[node(i)], kThinnestTube); }
  /// Returns the direction from point i to the next, or `fallback` if they coincide.
  Vec3 direction(std::size_t i, Vec3 fallback) const { return unit_or(position(i + 1) - position(i), fallback); }
};

}  // namespace meristem
