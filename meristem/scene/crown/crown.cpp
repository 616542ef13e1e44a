// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/crown/crown.h"

#include <cmath>

namespace meristem {

namespace {

constexpr int kHalvings = 40;

/// The share of the way from a point outside to one inside at which the surface lies.
double share_outside(const Crown& crown, DVec3 outside, DVec3 inside) {
  double low = 0, high = 1;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (crown.contains(Vec3(outside + middle * (inside - outside))) ? high : low) = middle;
  }
  return high;
}

}  // namespace

double Crown::distance(Vec3 point) const {
  const Box box = bounds();
  const DVec3 middle(box.centre());
  const DVec3 away = DVec3(point) - middle;
  const double length = std::sqrt(squared_length(away));
  if (!contains(point)) return length * share_outside(*this, DVec3(point), middle);
  // From beyond the bounds back.
  const double size = std::sqrt(squared_length(DVec3(box.size())));
  const DVec3 beyond = DVec3(point) + (length > 0 ? size / length * away : DVec3(size, 0, 0));
  return -size * (1 - share_outside(*this, beyond, DVec3(point)));
}

}  // namespace meristem
