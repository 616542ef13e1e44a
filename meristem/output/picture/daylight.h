// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/base/vec.h"
#include "meristem/scene/light/sky.h"

namespace meristem {

/// The light that a path tracer asks for millions of times: the sun's disc, and the dome in a table over the upper half
/// of the octahedron that a direction points at, linear between entries.
class Daylight {
 public:
  /// The sun and dome of `sky`, above ground of this (linear) colour, which the sun and dome light evenly.
  Daylight(const Sky& sky, Vec3 ground_colour);
  /// A dome alone, with the same light from below as `below`.
  Daylight(FunctionRef<Vec3(Vec3 direction)> dome, Vec3 below);

  /// What is seen in a direction: the dome; below the horizon, the horizon.
  Vec3 seen(Vec3 direction) const { return looked_up(seen_, direction); }
  /// What lights surfaces from a direction: the dome, or the ground below the horizon. As a camera set between sun and
  /// shade sees it: paler than the dome itself, so that shade is not blue.
  Vec3 falling(Vec3 direction) const { return direction.y < 0 ? below_ : looked_up(falling_, direction); }
  Vec3 below() const { return below_; }

  Vec3 sun_direction() const { return sun_direction_; }
  Vec3 sun_irradiance() const { return sun_irradiance_; }
  double sun_angular_radius() const { return sun_angular_radius_; }
  bool has_sun() const { return sun_irradiance_ != Vec3(0); }

 private:
  static std::vector<Vec3> tabulated(FunctionRef<Vec3(Vec3)> dome);
  static Vec3 looked_up(const std::vector<Vec3>& table, Vec3 direction);

  std::vector<Vec3> seen_;
  std::vector<Vec3> falling_;
  Vec3 below_;
  Vec3 sun_direction_ = kUp;
  Vec3 sun_irradiance_{0};
  double sun_angular_radius_ = 0;
};

}  // namespace meristem
