// SPDX-License-Identifier: Apache-2.0
// What shapes a mesh is rounded where it varies from instance to instance, so that many of them share it. A number that
// all instances have in common makes no more meshes, and stays as it is.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "meristem/base/math.h"
#include "meristem/base/vec.h"
#include "meristem/graph/emitter.h"

namespace meristem {

inline constexpr double kShapeAngleStep = 5 * kPi / 180;

/// Whether a member of a component's struct differs from instance to instance.
template <class Parameters, class Member>
bool varies(const Emitter& out, const Parameters& parameters, const Member& member) {
  const auto place = [](const auto& object) { return reinterpret_cast<const std::byte*>(&object); };
  return out.varies(static_cast<std::size_t>(place(member) - place(parameters)));
}

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

/// Rounds to this number of steps per octave; `value` is above 0.
inline double to_octaves(double value, double steps) {
  static const double log_of_2 = math::log(2);
  return power_of_2(to_step(math::log(value) / log_of_2, 1 / steps));
}

}  // namespace meristem
