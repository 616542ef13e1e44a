// SPDX-License-Identifier: Apache-2.0
// A flat polygon in triangles whose corners also stand on given lines, so that it can be bent there.
#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>

namespace meristem {

/// Counter-clockwise.
using FlatTriangle = std::array<glm::dvec2, 3>;

/// The lines that a polygon is cut along: y = rows[k] and x = columns[k], each rising.
struct CutLines {
  std::vector<double> rows;
  std::vector<double> columns;
  /// Corners nearer to a line than this count as on it; lines are further apart.
  double row_tolerance = 1e-4, column_tolerance = 1e-4;
};

/// The simple polygon `corners`, counter-clockwise, in triangles without area in common, from row to row. No corner of
/// one lies inside an edge of another, and a line has the very same corners on both sides. Where a polygon crosses
/// itself, the result has holes or covers parts twice.
std::vector<FlatTriangle> cut_polygon(const std::vector<glm::dvec2>& corners, const CutLines& lines);

/// Whether two edges of the closed polygon have a point in common other than the corner between neighbours.
bool crosses_itself(const std::vector<glm::dvec2>& corners);

}  // namespace meristem
