// SPDX-License-Identifier: Apache-2.0
// The light of a clear, slightly hazy day. The brightness of sun and dome follows measured daylight. The distribution
// of brightness over the dome follows the standard clear sky. Sunlight gets its colour from the way through the air.
// The colours of the dome are an artistic gradient with the same brightness. Limit: scattering is not simulated.
//
// Based on: CIE S 011/E:2003, Spatial distribution of daylight (type 12, clear); IESNA Lighting Handbook, 9th edition,
// daylight availability (direct and diffuse illuminance of a clear day); F. Kasten and A. T. Young: Revised optical air
// mass tables (1989).
#pragma once

#include "meristem/base/vec.h"
#include "meristem/scene/light/sun.h"

namespace meristem {

/// A sun disc and a sky dome with smooth colours from zenith to horizon, brighter around the sun. Radiance is linear
/// RGB in relative units: a white matt surface facing the sun at 45° has a radiance of about 1.
class Sky {
 public:
  /// `sun` may be below the horizon; then only a dim dome is left.
  explicit Sky(SkyDirection sun);

  Vec3 radiance(Vec3 direction) const;  ///< radiance of the dome without the sun's disc; constant below the horizon
  Vec3 sun_direction() const { return sun_direction_; }              ///< unit vector toward the sun
  Vec3 sun_irradiance() const { return sun_irradiance_; }            ///< on a surface facing the sun
  double sun_angular_radius() const { return sun_angular_radius_; }  ///< radians; the real value is 0.0047
  /// Returns the irradiance of the dome on level ground, without the sun.
  Vec3 dome_irradiance() const { return dome_irradiance_; }

 private:
  Vec3 relative_radiance(Vec3 direction) const;

  Vec3 sun_direction_;
  Vec3 sun_irradiance_;
  Vec3 sun_tint_;  // colour of sunlight after its way through the air, with luminance 1
  Vec3 dome_irradiance_;
  float scale_ = 1;                    // factor from relative to true radiance
  float warmth_ = 0;                   // 0 by day, 1 with the sun on the horizon
  double sun_angular_radius_ = 0.012;  // larger than the true 0.0047: haze, and softer shadows
};

}  // namespace meristem
