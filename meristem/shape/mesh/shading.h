// SPDX-License-Identifier: Apache-2.0
// Normals for meshes that have none, or other ones.
#pragma once

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"

namespace meristem {

/// The mesh with one normal per face, the low-poly look: no two triangles share a vertex. Uvs stay; tangents go.
/// Counts nothing into the caller's stage; throws Cancelled.
Mesh flat_shaded(const Mesh& mesh, Progress& progress);

/// The mesh with one normal per vertex, a mean of those of its triangles: exact for vertices on a sphere. Up where a
/// vertex has no triangles with an area. Uvs stay; tangents go.
Mesh smooth_shaded(const Mesh& mesh);

}  // namespace meristem
