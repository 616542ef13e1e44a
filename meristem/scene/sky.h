// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"
#include "meristem/scene/sun.h"

namespace meristem {

/// The light of a clear or hazy day: a sun disc and a sky dome with smooth colour from zenith to horizon, brighter about
/// the sun; linear RGB radiance in relative units, such that a white matt surface facing the sun at 45° comes out near 1.
class Sky {
 public:
  /// `sun` may stand below the horizon: then only a dim dome is left.
  explicit Sky(SkyDirection sun);

  Vec3 radiance(Vec3 direction) const;  ///< of the dome, without the disc; below the horizon the horizon's
  Vec3 sun_direction() const { return sun_direction_; }
  Vec3 sun_irradiance() const { return sun_irradiance_; }  ///< on a surface facing the sun
  double sun_angular_radius() const { return sun_angular_radius_; }  ///< radians; the real one is 0.0047

 private:
  Vec3 sun_direction_;
  Vec3 sun_irradiance_;
  double sun_angular_radius_ = 0.012;  // a little hazy: softer shadows than the true 0.0047
};

}  // namespace meristem
