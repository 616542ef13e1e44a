// SPDX-License-Identifier: Apache-2.0
// Positions and strengths of the sun over days, and the patches of a uniform sky.
#include "meristem/scene/light/light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/scene/light/sampled_days.h"

namespace meristem {

namespace {

constexpr double kNearest = 0.1;      // metres; the light of a lamp does not increase at smaller distances
constexpr double kFadingShare = 0.1;  // share of a cone's angle over which its edge fades

/// Returns the unit vector along `vector`, or down for a vector without length.
DVec3 unit_or_down(DVec3 vector) {
  const double length = std::sqrt(squared_length(vector));
  return length > 0 ? vector / length : DVec3(0, -1, 0);
}

}  // namespace

Vec3 Light::mean_direction() const {
  DVec3 sum(0);
  for (const DirectionalLight& directional : sun) sum += directional.strength * DVec3(directional.toward);
  for (const DirectionalLight& directional : sky) sum += directional.strength * DVec3(directional.toward);
  return normalized_or(Vec3(sum), kUp);
}

double Lamp::share_toward(Vec3 point) const {
  if (!target) return 1;
  const double cosine =
      glm::dot(unit_or_down(DVec3(*target) - DVec3(position)), unit_or_down(DVec3(point) - DVec3(position)));
  const double edge = math::cos(angle / 2);
  const double full = math::cos((1 - kFadingShare) * angle / 2);
  const double share = std::clamp((cosine - edge) / (full - edge), 0.0, 1.0);
  return share * share * (3 - 2 * share);
}

LightRay Light::ray_to(const Lamp& lamp, Vec3 point) {
  const DVec3 way = DVec3(lamp.position) - DVec3(point);
  const double distance = std::sqrt(squared_length(way));
  const double near = std::max(distance, kNearest);
  return {.toward = distance > 0 ? Vec3(way / distance) : kUp,
          .distance = distance,
          .strength = lamp.strength * lamp.share_toward(point) / (near * near)};
}

std::vector<DirectionalLight> sun_of_day(double latitude, double day, double every_hours) {
  return sun_of_days(latitude, {day}, every_hours);
}

std::vector<DirectionalLight> sun_of_days(double latitude, const std::vector<double>& days, double every_hours) {
  return sampled_days(latitude, days, {.every = every_hours});
}

std::vector<DirectionalLight> even_sky(double strength) {
  // Rings with equal solid angle per patch, which means equal height on the sphere. The patches are about as wide as
  // high.
  constexpr std::array<int, 4> kPatches = {16, 12, 8, 4};
  constexpr int kCount = 40;
  std::vector<DirectionalLight> sky;
  double low = 0;  // sine of the altitude of the ring's lower edge
  for (const int patches : kPatches) {
    const double high = low + static_cast<double>(patches) / kCount;
    const double sine = (low + high) / 2;
    for (int k = 0; k < patches; ++k) {
      const SkyDirection middle{2 * kPi * (k + 0.5) / patches, math::asin(sine)};
      // The mean of the sines over all patches is 1/2.
      sky.push_back({unit_vector(middle), strength * sine / (0.5 * kCount)});
    }
    low = high;
  }
  return sky;
}

}  // namespace meristem
