// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/brighter_way.h"

#include <cmath>

namespace meristem {
namespace {

/// Returns the unit vector away from an obstacle and at right angles to the light. Returns the direction to the light
/// if the light passes through the obstacle's centroid.
DVec3 out_of_shade(DVec3 position, DVec3 centroid, DVec3 toward_light) {
  const DVec3 away = position - centroid;
  const DVec3 across = away - toward_light * glm::dot(away, toward_light);
  const double length = std::sqrt(squared_length(across));
  return length > 1e-9 ? across / length : toward_light;
}

}  // namespace

DVec3 brighter_way(const Scene& scene, Vec3 position, double sunlit_weight) {
  DVec3 sum(0);
  scene.light.for_each_ray(position, [&](const LightRay& ray) {
    const DVec3 toward(ray.toward);
    const auto shade = scene.obstacles.first_hit(position, ray.toward, ray.distance);
    if (shade) {
      const DVec3 centroid(scene.obstacles.ground_centroid(shade->obstacle));
      sum += ray.strength * out_of_shade(DVec3(position), centroid, toward);
    } else {
      sum += ray.strength * sunlit_weight * toward;
    }
  });
  return sum;
}

}  // namespace meristem
