// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "meristem/base/math.h"

namespace meristem {

/// A point of an arc in its own plane, where the arc begins at the origin, and the direction at this point above the
/// horizontal.
struct ArcPoint {
  double forward, up, angle;
};

/// Returns the point after `length` of an arc. The arc begins at `start_angle` above the horizontal and sinks by `turn`
/// radians until this point.
inline ArcPoint along_arc(double start_angle, double turn, double length) {
  constexpr double kStraight = 1e-6;  // radians; arcs that bend less are lines
  const double end_angle = start_angle - turn;
  if (std::abs(turn) < kStraight) {
    const double middle = 0.5 * (start_angle + end_angle);
    return {length * math::cos(middle), length * math::sin(middle), end_angle};
  }
  const double radius = length / turn;
  return {radius * (math::sin(start_angle) - math::sin(end_angle)),
          radius * (math::cos(end_angle) - math::cos(start_angle)), end_angle};
}

}  // namespace meristem
