// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"

namespace meristem {

/// Returns the convex hull of points (finite, metres) as a closed mesh without normals. The vertices are some of the
/// points, and the triangles face outward. Returns an empty mesh for fewer than four points and for points in one
/// plane, or nearly so. Throws Cancelled if `progress` is given and was cancelled, which is checked every few
/// milliseconds.
Mesh convex_hull(std::span<const Vec3> points, const Progress* progress = nullptr);

/// Returns the convex hull of points in a plane, counter-clockwise from the point with the lowest x. Ties go to the
/// lowest y. Points in the middle of edges are left out. Points on a line give the two ends of the line, and equal
/// points give one point.
std::vector<Vec2> convex_outline(std::vector<Vec2> points);

/// Returns the area of all triangles, one side, in square metres.
double surface_area_of(const Mesh& mesh);

/// Returns the volume within a closed mesh whose triangles face outward, in cubic metres.
double volume_of(const Mesh& mesh);

/// The area, the perimeter and the diameter of an outline. The diameter is the largest distance between two points. For
/// points on a line, the perimeter is twice the line's length.
struct OutlineSize {
  double area = 0;       ///< square metres
  double perimeter = 0;  ///< metres
  double diameter = 0;   ///< metres
};

/// Measures a closed outline of points in metres, clockwise or counter-clockwise.
OutlineSize measure_outline(std::span<const Vec2> outline);

}  // namespace meristem
