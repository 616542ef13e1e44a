// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

/// Triangles with shared vertices, as a structure of arrays. Front faces wind counter-clockwise as seen from outside.
/// `normals` (unit), `uvs` and `tangents` are empty or as long as `positions`. v rises from the base of an organ to its
/// tip. Images have v = 0 at their lower edge.
struct Mesh {
  std::vector<Vec3> positions;                          ///< metres
  std::vector<Vec3> normals;                            ///< unit vectors out of the front face, one per vertex, or
                                                        ///< empty
  std::vector<Vec2> uvs;                                ///< texture coordinates, one per vertex, or empty
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< three vertices each, as indices into `positions`
  /// Direction in which u rises, unit and at right angles to the normal. w is 1 if v rises along cross(normal,
  /// tangent), and -1 if v falls.
  std::vector<Vec4> tangents;
  std::uint32_t stalk_triangles = 0;  ///< number of petiole triangles of a leaf, at the front of the list

  std::size_t vertex_count() const { return positions.size(); }    ///< number of positions
  std::size_t triangle_count() const { return triangles.size(); }  ///< number of triangles
  /// Returns the heap memory in use, bytes.
  std::size_t bytes() const {
    return positions.size() * sizeof(Vec3) + normals.size() * sizeof(Vec3) + uvs.size() * sizeof(Vec2) +
           tangents.size() * sizeof(Vec4) + triangles.size() * sizeof(triangles[0]);
  }
};

}  // namespace meristem
