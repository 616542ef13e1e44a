// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/directions.h"

#include "meristem/base/fingerprint.h"
#include "meristem/base/frame.h"

namespace meristem {

Directions::Directions(const Light& light, SkyDirection shown) {
  if (light.sun.size() == 1) {
    toward_light_ = light.sun[0].toward;  // to the last bit
  } else if (!light.sun.empty()) {
    DVec3 sum(0);
    for (const DirectionalLight& sun : light.sun) sum += sun.strength * DVec3(sun.toward);
    toward_light_ = normalized_or(Vec3(sum), kUp);
  } else if (shown.altitude > 0) {
    toward_light_ = unit_vector(shown);
  }
  for (const DirectionalLight& directional : light.sun) directional_strength_ += directional.strength;
  for (const DirectionalLight& directional : light.sky) directional_strength_ += directional.strength;
  if (!light.lamps.empty()) lamps_ = std::make_shared<const std::vector<Lamp>>(light.lamps);
}

Vec3 Directions::toward_all(Vec3 position) const {
  DVec3 sum = directional_strength_ * DVec3(toward_light_);
  for (const Lamp& lamp : *lamps_) {
    const LightRay ray = Light::ray_to(lamp, position);
    sum += ray.strength * DVec3(ray.toward);
  }
  return normalized_or(Vec3(sum), kUp);
}

std::uint64_t Directions::key_at(Vec3 position) const {
  Fingerprint key;
  for (const Vec3 direction : {toward_light(position), down(position)})
    key.add(direction.x).add(direction.y).add(direction.z);
  return key.hash();
}

}  // namespace meristem
