// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// The edges of a convex hull as thin round wires: frames for a cylinder of radius 1 from y = 0 to 1. Edges between
/// triangles in one plane are left out. A wire is a 400th of the hull's longest side thick. An empty mesh has none.
std::vector<Frame> hull_wires(const Mesh& hull);

/// A plant's meshes and after them, matt and warm in colour, the convex hull of each tree's crown: the hull whose
/// lit share is measured. Meshes and textures are shared with `meshes`; trees without a crown add nothing. Throws
/// Cancelled.
MeshScene with_crown_hulls(const MeshScene& meshes, const Plant& plant, const Progress& progress);

}  // namespace meristem
