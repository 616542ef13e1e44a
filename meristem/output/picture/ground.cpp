// SPDX-License-Identifier: Apache-2.0
// Places the ground of a picture below a plant. The distance at which it fades grows with the size of the plant.
#include "meristem/output/picture/ground.h"

#include <cmath>

#include "meristem/base/colour.h"

namespace meristem {

Ground ground_below(const MeshScene& meshes, const Scene& scene) {
  const Box box = meshes.bounds();
  const float extent = box.is_empty() ? 1 : glm::length(box.size());
  Ground ground;
  ground.colour = linear_from_srgb(scene.ground_colour);
  ground.centre = box.is_empty() ? Vec3(0) : box.centre();
  const float lowest = box.is_empty() ? 0 : box.low.y;
  ground.height = std::abs(lowest) < 0.05F * extent ? 0 : lowest;
  ground.fade_distance = 1.2F * extent;
  return ground;
}

}  // namespace meristem
