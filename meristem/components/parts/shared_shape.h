// SPDX-License-Identifier: Apache-2.0
// What shapes a mesh is rounded, so that many instances share it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "meristem/base/math.h"
#include "meristem/base/vec.h"

namespace meristem {

inline constexpr double kShapeAngleStep = 5 * kPi / 180;

inline double to_step(double value, double step) { return std::floor(value / step + 0.5) * step; }

/// 2 to the power of `exponent`. Most shapes are rounded to eighths of an octave, whose powers are looked up: to
/// compute them took a tenth of the time of a crown of leaves.
inline double power_of_2(double exponent) {
  constexpr int kMost = 32;
  static const std::array<double, 16 * kMost + 1> powers = [] {
    std::array<double, 16 * kMost + 1> made{};
    for (int k = 0; k < 16 * kMost + 1; ++k) made[static_cast<std::size_t>(k)] = math::pow(2, k / 8.0 - kMost);
    return made;
  }();
  const double place = 8 * (exponent + kMost);
  const bool is_there = place >= 0 && place <= 16 * kMost && place == std::floor(place);
  return is_there ? powers[static_cast<std::size_t>(place)] : math::pow(2, exponent);
}

/// To so many steps per octave; `value` is above 0.
inline double to_octaves(double value, double steps) {
  static const double log_of_2 = math::log(2);
  return power_of_2(to_step(math::log(value) / log_of_2, 1 / steps));
}

}  // namespace meristem
