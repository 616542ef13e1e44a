// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace meristem {

/// Returns the vector from the nearest position on the segment between the origin and `along` to the point `away`.
inline glm::dvec2 from_segment(glm::dvec2 away, glm::dvec2 along) {
  const double squared = glm::dot(along, along);
  const double share = squared > 0 ? std::clamp(glm::dot(along, away) / squared, 0.0, 1.0) : 0;
  return away - share * along;
}

}  // namespace meristem
