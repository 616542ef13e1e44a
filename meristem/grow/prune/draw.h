// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "meristem/base/vec.h"

namespace meristem {

/// How a stretch of a shoot is drawn to a point: about an axis, and by an angle that is spread evenly over its
/// metamers.
struct Draw {
  Vec3 axis{0};
  double angle = 0;  ///< radians, of the last metamer
};

/// The least draw that brings the end of a stretch within `gap` metres of a point, or as near as it comes. `points` are
/// the stretch's, from its base to its end, at least two.
Draw draw_toward(std::span<const Vec3> points, Vec3 target, double gap);

}  // namespace meristem
