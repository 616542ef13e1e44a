// SPDX-License-Identifier: Apache-2.0
// The light of a clear, slightly hazy day. How bright sun and dome are follows measured daylight; how brightness
// spreads over the dome follows the standard clear sky; colours come from the sunlight's way through the air and are,
// for the dome, a painter's gradient that keeps that brightness. Not a simulation of scattering.
//
// Based on: CIE S 011/E:2003, Spatial distribution of daylight (type 12, clear); IESNA Lighting Handbook, 9th edition,
// daylight availability (direct and diffuse illuminance of a clear day); F. Kasten and A. T. Young: Revised optical air
// mass tables (1989).
#pragma once

#include "meristem/base/vec.h"
#include "meristem/scene/light/sun.h"

namespace meristem {

/// A sun disc and a sky dome with smooth colour from zenith to horizon, brighter about the sun; linear RGB radiance in
/// relative units, such that a white matt surface facing the sun at 45° comes out near 1.
class Sky {
 public:
  /// `sun` may stand below the horizon: then only a dim dome is left.
  explicit Sky(SkyDirection sun);

  Vec3 radiance(
      Vec3 direction) const;  ///< radiance of the dome without the sun's disc; below the horizon, the horizon's
  Vec3 sun_direction() const { return sun_direction_; }
  Vec3 sun_irradiance() const { return sun_irradiance_; }            ///< on a surface facing the sun
  double sun_angular_radius() const { return sun_angular_radius_; }  ///< radians; the real one is 0.0047
  /// The irradiance of the dome on level ground, without the sun.
  Vec3 dome_irradiance() const { return dome_irradiance_; }

 private:
  Vec3 relative_radiance(Vec3 direction) const;

  Vec3 sun_direction_;
  Vec3 sun_irradiance_;
  Vec3 sun_tint_;  // tint of light that comes through the air from where the sun stands; luminance 1
  Vec3 dome_irradiance_;
  float scale_ = 1;                    // from relative to true radiance
  float warmth_ = 0;                   // 0 by day, 1 with the sun on the horizon
  double sun_angular_radius_ = 0.012;  // a little hazy: softer shadows than the true 0.0047
};

}  // namespace meristem
