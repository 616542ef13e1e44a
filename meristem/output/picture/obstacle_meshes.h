// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/scene/obstacle/obstacles.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// Whether any of the obstacles is not hidden.
bool has_visible(const Obstacles& obstacles);

/// The obstacles that are not hidden, alone, with flat normals. The component of each is its path in the document, such
/// as "scene.obstacles[3]". Throws Cancelled.
MeshScene obstacle_meshes(const Obstacles& obstacles, Progress& progress);

/// The plants' meshes and after them the obstacles that are not hidden, matt and with flat faces. Meshes and textures
/// are shared with `plants`.
MeshScene with_obstacles(MeshScene plants, const Obstacles& obstacles);

}  // namespace meristem
