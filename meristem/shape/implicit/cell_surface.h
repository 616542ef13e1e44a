// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace meristem {

/// What one cell of a grid contributes to an isosurface: triangles over points on its twelve edges and, rarely, points
/// inside it.
///
/// Corner c lies at (c & 1, c >> 1 & 1, c >> 2 & 1) in x, y, z. Edge 4 * axis + k runs along `axis` (0 x, 1 y, 2 z); k
/// counts its position in the two other axes: for x edges k = y + 2z, for y edges k = x + 2z, for z edges k = x + 2y.
/// A pattern has bit c where corner c is inside, which is where its value is negative; 0 is outside.
struct CellSurface {
  /// Counter-clockwise seen from outside: 0..11 the points on the edges, 12 + i the i-th inner point.
  std::span<const std::array<std::uint8_t, 3>> triangles;
  /// An inner point is the mean of the points on these edges, one bit per edge, or near the mean where it lies in line
  /// with two of them. Empty nearly always.
  std::span<const std::uint16_t> inner;
};

/// The surface within the cell for corner values, negative inside. It has the topology of the level set of the
/// trilinear function between them: which corners are joined over faces, which through the cell, and which not.
/// Infinite values count as the largest ones; NaN is not allowed. The spans live as long as the program.
///
/// Surfaces of cells that share their corners' values fit together: the mesh is closed but for the border of the grid,
/// each edge has two triangles, and no triangle has its three points in line, provided that no point lies in a corner.
const CellSurface& cell_surface(std::span<const float, 8> values);
/// The surface of a cell whose pattern is known.
const CellSurface& cell_surface(std::uint8_t pattern, std::span<const float, 8> values);

std::uint8_t cell_pattern(std::span<const float, 8> values);
/// True if the surface depends on more than the pattern.
bool is_ambiguous(std::uint8_t pattern);
/// The surface of a pattern that is not ambiguous.
const CellSurface& simple_surface(std::uint8_t pattern);
/// The edges that carry a point, one bit per edge: the edges with one end inside.
std::uint16_t crossed_edges(std::uint8_t pattern);

}  // namespace meristem
