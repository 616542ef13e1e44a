// SPDX-License-Identifier: Apache-2.0
// Computes the radiance of sun and dome: a relative distribution over the dome, scaled to measured illuminances.
// Sources: see sky.h.
#include "meristem/scene/light/sky.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/frame.h"
#include "meristem/base/math.h"

namespace meristem {

namespace {

// Irradiance of 1000 lux in our units. 95 klux from the sun and 33 from the dome make a white surface's radiance 1.
constexpr double kPerKilolux = kPi / 128;
// Haze that softens contrast: the handbook's clear sky is darker than photographs of pleasant days.
constexpr double kHaze = 2.4;

float luminance(Vec3 light) { return 0.2126F * light.r + 0.7152F * light.g + 0.0722F * light.b; }

Vec3 with_luminance_1(Vec3 light) { return light / luminance(light); }

/// Returns the air mass: the path of sunlight through the air relative to the vertical path (Kasten and Young).
double air_mass(double altitude) {
  const double altitude_deg = std::max(degrees(altitude), 0.0);
  return 1 / (math::sin(radians(altitude_deg)) + 0.50572 * math::pow(altitude_deg + 6.07995, -1.6364));
}

/// Returns the colour of sunlight after an air mass of `mass`, with luminance 1. Uses the optical depths of air
/// molecules, ozone and a little dust at 610, 550 and 465 nm, white-balanced for a sun at 45°.
Vec3 tint_after(double mass) {
  constexpr double kReferenceMass = 1.413;
  const auto channel = [&](double depth) { return static_cast<float>(math::exp(-depth * (mass - kReferenceMass))); };
  const Vec3 kAt45{1.03F, 1.0F, 0.92F};
  return with_luminance_1(kAt45 * Vec3(channel(0.185), channel(0.235), channel(0.34)));
}

/// Returns the illuminance of a surface facing the sun in kilolux. It fades out during sunset.
double sun_kilolux(double altitude) {
  const double risen = std::clamp((degrees(altitude) + 0.8) / 1.6, 0.0, 1.0);
  return 127.5 * math::exp(-0.21 * air_mass(altitude)) * risen * risen * (3 - 2 * risen);
}

/// Returns the illuminance of level ground by the dome in kilolux. It falls tenfold in 4° below the horizon, to a
/// bright night.
double dome_kilolux(double altitude) {
  if (altitude < 0) return kHaze * (0.02 + 0.78 * math::exp(0.58 * degrees(altitude)));
  return kHaze * (0.8 + 15.5 * std::sqrt(math::sin(altitude)));
}

}  // namespace

Sky::Sky(SkyDirection sun) : sun_direction_(unit_vector(sun)) {
  const double mass = air_mass(sun.altitude);
  // Limit the reddening: at the horizon, the deepest reds would colour half the dome.
  sun_tint_ = tint_after(std::min(mass, 9.0));
  sun_irradiance_ = tint_after(std::min(mass, 14.0)) * static_cast<float>(sun_kilolux(sun.altitude) * kPerKilolux);
  const double low = 1 - std::clamp(std::abs(degrees(sun.altitude)) / 18, 0.0, 1.0);
  warmth_ = static_cast<float>(low * low);

  // Scale the dome to the correct light on level ground: sum over rings with equal weight in irradiance.
  constexpr int kRings = 32;
  constexpr int kSectors = 64;
  DVec3 sum(0);
  for (int ring = 0; ring < kRings; ++ring) {
    const double sine = std::sqrt((ring + 0.5) / kRings);
    const double height = std::sqrt(1 - sine * sine);
    for (int sector = 0; sector < kSectors; ++sector) {
      const double azimuth = 2 * kPi * (sector + 0.5) / kSectors;
      sum += DVec3(relative_radiance(Vec3(sine * math::sin(azimuth), height, -sine * math::cos(azimuth))));
    }
  }
  const Vec3 relative_irradiance = Vec3(sum * (kPi / (kRings * kSectors)));
  scale_ = static_cast<float>(dome_kilolux(sun.altitude) * kPerKilolux) / luminance(relative_irradiance);
  dome_irradiance_ = scale_ * relative_irradiance;
}

Vec3 Sky::radiance(Vec3 direction) const {
  const Vec3 unit = normalized_or(direction, kUp);
  return scale_ * relative_radiance(normalized_or(Vec3(unit.x, std::max(unit.y, 0.0F), unit.z), Vec3(0, 0, -1)));
}

Vec3 Sky::relative_radiance(Vec3 direction) const {
  // Brightness: the horizon and the area around the sun are brighter than the zenith.
  const double height = std::max(static_cast<double>(direction.y), 0.015);
  const double cosine = std::clamp(static_cast<double>(glm::dot(direction, sun_direction_)), -1.0, 1.0);
  const double from_sun = math::acos(cosine);
  const double gradation = 1 - math::exp(-0.32 / height);
  const double glow = math::exp(-3 * from_sun);
  const double brightness = gradation * (1 + 10 * (glow - math::exp(-1.5 * kPi)) + 0.45 * cosine * cosine);

  // Colour: blue overhead, pale near the horizon and around the sun. A low sun warms the horizon on its side.
  const Vec3 kDeep = with_luminance_1(Vec3(0.17F, 0.40F, 1.0F));
  const Vec3 kPale = with_luminance_1(Vec3(0.64F, 0.82F, 1.0F));
  const double depth = math::exp(-0.16 / height);
  const Vec3 blue = glm::mix(kPale, kDeep, static_cast<float>(depth * (1 - 0.6 * glow)));
  const double near_horizon = 1 - std::clamp(height / 0.5, 0.0, 1.0);
  const double side = 0.35 + 0.65 * std::max(0.0, 0.5 + 0.5 * cosine);
  const double warm = warmth_ * near_horizon * near_horizon * side;
  const Vec3 tint = glm::mix(blue, sun_tint_, static_cast<float>(std::min(0.85, warm + 0.5 * glow)));
  return static_cast<float>(brightness) * with_luminance_1(tint);
}

}  // namespace meristem
