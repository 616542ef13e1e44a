// SPDX-License-Identifier: Apache-2.0
// Light from lamps for a path tracer. With more than two lamps, one is drawn at random in proportion to its light, and
// its light is scaled so that the mean is exact.
#include "meristem/output/picture/lamplight.h"

#include <algorithm>

namespace meristem {

namespace {

constexpr float kRadius = 0.06F;  // metres: shadow edges are slightly soft
constexpr float kWidest = 0.3F;   // maximum angular radius of a lamp, radians
// A clear midday sun of 100 klux in the units of Sky, times a warm white of luminance 1.
const Vec3 kIrradiance = 2.45F * Vec3(1.25F, 0.96F, 0.66F);

}  // namespace

Vec3 Lamplight::irradiance(Vec3 position) const {
  double strength = 0;
  for (const Lamp& lamp : lamps_) strength += Light::ray_to(lamp, position).strength;
  return static_cast<float>(strength) * kIrradiance;
}

Lamplight::Ray Lamplight::ray_to(const Lamp& lamp, Vec3 position, float nearest, Vec2 sample) {
  const LightRay ray = Light::ray_to(lamp, position);
  const auto distance = static_cast<float>(ray.distance);
  const float nearness = distance < nearest ? distance / nearest : 1;
  const float angle = std::min(kWidest, kRadius / std::max(distance, kRadius));
  return {.toward = cone_direction(ray.toward, angle, sample),
          .distance = distance,
          .irradiance = static_cast<float>(ray.strength) * nearness * nearness * kIrradiance};
}

Lamplight::Ray Lamplight::drawn_ray(Vec3 position, float nearest, SampleStream& samples) const {
  double all = 0;
  for (const Lamp& lamp : lamps_) all += Light::ray_to(lamp, position).strength;
  double left = all * samples.next().x;
  std::size_t chosen = 0;
  for (; chosen + 1 < lamps_.size(); ++chosen) {
    left -= Light::ray_to(lamps_[chosen], position).strength;
    if (left < 0) break;
  }
  Ray ray = ray_to(lamps_[chosen], position, nearest, samples.next());
  ray.irradiance *= static_cast<float>(all / Light::ray_to(lamps_[chosen], position).strength);
  return ray;
}

}  // namespace meristem
