// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/approach.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meristem {

Approach plan_approach(const std::vector<Vec3>& points, double step, double influence) {
  Approach approach;
  double nearest2 = std::numeric_limits<double>::infinity();
  for (const Vec3 point : points) {
    const DVec3 place(point);
    const double distance2 = glm::dot(place, place);
    if (distance2 >= nearest2) continue;
    nearest2 = distance2;
    approach.direction = place;
  }
  approach.distance = std::sqrt(nearest2);
  if (approach.distance <= influence) return approach;
  approach.direction /= approach.distance;
  const double steps = std::ceil((approach.distance - influence) / step);
  // Beyond any limit on iterations the exact number says nothing more.
  approach.steps = static_cast<std::uint64_t>(std::min(steps, 1e15));
  return approach;
}

}  // namespace meristem
