// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "meristem/base/vec.h"

namespace meristem {

/// The straight stem from a root toward a point that lies beyond its influence distance.
struct Approach {
  DVec3 direction{0, 1, 0};  ///< unit vector to the point
  double distance = 0;       ///< metres to it
  std::uint64_t steps = 0;   ///< nodes after which it is within the influence distance
};

/// The nearest of `points` to `root`; of equally near ones that with the lowest index. Nothing without points.
std::optional<Vec3> nearest_of(std::span<const Vec3> points, Vec3 root);

/// `target` is relative to the root; `step` and `influence` in metres.
Approach plan_approach(Vec3 target, double step, double influence);

}  // namespace meristem
