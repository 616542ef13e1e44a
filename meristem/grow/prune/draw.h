// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "meristem/base/vec.h"

namespace meristem {

/// A bend that draws a section of a shoot to a point: a rotation about an axis, spread evenly over the metamers.
struct Draw {
  Vec3 axis{0};
  double angle = 0;  ///< total angle at the last metamer, radians
};

/// Returns the smallest bend that brings the end of a section within `gap` metres of a point, or as near as possible.
/// `points` are the section's points from base to end, at least two.
Draw draw_toward(std::span<const Vec3> points, Vec3 target, double gap);

}  // namespace meristem
