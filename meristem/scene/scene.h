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

inline constexpr Vec3 kGroundColour{0.50F, 0.54F, 0.37F};  ///< default colour of the ground in pictures, sRGB

/// The surroundings of plants: light, obstacles and supports. Growth models query it and make no tests of their own.
struct Scene {
  Light light;                         ///< light that plants grow in
  Obstacles obstacles;                 ///< bodies that shade plants and that plants do not enter
  SkyDirection sun{0, kPi / 2};        ///< sun in pictures; default: at the zenith
  Vec3 ground_colour = kGroundColour;  ///< sRGB
  std::optional<double> latitude{};    ///< radians, positive to the north, if known
  std::optional<ClockZone> clock{};    ///< set if a clock defines the sun
  /// Hash of all inputs of the scene, if known. Growth in scenes with equal fingerprints can be reused.
  std::optional<std::uint64_t> fingerprint{};
  std::map<std::string, std::vector<Vec3>> supports{};  ///< named lines that shoots may be tied to, metres

  /// Returns the directions that plants perceive. Call it once, and then query it at every position.
  Directions directions() const { return Directions(light, sun); }
};

}  // namespace meristem
