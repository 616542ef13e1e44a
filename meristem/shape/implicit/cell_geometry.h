// SPDX-License-Identifier: Apache-2.0
// The unit cube of marching cubes: its eight corners, twelve edges and six faces, by number.
//
// Corner c lies at (c & 1, c >> 1 & 1, c >> 2 & 1). Edge 4 * axis + k runs along `axis`. k is its position in the two
// other axes, where the earlier axis counts 1 and the later 2. Face 2 * axis + side is the face where `axis` is `side`.
#pragma once

#include <array>
#include <cstdint>

#include "meristem/base/vec.h"

namespace meristem {

inline constexpr int kCellEdges = 12;
inline constexpr int kCellFaces = 6;

/// Returns the two ends of an edge, the lower one first.
constexpr std::array<int, 2> edge_corners(int edge) {
  const int axis = edge / 4, k = edge % 4;
  const int first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
  const int low = ((k & 1) << first) | ((k >> 1) << second);
  return {low, low | (1 << axis)};
}

/// For two corners: the edge between them, or -1 if they are not neighbours.
inline constexpr std::array<std::array<std::int8_t, 8>, 8> kEdgesBetween = [] {
  std::array<std::array<std::int8_t, 8>, 8> edges{};
  for (auto& of_corner : edges) of_corner.fill(-1);
  for (int edge = 0; edge < kCellEdges; ++edge) {
    const auto [low, high] = edge_corners(edge);
    edges[low][high] = edges[high][low] = static_cast<std::int8_t>(edge);
  }
  return edges;
}();

/// Returns the edge between two neighbouring corners.
constexpr int edge_between(int a, int b) { return kEdgesBetween[a][b]; }

/// Returns the corners of a face, counter-clockwise as seen from outside of the cube.
constexpr std::array<int, 4> face_corners(int face) {
  const int axis = face / 2, side = face % 2;
  const int u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3);
  const int origin = side << axis;
  if (side == 1) return {origin, origin | u, origin | u | v, origin | v};
  return {origin, origin | v, origin | u | v, origin | u};
}

constexpr bool is_on_face(int edge, int face) {
  const auto [low, high] = edge_corners(edge);
  return ((low >> (face / 2)) & 1) == face % 2 && ((high >> (face / 2)) & 1) == face % 2;
}

/// The edges of each face, one bit per edge.
inline constexpr std::array<unsigned, kCellFaces> kFaceEdges = [] {
  std::array<unsigned, kCellFaces> edges{};
  for (int face = 0; face < kCellFaces; ++face) {
    for (int edge = 0; edge < kCellEdges; ++edge) {
      if (is_on_face(edge, face)) edges[face] |= 1U << edge;
    }
  }
  return edges;
}();

/// Returns true if the edges (one bit per edge) all lie on one face.
constexpr bool share_a_face(unsigned edges) {
  for (const unsigned face : kFaceEdges) {
    if ((edges & ~face) == 0) return true;
  }
  return false;
}

constexpr DVec3 corner_place(int corner) {
  return {static_cast<double>(corner & 1), static_cast<double>(corner >> 1 & 1), static_cast<double>(corner >> 2 & 1)};
}

constexpr DVec3 edge_middle(int edge) {
  const auto [low, high] = edge_corners(edge);
  return 0.5 * (corner_place(low) + corner_place(high));
}

}  // namespace meristem
