// SPDX-License-Identifier: Apache-2.0
// Where the sun stands. Azimuth from north over east, altitude from the horizon; north is -z, east +x, south +z. Times
// are true solar hours (the sun is highest at 12), days of the year count from 1.
//
// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
// 2020, section 4.4, with sunrise and sunset in the right order and azimuths past noon mirrored.
#pragma once

#include <optional>
#include <utility>

#include "meristem/base/vec.h"

namespace meristem {

/// A position on the sky, radians.
struct SkyDirection {
  double azimuth = 0;
  double altitude = 0;
};

/// The sun's declination (radians) on a day of the year.
double declination(double day);

/// Where the sun stands at `latitude` (radians, north positive) on `day` at `hour`; below the horizon at night. Exactly
/// overhead, where no azimuth is defined, it is south (north in the southern hemisphere). At a pole it is the limit of
/// latitudes toward it: 180° at noon at the north pole, and it turns by 15° per hour.
SkyDirection sun_position(double latitude, double day, double hour);
/// Where a sun of this declination (radians) stands at `latitude` at `hour`.
SkyDirection sun_at_hour(double latitude, double declination, double hour);

/// Hours of sunrise and sunset; nothing in the polar night, {0, 24} on the polar day.
std::optional<std::pair<double, double>> daylight(double latitude, double day);

/// The unit vector that points there, (sin a cos h, sin h, -cos a cos h).
Vec3 unit_vector(SkyDirection direction);
/// The direction of a vector of any positive length; azimuth in [0, 2 pi), 0 for vertical vectors.
SkyDirection sky_direction(Vec3 vector);

}  // namespace meristem
