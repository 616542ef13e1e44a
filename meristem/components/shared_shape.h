// SPDX-License-Identifier: Apache-2.0
// What shapes a mesh is rounded, so that many instances share it.
#pragma once

#include <cmath>

#include "meristem/base/math.h"
#include "meristem/base/vec.h"

namespace meristem {

inline constexpr double kShapeAngleStep = 5 * kPi / 180;

inline double to_step(double value, double step) { return std::floor(value / step + 0.5) * step; }

/// To so many steps an octave; `value` is above 0.
inline double to_octaves(double value, double steps) {
  static const double log_of_2 = math::log(2);
  return math::pow(2, to_step(math::log(value) / log_of_2, 1 / steps));
}

}  // namespace meristem
