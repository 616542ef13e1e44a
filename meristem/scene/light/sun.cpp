// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/light/sun.h"

#include <cmath>

#include "meristem/base/math.h"

namespace meristem {
namespace {

// Returns the direction to the sun: x east, y up, z south.
DVec3 sun_vector(double latitude, double sun_declination, double hour) {
  const double hour_angle = radians(15 * (hour - 12));
  const double along = math::cos(sun_declination) * math::cos(hour_angle);
  const double north = math::sin(sun_declination) * math::cos(latitude) - along * math::sin(latitude);
  const double up = math::sin(sun_declination) * math::sin(latitude) + along * math::cos(latitude);
  const double east = -math::cos(sun_declination) * math::sin(hour_angle);
  return {east, up, -north};
}

double azimuth_of(double east, double north) {
  const double azimuth = math::atan2(east, north);
  return azimuth < 0 ? azimuth + 2 * kPi : azimuth;
}

}  // namespace

double declination(double day) {
  const double day_angle = 2 * kPi * day / 365.25;
  return math::asin(0.3978 * math::sin(day_angle - 1.4 + 0.0355 * math::sin(day_angle - 0.0489)));
}

SkyDirection sun_position(double latitude, double day, double hour) {
  return sun_at_hour(latitude, declination(day), hour);
}

SkyDirection sun_at_hour(double latitude, double declination, double hour) {
  const DVec3 sun = sun_vector(latitude, declination, hour);
  const double altitude = math::asin(sun.y);
  // Equation 4.7b uses an arc cosine, which does not distinguish east from west and loses precision near noon. The arc
  // tangent of the horizontal components avoids both problems.
  if (sun.x == 0 && sun.z == 0) return {latitude >= 0 ? kPi : 0, altitude};
  return {azimuth_of(sun.x, -sun.z), altitude};
}

std::optional<std::pair<double, double>> daylight(double latitude, double day) {
  const double cosine = -math::tan(latitude) * math::tan(declination(day));
  if (cosine >= 1) return std::nullopt;
  if (cosine <= -1) return std::pair{0.0, 24.0};
  const double half_day = degrees(math::acos(cosine)) / 15;
  return std::pair{12 - half_day, 12 + half_day};
}

Vec3 unit_vector(SkyDirection direction) {
  const double level = math::cos(direction.altitude);
  return Vec3(math::sin(direction.azimuth) * level, math::sin(direction.altitude),
              -math::cos(direction.azimuth) * level);
}

SkyDirection sky_direction(Vec3 vector) {
  const double east = vector.x;
  const double north = -static_cast<double>(vector.z);
  const double level = std::sqrt(east * east + north * north);
  return {level > 0 ? azimuth_of(east, north) : 0, math::atan2(vector.y, level)};
}

}  // namespace meristem
