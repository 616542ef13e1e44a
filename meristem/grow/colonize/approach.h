// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "meristem/base/vec.h"

namespace meristem {

/// The straight stem from a root toward a point beyond its influence distance.
struct Approach {
  DVec3 direction{0, 1, 0};  ///< unit vector to the point
  double distance = 0;       ///< distance to the point, metres
  std::uint64_t steps = 0;   ///< number of nodes until the point is within the influence distance
};

/// Returns the point nearest to `root` (tie: the lowest index), or nothing for an empty list.
std::optional<Vec3> nearest_of(std::span<const Vec3> points, Vec3 root);

/// Plans the straight stem. `target` is relative to the root; `step` and `influence` are in metres.
Approach plan_approach(Vec3 target, double step, double influence);

}  // namespace meristem
