// SPDX-License-Identifier: Apache-2.0
// Vertices that several faces share in files. Flat shaded meshes have three vertices of their own for each triangle.
// Files that store positions apart from normals, or no normals at all, can have one vertex for each position.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/mesh.h"

namespace meristem {

/// Groups of equal vertices of a mesh, numbered in the order of their first vertices.
struct SharedVertices {
  std::vector<std::uint32_t> number;  ///< for each vertex, the number of its group
  std::vector<std::uint32_t> first;   ///< for each group, its first vertex
};

/// Groups the vertices of equal positions. If `by_uvs`, vertices of different texture coordinates are never equal.
/// Sorts the vertices.
SharedVertices share_vertices(const Mesh& mesh, bool by_uvs);

/// Returns true if the mesh has several triangles, each with three vertices of its own and with one normal.
bool is_flat_shaded(const Mesh& mesh);

}  // namespace meristem
