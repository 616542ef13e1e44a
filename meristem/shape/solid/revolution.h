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

/// The silhouette of a body, and how finely it is turned.
struct SolidOfRevolution {
  /// Points (radius, height) in metres from base to tip: the body lies to the left of the way, between it and the axis.
  /// Heights may fall, and the way turn back inside, as that of a cup does.
  std::vector<Vec2> silhouette{{0.0F, 0.0F}, {0.018F, 0.008F}, {0.024F, 0.025F}, {0.016F, 0.046F}, {0.0F, 0.055F}};
  /// What joins the points: straight lines, or natural cubic splines of radius and height over the length of the
  /// lines between the points.
  CurveKind kind = CurveKind::spline;
  int segments = 24;       ///< corners around a whole turn, at least 3; raised, rounder
  int rings = 16;          ///< quads along a spline, at most, but at least one from point to point; raised, smoother
  double sweep = 2 * kPi;  ///< radians above 0; below a whole turn the body is a wedge between two flat sides
};

/// A fault of a silhouette.
struct SilhouetteFault {
  std::string message;               ///< what is wrong
  std::string expected;              ///< what was expected, or empty
  std::optional<std::size_t> point;  ///< at fault, where it is one
};

/// Why the silhouette bounds no body: fewer than 2 points or more than 500, numbers that are negative radii or not
/// finite, points that repeat, lie on the axis other than at the ends, a way that crosses or touches itself or runs
/// down around the body. Empty where it bounds one. O(n²) in points and rings.
std::optional<SilhouetteFault> find_fault(const SolidOfRevolution& solid);

/// The closed body, front faces outward. Where the silhouette begins or ends on the axis there is one point, elsewhere
/// a flat disc. Sharp edges (split vertices) stand around these discs and the flat sides of wedges, and where lines
/// bend by more than 40°; all else is smooth, with the silhouette's own normals. u goes around, from 0 to 1 in a whole
/// turn from +z over +x, v from 0 to 1 along the silhouette and its discs; on the flat sides both are as in a picture
/// of half the body. Throws std::invalid_argument for a silhouette with a fault, fewer than 3 segments, fewer than 1
/// ring, or a sweep that is not above 0.
Mesh make_revolution(const SolidOfRevolution& solid);

}  // namespace meristem
