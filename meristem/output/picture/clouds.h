// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/random.h"
#include "meristem/base/vec.h"

namespace meristem {

/// A layer of clouds far above, as seen from below.
class Clouds {
 public:
  /// No clouds.
  Clouds() = default;
  /// Clouds that cover `share` of the sky. `lit` and `shaded` are their linear radiance toward the sun and away from
  /// it.
  Clouds(double share, Vec3 sun_direction, Vec3 lit, Vec3 shaded);

  /// Returns the light from a direction, where `sky` is the light of the sky behind the clouds. Toward the horizon,
  /// clouds vanish in the haze.
  Vec3 over(Vec3 direction, Vec3 sky) const;

 private:
  double thickness(double x, double z) const;

  double share_ = 0;
  double to_sun_x_ = 0, to_sun_z_ = 0;  // distance toward the sun in the layer, in metres, at which the shading is
                                        // sampled
  Vec3 lit_{0};
  Vec3 shaded_{0};
};

}  // namespace meristem
