// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/random.h"
#include "meristem/base/vec.h"

namespace meristem {

/// A layer of clouds far above, as it is seen from below.
class Clouds {
 public:
  /// No clouds.
  Clouds() = default;
  /// Clouds that cover a share of the sky. They are `lit` toward the sun and `shaded` away from it (linear radiance).
  Clouds(double share, Vec3 sun_direction, Vec3 lit, Vec3 shaded);

  /// What is seen in a direction, where the sky behind is `sky`. Toward the horizon clouds vanish in the air.
  Vec3 over(Vec3 direction, Vec3 sky) const;

 private:
  double thickness(double x, double z) const;

  double share_ = 0;
  double to_sun_x_ = 0, to_sun_z_ = 0;  // metres toward the sun in the layer at which its shade is looked for
  Vec3 lit_{0};
  Vec3 shaded_{0};
};

}  // namespace meristem
