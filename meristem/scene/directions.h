// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/scene/light/light.h"

namespace meristem {

/// Which ways a plant feels at a position: toward the light, and down. Whatever turns by light or gravity asks here, at
/// the position where it turns. Without lamps both are the same everywhere, and asking costs nothing; what shares a
/// result between positions goes by key_at all the same.
class Directions {
 public:
  Directions() = default;  ///< light from the zenith
  /// Unit vectors.
  explicit Directions(Vec3 toward_light, Vec3 down = -kUp) : toward_light_(toward_light), down_(down) {}
  /// Toward the middle of the sun's positions, each by its strength; where the sun gives no light (under a sky without
  /// a sun) toward the one in pictures, `shown`, and up where that is below the horizon, as all light comes from the
  /// sky then. Lamps pull as strongly as they shine, against the strength of all directional light.
  Directions(const Light& light, SkyDirection shown);

  Vec3 toward_light(Vec3 position) const { return lamps_ == nullptr ? toward_light_ : toward_all(position); }
  Vec3 down(Vec3) const { return down_; }  ///< unit vector, the way gravity pulls
  /// Equal for positions about which both are the same.
  std::uint64_t key_at(Vec3 position) const;

 private:
  Vec3 toward_all(Vec3 position) const;

  Vec3 toward_light_ = kUp;  // direction to the directional light
  Vec3 down_ = -kUp;
  double directional_strength_ = 0;
  std::shared_ptr<const std::vector<Lamp>> lamps_;  // null where there are none
};

}  // namespace meristem
