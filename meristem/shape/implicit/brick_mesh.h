// SPDX-License-Identifier: Apache-2.0
// Marching cubes over bricks. Each edge of a cell whose ends differ in sign has one vertex, which all cells around the
// edge share. cell_surface.h defines the triangles between vertices.
//
// Based on: W. E. Lorensen, H. E. Cline: Marching cubes (1987).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/shape/implicit/brick_grid.h"

namespace meristem {

/// A mesh without normals, and the origin of its vertices.
struct BrickMesh {
  Mesh mesh;
  /// Brick b of chunk c made the vertices from first_vertex[c][b] to first_vertex[c][b + 1].
  std::vector<std::vector<std::uint32_t>> first_vertex;
  /// Points inside cells, which are the last vertices: the chunk and brick of each.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> inner;
};

/// Returns the surface between values below 0 and all others. The mesh is closed if the grid is valid, 2-manifold, with
/// its front outside and without degenerate triangles. Vertices keep at least a thousandth of an edge from its ends. If
/// coordinates are large relative to the cells, vertices keep far enough from the ends that rounding does not join
/// them. This holds for cells wider than some millionths of the coordinates. Throws InputError at `path` before the
/// limit of triangles is exceeded, and Cancelled. Deterministic on any number of threads. The cost is linear in bricks.
BrickMesh mesh_bricks(const BrickGrid& grid, const SizeLimits& limits, const std::string& path, Progress& progress);

}  // namespace meristem
