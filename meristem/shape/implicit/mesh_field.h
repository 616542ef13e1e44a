// SPDX-License-Identifier: Apache-2.0
// Set operations between closed meshes, through their distances on a grid. The result is closed and has no crossings,
// whatever the meshes, but edges and corners are rounded to about the size of a cell.
#pragma once

#include <string>

#include "meristem/base/limits.h"
#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/scene/obstacle/closed_mesh.h"
#include "meristem/shape/implicit/isosurface.h"

namespace meristem {

/// A set operation on two bodies: the space of any of them, of both, or of the first without the second.
enum class MeshOperation { unite, intersect, subtract };

/// Options of combine_meshes().
struct CombineOptions {
  int resolution = 100;        ///< cells along the longest side of the result's bounds, 10 to 512
  std::string path = "limit";  ///< place that errors about limits name
};

/// Returns the signed distances of a closed mesh on a grid, in metres, negative inside. Only distances below three
/// cells are exact. All others have the right sign and this size. The cost grows with the grid and with the triangles'
/// area. Throws Cancelled.
SampledField mesh_distances(const TriangleMesh& mesh, glm::ivec3 size, DVec3 origin, double spacing,
                            Progress& progress);

/// Returns the body of `operation` on two closed meshes. Vertices are shared, and there are no normals. Empty if the
/// result encloses no cell. Throws InputError at `options.path` before limits are exceeded, Cancelled, and
/// std::invalid_argument for a resolution out of range.
Mesh combine_meshes(MeshOperation operation, const TriangleMesh& a, const TriangleMesh& b,
                    const CombineOptions& options, const SizeLimits& limits, Progress& progress);

}  // namespace meristem
