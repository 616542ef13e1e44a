// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "meristem/base/vec.h"

namespace meristem {

/// From where and how the scene is seen. What is unset is chosen so that the whole plant is in the picture.
struct View {
  std::optional<Vec3> position;    ///< position of the camera, metres
  std::optional<Vec3> target;      ///< what it looks at, metres; the middle of the plant
  double azimuth = 2.6;            ///< azimuth of the camera as seen from the target where it has no position; radians
  double altitude = 0.1;           ///< altitude of the camera over the horizon as seen from the target, radians
  double field_of_view = 0.6;      ///< vertical, radians; larger: wider and more perspective
  std::optional<Vec3> background;  ///< sRGB; the sky if unset
  std::optional<double> haze;      ///< metres over which haze hides two thirds of what is seen; unset: none
  double clouds = 0;               ///< share of the sky that clouds cover, where it is seen
};

/// The sides that seen_from knows, in words for messages.
inline constexpr std::string_view kKnownSides = "an azimuth from -360 to 360 and an altitude from -89 to 89 degrees";

/// The view from another side: from an azimuth (-360 to 360 degrees, from north over east) and an altitude over the
/// horizon (-89 to 89 degrees), both as seen from the target, and as far away as shows the whole plant. Nothing for
/// other angles.
std::optional<View> seen_from(View view, double azimuth_deg, double altitude_deg);

/// The view with the camera moved on around the vertical through its target (`middle` where it has none), by an angle
/// in radians from north over east. Turning it all around in equal steps shows the plant from every side.
View turned(View view, Vec3 middle, double angle);

}  // namespace meristem
