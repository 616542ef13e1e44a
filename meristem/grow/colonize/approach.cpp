// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/approach.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meristem {
std::optional<Vec3> nearest_of(std::span<const Vec3> points, Vec3 root) {
  std::optional<Vec3> nearest;
  double min2 = std::numeric_limits<double>::infinity();
  for (const Vec3 point : points) {
    const double distance2 = squared_length(DVec3(point) - DVec3(root));
    if (distance2 >= min2) continue;
    min2 = distance2;
    nearest = point;
  }
  return nearest;
}

Approach plan_approach(Vec3 target, double step, double influence) {
  Approach approach;
  approach.distance = std::sqrt(squared_length(target));
  if (approach.distance > 0) approach.direction = DVec3(target) / approach.distance;
  if (approach.distance <= influence) return approach;
  const double steps = std::ceil((approach.distance - influence) / step);
  // Larger numbers are beyond any limit on iterations, so clamp before the conversion.
  approach.steps = static_cast<std::uint64_t>(std::min(steps, 1e15));
  return approach;
}

}  // namespace meristem
