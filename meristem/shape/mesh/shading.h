// SPDX-License-Identifier: Apache-2.0
// Computes normals for meshes that have none, or replaces their normals.
#pragma once

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"

namespace meristem {

/// Returns the mesh with one normal per face, the low-poly look: no two triangles share a vertex. Keeps uvs and drops
/// tangents. Does not advance the caller's stage. Throws Cancelled.
Mesh flat_shaded(const Mesh& mesh, Progress& progress);

/// Returns the mesh with one normal per vertex, a mean over its triangles that is exact for vertices on a sphere. The
/// normal is up if a vertex has no triangles with an area. Keeps uvs and drops tangents.
Mesh smooth_shaded(const Mesh& mesh);

}  // namespace meristem
