// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/crown/crown.h"

#include <algorithm>
#include <cmath>

namespace meristem {

namespace {

constexpr float kStepsAcross = 64;  // of the crown's size, in which it is asked along a way
constexpr int kHalvings = 16;

}  // namespace

bool is_endless(const Crown& crown) {
  const Vec3 size = crown.bounds().size();
  return std::max({size.x, size.y, size.z}) >= kEndlessReach;
}

float Crown::reach(Vec3 from, Vec3 to) const {
  if (!contains(from)) return 0;
  int steps = 1;
  if (!is_convex()) {
    const Vec3 size = bounds().size();
    const float step = std::max({size.x, size.y, size.z}) / kStepsAcross;
    steps = static_cast<int>(std::clamp(std::ceil(glm::distance(from, to) / step), 1.0F, kStepsAcross));
  }
  float inside = 0;
  for (int k = 1; k <= steps; ++k) {
    float share = static_cast<float>(k) / static_cast<float>(steps);
    if (contains(glm::mix(from, to, share))) {
      inside = share;
      continue;
    }
    for (int halving = 0; halving < kHalvings; ++halving) {
      const float middle = 0.5F * (inside + share);
      (contains(glm::mix(from, to, middle)) ? inside : share) = middle;
    }
    return inside;
  }
  return 1;
}

}  // namespace meristem
