// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Returns the edges of a convex hull as thin round wires: frames for a cylinder of radius 1 from y = 0 to 1. Edges
/// between triangles in one plane are left out. The thickness of a wire is 1/400 of the hull's longest side. Returns
/// nothing for an empty mesh.
std::vector<Frame> hull_wires(const Mesh& hull);

/// Returns a plant's meshes followed by the convex hull of each tree's crown, matt and warm in colour. The lit share is
/// measured on this hull. Meshes and textures are shared with `meshes`. Trees without a crown add nothing. Throws
/// Cancelled.
MeshScene with_crown_hulls(const MeshScene& meshes, const Plant& plant, const Progress& progress);

}  // namespace meristem
