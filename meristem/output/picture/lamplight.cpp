// SPDX-License-Identifier: Apache-2.0
// Light from lamps for a path tracer. With more than two lamps, one is drawn at random in proportion to its light, and
// its light is scaled so that the mean is exact.
#include "meristem/output/picture/lamplight.h"

#include <algorithm>

#include "meristem/base/colour.h"
#include "meristem/base/frame.h"

namespace meristem {

namespace {

constexpr float kRadius = 0.06F;             // metres, by default: shadow edges are slightly soft
constexpr float kWidest = 0.3F;              // maximum angular radius of a lamp of default size, radians
constexpr float kSunlight = 2.45F;           // a clear midday sun of 100 klux in the units of Sky
const Vec3 kWarmWhite(1.25F, 0.96F, 0.66F);  // of luminance 1
constexpr float kWhiteMean = 0.957F;         // mean of the channels of kWarmWhite

/// Returns a point of a lamp with its own radius: on the disc that faces its target, or else `position`.
Vec3 point_of(const Lamp& lamp, Vec3 position, Vec2 sample) {
  const Vec3 facing = normalized_or(lamp.target.value_or(position) - lamp.position, kUp);
  const Tangents tangents(facing);
  const Vec2 flat = static_cast<float>(*lamp.radius) * disc_point(sample);
  return lamp.position + flat.x * tangents.x + flat.y * tangents.z;
}

}  // namespace

/// Returns the irradiance of a surface that faces the lamp at a distance of one metre.
Vec3 Lamplight::irradiance_at_one(const Lamp& lamp) {
  if (!lamp.colour) return kSunlight * kWarmWhite;
  const Vec3 colour = linear_from_srgb(*lamp.colour);
  return (kSunlight * kWhiteMean * 3 / (colour.r + colour.g + colour.b)) * colour;
}

Vec3 Lamplight::irradiance(Vec3 position) const {
  Vec3 sum(0);
  for (const Lamp& lamp : lamps_) {
    sum += static_cast<float>(Light::ray_to(lamp, position).strength) * irradiance_at_one(lamp);
  }
  return sum;
}

Lamplight::Ray Lamplight::ray_to(const Lamp& lamp, Vec3 position, float nearest, Vec2 sample) {
  const LightRay ray = Light::ray_to(lamp, position);
  const auto distance = static_cast<float>(ray.distance);
  const float nearness = distance < nearest ? distance / nearest : 1;
  const Vec3 irradiance = static_cast<float>(ray.strength) * nearness * nearness * irradiance_at_one(lamp);
  if (lamp.radius) {
    const Vec3 way = point_of(lamp, position, sample) - position;
    return {.toward = normalized_or(way, ray.toward), .distance = glm::length(way), .irradiance = irradiance};
  }
  const float angle = std::min(kWidest, kRadius / std::max(distance, kRadius));
  return {.toward = cone_direction(ray.toward, angle, sample), .distance = distance, .irradiance = irradiance};
}

Lamplight::Ray Lamplight::drawn_ray(Vec3 position, float nearest, SampleStream& samples) const {
  double all = 0;
  for (const Lamp& lamp : lamps_) all += Light::ray_to(lamp, position).strength;
  double left = all * samples.next().x;
  std::size_t chosen = 0;
  for (std::size_t k = 0; k < lamps_.size(); ++k) {
    const double strength = Light::ray_to(lamps_[k], position).strength;
    if (strength <= 0) continue;
    chosen = k;
    left -= strength;
    if (left < 0) break;
  }
  Ray ray = ray_to(lamps_[chosen], position, nearest, samples.next());
  if (all > 0) ray.irradiance *= static_cast<float>(all / Light::ray_to(lamps_[chosen], position).strength);
  return ray;
}

}  // namespace meristem
