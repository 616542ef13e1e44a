// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// Level ground that catches shadows and, seen from the camera, fades into the horizon.
struct Ground {
  float height = 0;
  Vec3 colour{0.1F};  ///< linear
  Vec3 centre{0};
  float fade_distance = 10;  ///< metres from the centre at which half is faded
};

/// The ground of a picture of these meshes: through the origin if the plant stands about there, else through its lowest
/// point.
Ground ground_below(const MeshScene& meshes, const Scene& scene);

}  // namespace meristem
