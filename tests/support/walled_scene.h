// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/scene/scene.h"

namespace meristem {

inline Scene scene_under(SkyDirection sun) {
  Scene scene;
  scene.light.sun = {{unit_vector(sun), 1}};
  return scene;
}

/// A wall south of the origin, from x = -3 to 3 and z = 3 to 6, 8 m high.
inline Scene walled_scene(SkyDirection sun) {
  Scene scene = scene_under(sun);
  Obstacle wall;
  wall.mesh = box_mesh({-3, 0, 3}, {3, 8, 6});
  scene.obstacles = Obstacles({wall});
  return scene;
}

inline constexpr SkyDirection kSouth{kPi, kPi / 4};

}  // namespace meristem
