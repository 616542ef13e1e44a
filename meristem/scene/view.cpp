// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/view.h"

#include <cmath>

#include "meristem/base/frame.h"

namespace meristem {

std::optional<CameraView> seen_from(CameraView view, double azimuth_deg, double altitude_deg) {
  const bool is_known = std::abs(azimuth_deg) <= 360 && std::abs(altitude_deg) <= 89;  // false for NaN
  if (!is_known) return std::nullopt;
  view.position.reset();
  view.azimuth = radians(azimuth_deg);
  view.altitude = radians(altitude_deg);
  return view;
}

CameraView turned(CameraView view, Vec3 middle, double angle) {
  view.azimuth += angle;
  // Azimuths run clockwise seen from above; rotations about the upward axis run counter-clockwise.
  const Vec3 centre = view.target.value_or(middle);
  if (view.position) view.position = centre + rotation(kUp, -angle) * (*view.position - centre);
  return view;
}

}  // namespace meristem
