// SPDX-License-Identifier: Apache-2.0
// Meshes of bodies by marching cubes: closed, 2-manifold, their fronts outside, without degenerate triangles, each
// vertex shared by all triangles about it, whatever the resolution and the values. Ambiguous cells are meshed as the
// trilinear function in them goes.
//
// A body is sampled only where its surface may be (brick_field.h), so the cost grows with the surface and not with the
// volume. Bodies thinner than a cell may fall apart or vanish; plant_body.h thickens them.
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "meristem/base/limits.h"
#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/shape/implicit/implicit_body.h"

namespace meristem {

/// How finely a body is sampled.
struct IsosurfaceOptions {
  int resolution = 100;  ///< cells along the longest side of the box about the body's solids, 10 to 1024
  bool normals = true;   ///< from the body's function, else none; where such a one lies behind a triangle, from those
                         ///< about it: in front of all, but at few creases where no direction is
};

/// Metres along a side of the cells: the box about the solids, or where blends reach farther than that is wide, about
/// what they may fill, over the resolution.
double cell_size(const ImplicitBody& body, int resolution);

/// The surface of `body`: triangles grow with the square of the resolution. Empty for an empty body.
/// Begins stages of `progress` and stops within 50 ms. Throws InputError at `path` past the limits of triangles and of
/// bytes, before they are spent; Cancelled; std::invalid_argument for a resolution out of range. Deterministic on any
/// number of threads.
Mesh extract_isosurface(const ImplicitBody& body, const IsosurfaceOptions& options, const Limits& limits,
                        const std::string& path, Progress& progress);

/// Values on a grid: `size` of them along x, y and z, x fastest, the first at `origin`, `spacing` metres apart.
struct SampledField {
  glm::ivec3 size{0};         ///< number of values along each axis
  DVec3 origin{0};            ///< position of the first value, metres
  double spacing = 1;         ///< distance of neighbouring values, metres
  std::vector<float> values;  ///< x fastest, then y
};

/// The surface between values below `isovalue` and the others. What lies beyond the grid counts as outside, as do
/// values that are no numbers; so the mesh is closed. No normals. Throws as above, also std::invalid_argument for a
/// size that does not fit the values.
Mesh extract_isosurface(const SampledField& field, float isovalue, const Limits& limits, const std::string& path,
                        Progress& progress);

}  // namespace meristem
