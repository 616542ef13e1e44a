// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"

namespace meristem {

/// The convex hull of points (finite, metres) as a closed mesh without normals: its vertices are among the points, its
/// triangles face outward. Points that lie in one plane, nearly so, or are fewer than four have no hull: an empty mesh.
/// Throws Cancelled if `progress`, where given, was cancelled; it is checked every few milliseconds.
Mesh convex_hull(std::span<const Vec3> points, const Progress* progress = nullptr);

/// The convex hull of points in a plane, counter-clockwise from the lowest x (of these the lowest y), without points in
/// the middle of edges. Points on a line give its two ends, equal ones one.
std::vector<Vec2> convex_outline(std::vector<Vec2> points);

/// Square metres of all triangles, one side.
double surface_area_of(const Mesh& mesh);

/// Cubic metres within a closed mesh whose triangles face outward.
double volume_of(const Mesh& mesh);

/// An outline's area, length around and largest distance between two of its points. For points on a line the length
/// around is twice the line's.
struct OutlineSize {
  double area = 0;       ///< square metres
  double perimeter = 0;  ///< metres
  double diameter = 0;   ///< metres
};

/// The size of a closed outline of points in metres, counter-clockwise or not.
OutlineSize measure_outline(std::span<const Vec2> outline);

}  // namespace meristem
