// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/crown/crown.h"

#include <algorithm>
#include <cmath>

namespace meristem {

namespace {

constexpr float kStepsAcross = 64;  // tests per crown size along a straight way
constexpr int kReachHalvings = 16;
constexpr int kDistanceHalvings = 40;

/// Returns the position of the surface as a share of the way from a point outside to a point inside.
double share_outside(const Crown& crown, DVec3 outside, DVec3 inside) {
  double low = 0, high = 1;
  for (int k = 0; k < kDistanceHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (crown.contains(Vec3(outside + middle * (inside - outside))) ? high : low) = middle;
  }
  return high;
}

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
    for (int halving = 0; halving < kReachHalvings; ++halving) {
      const float middle = 0.5F * (inside + share);
      (contains(glm::mix(from, to, middle)) ? inside : share) = middle;
    }
    return inside;
  }
  return 1;
}

double Crown::distance(Vec3 point) const {
  const Box box = bounds();
  const DVec3 middle(box.centre());
  const DVec3 away = DVec3(point) - middle;
  const double length = std::sqrt(squared_length(away));
  if (!contains(point)) return length * share_outside(*this, DVec3(point), middle);
  // Search the surface from a point beyond the bounds.
  const double size = std::sqrt(squared_length(DVec3(box.size())));
  const DVec3 beyond = DVec3(point) + (length > 0 ? size / length * away : DVec3(size, 0, 0));
  return -size * (1 - share_outside(*this, beyond, DVec3(point)));
}

}  // namespace meristem
