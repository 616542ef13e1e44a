// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "meristem/export/overlay/overlay.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Returns the meshes of a scene followed by matt meshes of the overlays: points as balls, lines as thin rods, arrows
/// as rods with cones. `size` (metres) is the size of the shown object, to which their thickness is adapted. Meshes and
/// textures are shared with `meshes`.
MeshScene with_overlays(const MeshScene& meshes, std::span<const OverlayLayer> layers, double size);

}  // namespace meristem
