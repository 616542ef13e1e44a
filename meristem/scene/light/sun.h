// SPDX-License-Identifier: Apache-2.0
// The position of the sun. Azimuth is measured from north over east, altitude from the horizon; north is -z, east +x,
// south +z. Times are true solar hours (the sun is highest at 12). Days of the year count from 1.
//
// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
// 2020, section 4.4, with sunrise and sunset in the right order and azimuths past noon mirrored.
#pragma once

#include <optional>
#include <utility>

#include "meristem/base/vec.h"

namespace meristem {

/// A position in the sky, radians.
struct SkyDirection {
  double azimuth = 0;   ///< from north (-z) over east (+x)
  double altitude = 0;  ///< above the horizon
};

/// Returns the sun's declination in radians on a day of the year.
double declination(double day);

/// Returns the position of the sun at `latitude` (radians, positive to the north) on `day` at `hour`. It is below the
/// horizon at night. Exactly overhead, where no azimuth is defined, the azimuth is south (north in the southern
/// hemisphere). At a pole, the azimuth is the limit of latitudes toward the pole: 180° at noon at the north pole,
/// turning by 15° per hour.
SkyDirection sun_position(double latitude, double day, double hour);
/// Returns the position of a sun with this declination (radians) at `latitude` at `hour`.
SkyDirection sun_at_hour(double latitude, double declination, double hour);

/// Returns the hours of sunrise and sunset. Returns nothing in the polar night and {0, 24} on the polar day.
std::optional<std::pair<double, double>> daylight(double latitude, double day);

/// Returns the unit vector toward a position in the sky with azimuth a and altitude h: (sin a cos h, sin h, -cos a cos
/// h).
Vec3 unit_vector(SkyDirection direction);
/// Returns the direction of a vector of any positive length. The azimuth is in [0, 2 pi), and 0 for vertical vectors.
SkyDirection sky_direction(Vec3 vector);

}  // namespace meristem
