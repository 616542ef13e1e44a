// SPDX-License-Identifier: Apache-2.0
// Rounding of shape parameters that vary between instances, so that many instances share a mesh. Parameters that are
// equal for all instances stay exact.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "meristem/base/math.h"
#include "meristem/base/vec.h"

namespace meristem {

inline constexpr double kShapeAngleStep = 5 * kPi / 180;

inline double to_step(double value, double step) { return std::floor(value / step + 0.5) * step; }

/// Returns 2 to the power of `exponent`. Multiples of 1/8 are looked up in a table, because computing them took a tenth
/// of the time of a crown of leaves.
inline double power_of_2(double exponent) {
  constexpr int kMax = 32;
  static const std::array<double, 16 * kMax + 1> powers = [] {
    std::array<double, 16 * kMax + 1> made{};
    for (int k = 0; k < 16 * kMax + 1; ++k) made[static_cast<std::size_t>(k)] = math::pow(2, k / 8.0 - kMax);
    return made;
  }();
  const double place = 8 * (exponent + kMax);
  const bool is_there = place >= 0 && place <= 16 * kMax && place == std::floor(place);
  return is_there ? powers[static_cast<std::size_t>(place)] : math::pow(2, exponent);
}

/// Rounds to this number of steps per octave. `value` must be above 0.
inline double to_octaves(double value, double steps) {
  static const double log_of_2 = math::log(2);
  return power_of_2(to_step(math::log(value) / log_of_2, 1 / steps));
}

}  // namespace meristem
