// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/scene/obstacle/obstacles.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Returns true if any obstacle is visible.
bool has_visible(const Obstacles& obstacles);

/// Returns the visible obstacles as meshes with flat normals. The component of each is its path in the document, such
/// as "scene.obstacles[3]". Throws Cancelled.
MeshScene obstacle_meshes(const Obstacles& obstacles, Progress& progress);

/// Returns the plants' meshes followed by the visible obstacles, matt and with flat faces. Meshes and textures are
/// shared with `plants`.
MeshScene with_obstacles(MeshScene plants, const Obstacles& obstacles);

}  // namespace meristem
