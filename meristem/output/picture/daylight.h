// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/base/vec.h"
#include "meristem/scene/light/sky.h"

namespace meristem {

/// Light from the sun and the sky, for millions of lookups by a path tracer. The dome is stored in a table over the
/// upper half of the octahedron of directions, linear between entries.
class Daylight {
 public:
  /// The sun and dome of `sky`. The ground has this (linear) colour and is lit evenly by them.
  Daylight(const Sky& sky, Vec3 ground_colour);
  /// A dome without a sun. `below` is the light from all directions below.
  Daylight(FunctionRef<Vec3(Vec3 direction)> dome, Vec3 below);

  /// Returns the visible light from a direction: the dome, or the horizon for directions below it.
  Vec3 seen(Vec3 direction) const { return looked_up(seen_, direction); }
  /// Returns the light that falls on surfaces from a direction: the dome, or the ground below the horizon. The light is
  /// paler than the visible dome, like a camera balanced between sun and shade, so that shade is not blue.
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
