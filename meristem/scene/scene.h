// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/scene/directions.h"
#include "meristem/scene/light/clock.h"
#include "meristem/scene/light/light.h"
#include "meristem/scene/light/sun.h"
#include "meristem/scene/obstacle/obstacles.h"

namespace meristem {

inline constexpr Vec3 kGroundColour{0.50F, 0.54F, 0.37F};  ///< sRGB, of the ground in pictures unless named

/// What surrounds plants and what they perceive. Growth models ask it and test nothing on their own.
struct Scene {
  Light light;                         ///< that plants grow in
  Obstacles obstacles;                 ///< that shade them and that they do not enter
  SkyDirection sun{0, kPi / 2};        ///< in pictures; unless named, in the zenith
  Vec3 ground_colour = kGroundColour;  ///< sRGB
  std::optional<double> latitude{};    ///< radians, north positive, if it is known
  std::optional<ClockZone> clock{};    ///< where the sun is given by a clock
  /// Hash of all that it was made of, if that is known: what grew in a scene with the same one need not grow again.
  std::optional<std::uint64_t> fingerprint{};
  std::map<std::string, std::vector<Vec3>> supports{};  ///< lines by name that shoots may be tied to, metres

  /// Which ways plants feel in it. To be asked once, and then at every position.
  Directions directions() const { return Directions(light, sun); }
};

}  // namespace meristem
