// SPDX-License-Identifier: Apache-2.0
// Bodies of revolution: a silhouette turned about the y axis.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/base/mesh.h"

namespace meristem {

/// The silhouette of a body, and the resolution of its turn.
struct SolidOfRevolution {
  /// Points (radius, height) in metres from base to tip. The body lies to the left of the path, between the path and
  /// the axis. Heights may fall, and the path may turn back inside, as for a cup.
  std::vector<Vec2> silhouette{{0.0F, 0.0F}, {0.018F, 0.008F}, {0.024F, 0.025F}, {0.016F, 0.046F}, {0.0F, 0.055F}};
  /// The curve between the points: straight lines, or natural cubic splines of radius and height as functions of the
  /// length of the lines.
  CurveKind kind = CurveKind::spline;
  int segments = 24;       ///< corners around a whole turn, at least 3; more are rounder
  int rings = 16;          ///< maximum number of quads along a spline, but at least one per pair of points; more are
                           ///< smoother
  double sweep = 2 * kPi;  ///< radians, above 0; below a whole turn the body is a wedge between two flat sides
};

/// An error in a silhouette.
struct SilhouetteError {
  std::string message;               ///< description of the error
  std::string expected;              ///< what was expected, or empty
  std::optional<std::size_t> point;  ///< index of the point at fault, if it is a single one
};

/// Returns why the silhouette does not bound a body: fewer than 2 points or more than 500, radii that are negative,
/// numbers that are not finite, repeated points, or points on the axis other than at the ends. Other reasons are a path
/// that crosses or touches itself, one that runs down around the body, and a spline that swings across the axis. Points
/// nearer than 1/100000 of the path's length count as equal. Returns nothing for a valid silhouette. O(n²) in points
/// and rings.
std::optional<SilhouetteError> find_error(const SolidOfRevolution& solid);

/// Returns the closed body with front faces outward. Where the silhouette begins or ends on the axis, it has a single
/// point, and otherwise a flat disc. Sharp edges (split vertices) surround these discs and the flat sides of wedges,
/// and lie where lines bend by more than 40°. All other edges are smooth with the silhouette's exact normals. u goes
/// around, from 0 to 1 in a whole turn from +z over +x, and v from 0 to 1 along the silhouette and its discs. On the
/// flat sides, both are as in a picture of half the body. Throws std::invalid_argument for a silhouette with an error,
/// fewer than 3 segments, fewer than 1 ring, or a sweep that is not above 0.
Mesh make_revolution(const SolidOfRevolution& solid);

/// Returns the number of triangles of make_revolution without making the mesh. Throws like make_revolution.
std::size_t revolution_triangles(const SolidOfRevolution& solid);

}  // namespace meristem
