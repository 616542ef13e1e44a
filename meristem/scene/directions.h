// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "meristem/base/vec.h"

namespace meristem {

/// Which ways a plant feels at a position: toward the light, and down. Whatever turns by light or gravity asks here, at
/// the position where it turns. They are the same everywhere, so asking costs nothing; what shares a result between
/// positions goes by key_at all the same.
class Directions {
 public:
  Directions() = default;  ///< light from the zenith
  /// Unit vectors.
  explicit Directions(Vec3 toward_light, Vec3 down = -kUp) : toward_light_(toward_light), down_(down) {}

  Vec3 toward_light(Vec3) const { return toward_light_; }  ///< unit vector
  Vec3 down(Vec3) const { return down_; }                  ///< unit vector, the way gravity pulls
  /// Equal for positions about which both are the same.
  std::uint64_t key_at(Vec3 position) const;

 private:
  Vec3 toward_light_ = kUp;
  Vec3 down_ = -kUp;
};

}  // namespace meristem
