// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

/// The straight stem from a root at the origin to a cloud that lies beyond its influence distance.
struct Approach {
  DVec3 direction{0, 1,
                  0};   ///< unit vector to the nearest point; of equally near ones, to the one with the lowest index
  double distance = 0;  ///< metres to that point
  std::uint64_t steps = 0;  ///< nodes after which that point is within the influence distance
};

/// `points` is not empty and relative to the root; `step` and `influence` in metres.
Approach plan_approach(const std::vector<Vec3>& points, double step, double influence);

}  // namespace meristem
