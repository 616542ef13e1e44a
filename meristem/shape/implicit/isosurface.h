// SPDX-License-Identifier: Apache-2.0
// Meshes of bodies by marching cubes. For all resolutions and values, meshes are closed and 2-manifold, with their
// fronts outside and without degenerate triangles. Each vertex is shared by all triangles around it. Ambiguous cells
// follow the trilinear function of their values.
//
// A body is sampled only near its surface (brick_field.h), so the cost grows with the surface and not with the volume.
// Bodies thinner than a cell can fall apart or vanish, so plant_body.h thickens them.
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "meristem/base/limits.h"
#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/shape/implicit/implicit_body.h"

namespace meristem {

/// Resolution and attributes of the mesh of a body.
struct IsosurfaceOptions {
  int resolution = 100;  ///< cells along the longest side of the box around the body's solids, 10 to 1024
  bool normals = true;   ///< if true, computes normals from the body's function. A normal that lies behind one of its
                         ///< triangles is replaced by one in front of all of them, except at a few creases where none
                         ///< exists
};

/// Returns the side length of the cells in metres: the longest side of the box around the solids, divided by the
/// resolution. If blends reach farther than this side, the size includes their reach.
double cell_size(const ImplicitBody& body, int resolution);

/// Returns the surface of `body`. The number of triangles grows with the square of the resolution. Empty for an empty
/// body. Begins stages of `progress` and stops within 50 ms. Throws InputError at `path` before the limits of triangles
/// and bytes are exceeded, Cancelled, and std::invalid_argument for a resolution out of range. Deterministic on any
/// number of threads.
Mesh extract_isosurface(const ImplicitBody& body, const IsosurfaceOptions& options, const SizeLimits& limits,
                        const std::string& path, Progress& progress);

/// Values on a grid: `size` values along x, y and z, x fastest. The first is at `origin`, and neighbours are `spacing`
/// metres apart.
struct SampledField {
  glm::ivec3 size{0};         ///< number of values along each axis
  DVec3 origin{0};            ///< position of the first value, metres
  double spacing = 1;         ///< distance of neighbouring values, metres
  std::vector<float> values;  ///< x fastest, then y
};

/// Returns the surface between values below `isovalue` and all others. Positions beyond the grid and NaN count as
/// outside, so the mesh is closed. The mesh has no normals. Throws like the function above, and std::invalid_argument
/// if the size does not fit the values.
Mesh extract_isosurface(const SampledField& field, float isovalue, const SizeLimits& limits, const std::string& path,
                        Progress& progress);

}  // namespace meristem
