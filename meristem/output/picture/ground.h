// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Level ground that receives shadows and fades into the horizon.
struct Ground {
  float height = 0;
  Vec3 colour{0.1F};  ///< linear
  Vec3 centre{0};
  float fade_distance = 10;  ///< distance from the centre at which half has faded, metres
};

/// Returns the ground of a picture of these meshes. The ground is at y = 0 if the plant's lowest point is near it, and
/// otherwise at this lowest point.
Ground ground_below(const MeshScene& meshes, const Scene& scene);

}  // namespace meristem
