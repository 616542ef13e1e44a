// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "meristem/base/vec.h"

namespace meristem {

/// The camera of a picture. Unset values are chosen so that the whole plant is visible.
struct CameraView {
  std::optional<Vec3> position;    ///< position of the camera, metres
  std::optional<Vec3> target;      ///< point that the camera looks at, metres; default: the centre of the plant
  double azimuth = 2.6;            ///< azimuth of the camera seen from the target, if `position` is unset; radians
  double altitude = 0.1;           ///< altitude of the camera above the horizon seen from the target, radians
  double field_of_view = 0.6;      ///< vertical, radians; larger: wider and more perspective
  std::optional<Vec3> background;  ///< sRGB; default: the sky
  std::optional<double> haze;      ///< metres over which haze hides two thirds of the scene; unset: no haze
  double roll = 0;                 ///< turn of the camera about its line of sight, radians; the picture turns clockwise
  double clouds = 0;               ///< share of the visible sky that clouds cover
};

/// The ranges of angles that seen_from() accepts, in words for messages.
inline constexpr std::string_view kKnownSides = "an azimuth from -360 to 360 and an altitude from -89 to 89 degrees";

/// Returns the view from another side, at a distance that shows the whole plant. The azimuth is -360 to 360 degrees,
/// from north over east; the altitude over the horizon is -89 to 89 degrees. Both are seen from the target. Returns
/// nothing for other angles.
std::optional<CameraView> seen_from(CameraView view, double azimuth_deg, double altitude_deg);

/// Returns the view with the camera rotated about the vertical through its target (`middle` if it has no target).
/// `angle` is in radians, from north over east. A full turn in equal steps shows the plant from every side.
CameraView turned(CameraView view, Vec3 middle, double angle);

}  // namespace meristem
