// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/prune/support_line.h"

#include <algorithm>
#include <limits>

#include "meristem/base/frame.h"

namespace meristem {

Vec3 way_along(std::span<const Vec3> line, Vec3 tip, float ahead) {
  // Find the nearest point of the line.
  std::size_t nearest = 0;
  float along = 0;
  float best = std::numeric_limits<float>::max();
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec3 segment = line[k + 1] - line[k];
    const float square = squared_length(segment);
    if (square == 0) continue;
    const bool is_last = k + 2 == line.size();
    const float share =
        std::clamp(glm::dot(tip - line[k], segment) / square, 0.0F, is_last ? std::numeric_limits<float>::max() : 1.0F);
    const float distance = squared_length(line[k] + share * segment - tip);
    if (distance >= best) continue;
    best = distance;
    nearest = k;
    along = share;
  }
  // Move ahead from this point.
  float left = ahead;
  for (std::size_t k = nearest; k + 1 < line.size(); ++k) {
    const Vec3 segment = line[k + 1] - line[k];
    const float length = glm::length(segment);
    const float begin = k == nearest ? along * length : 0;
    const bool is_last = k + 2 == line.size();
    if (!is_last && begin + left > length) {
      left -= length - begin;
      continue;
    }
    const Vec3 way = normalized_or(segment, kUp);
    return normalized_or(line[k] + (begin + left) * way - tip, way);
  }
  return kUp;
}

}  // namespace meristem
