// SPDX-License-Identifier: Apache-2.0
// Marching cubes over bricks: one vertex on each edge of a cell whose ends differ in sign, shared by all cells about
// it, and triangles between them as cell_surface.h says.
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

/// A mesh without normals, and where its vertices come from.
struct BrickMesh {
  Mesh mesh;
  /// The vertices that brick b of chunk c made are first_vertex[c][b] to first_vertex[c][b + 1].
  std::vector<std::vector<std::uint32_t>> first_vertex;
  /// Points inside cells, the last vertices: the chunk and brick of each.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> inner;
};

/// The surface between values below 0 and the others: closed where the grid's promise holds, 2-manifold, its front
/// outside, without degenerate triangles. Vertices keep at least a thousandth of an edge from its ends; where
/// coordinates are large for the cells, they keep far enough off that rounding does not bring them together, while
/// cells are wider than some millionths of those. Throws InputError at `path` past the limit of triangles, before they
/// are made, and Cancelled. Deterministic on any number of threads; cost linear in bricks.
BrickMesh mesh_bricks(const BrickGrid& grid, const Limits& limits, const std::string& path, Progress& progress);

}  // namespace meristem
