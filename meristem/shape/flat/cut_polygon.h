// SPDX-License-Identifier: Apache-2.0
// Cuts a flat polygon into triangles whose corners also lie on given lines, so that the polygon can be bent along these
// lines.
#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>

namespace meristem {

/// Corners run counter-clockwise.
using FlatTriangle = std::array<glm::dvec2, 3>;

/// The lines along which a polygon is cut: y = rows[k] and x = columns[k], each ascending.
struct CutLines {
  std::vector<double> rows;
  std::vector<double> columns;
  /// Corners that are nearer to a line than this lie on it. Lines must be further apart.
  double row_tolerance = 1e-4, column_tolerance = 1e-4;
};

/// Returns the simple polygon `corners`, counter-clockwise, as triangles that do not overlap, from row to row. No
/// corner of one triangle lies inside an edge of another, and both sides of a line have equal corners. If the polygon
/// crosses itself, the result has holes or covers parts twice.
std::vector<FlatTriangle> cut_polygon(const std::vector<glm::dvec2>& corners, const CutLines& lines);

/// Returns true if two edges of the closed polygon have a common point, apart from the corner between neighbours.
bool crosses_itself(const std::vector<glm::dvec2>& corners);

}  // namespace meristem
