// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace meristem {

/// Returns the squared distance of `point` from the segment between `from` and `to`.
inline double squared_distance_to_line(glm::dvec2 point, glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec2 way = to - from;
  const double squared = glm::dot(way, way);
  const double share = squared > 0 ? std::clamp(glm::dot(point - from, way) / squared, 0.0, 1.0) : 0;
  const glm::dvec2 away = point - (from + share * way);
  return glm::dot(away, away);
}

}  // namespace meristem
