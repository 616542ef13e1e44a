// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "meristem/output/overlay/overlay.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// A scene's meshes and after them, matt, what overlays show: points as balls, lines as thin rods, arrows as rods with
/// cones, as thick as suits something of `size` metres. Meshes and textures are shared with `meshes`.
MeshScene with_overlays(const MeshScene& meshes, std::span<const OverlayLayer> layers, double size);

}  // namespace meristem
