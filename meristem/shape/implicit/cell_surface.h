// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace meristem {

/// The part of an isosurface within one cell of a grid: triangles over points on its twelve edges and, rarely, points
/// inside it.
///
/// Corner c lies at (c & 1, c >> 1 & 1, c >> 2 & 1) in x, y, z. Edge 4 * axis + k runs along `axis` (0 x, 1 y, 2 z). k
/// counts its position in the two other axes: for x edges k = y + 2z, for y edges k = x + 2z, for z edges k = x + 2y. A
/// pattern has bit c set if corner c is inside, which means that its value is negative. 0 is outside.
struct CellSurface {
  /// Counter-clockwise as seen from outside. 0 to 11 are the points on the edges, and 12 + i is the i-th inner point.
  std::span<const std::array<std::uint8_t, 3>> triangles;
  /// An inner point is the mean of the points on these edges, one bit per edge, or near this mean if the mean lies in
  /// line with two of them. Nearly always empty.
  std::span<const std::uint16_t> inner;
};

/// Returns the surface within the cell for corner values, negative inside. Its topology equals the level set of the
/// trilinear function between the values: which corners are joined over faces, which through the cell, and which are
/// separate. Infinite values count as the largest ones, and NaN is not allowed. The spans are valid until the program
/// ends.
///
/// Surfaces of cells with common corner values fit together. The mesh is closed except at the border of the grid, and
/// each edge has two triangles. No triangle has its three points in line if no point lies in a corner.
const CellSurface& cell_surface(std::span<const float, 8> values);
/// Returns the surface of a cell whose pattern is known.
const CellSurface& cell_surface(std::uint8_t pattern, std::span<const float, 8> values);

std::uint8_t cell_pattern(std::span<const float, 8> values);
/// Returns true if the surface depends on more than the pattern.
bool is_ambiguous(std::uint8_t pattern);
/// Returns the surface of a pattern that is not ambiguous.
const CellSurface& simple_surface(std::uint8_t pattern);
/// Returns the edges that have a point, which are the edges with one end inside. One bit per edge.
std::uint16_t crossed_edges(std::uint8_t pattern);

}  // namespace meristem
