// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

/// Triangles with shared vertices, structure of arrays. Front faces wind counter-clockwise seen from outside.
/// `normals` (unit), `uvs` and `tangents` are empty or as long as `positions`. v rises from the base of an organ to its
/// tip; images have v = 0 at their lower edge.
struct Mesh {
  std::vector<Vec3> positions;                          ///< metres
  std::vector<Vec3> normals;                            ///< unit vectors out of the front face, one a vertex, or empty
  std::vector<Vec2> uvs;                                ///< texture coordinates, one a vertex, or empty
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< three vertices each, as indices into `positions`
  /// Where u rises, unit and at right angles to the normal; w is 1 where v rises along cross(normal, tangent), -1 where
  /// it falls.
  std::vector<Vec4> tangents;
  std::uint32_t stalk_triangles = 0;  ///< how many of a leaf's triangles, at the front of the list, are its petiole

  std::size_t vertex_count() const { return positions.size(); }    ///< number of positions
  std::size_t triangle_count() const { return triangles.size(); }  ///< number of triangles
  /// Heap bytes in use.
  std::size_t bytes() const {
    return positions.size() * sizeof(Vec3) + normals.size() * sizeof(Vec3) + uvs.size() * sizeof(Vec2) +
           tangents.size() * sizeof(Vec4) + triangles.size() * sizeof(triangles[0]);
  }
};

}  // namespace meristem
