// SPDX-License-Identifier: Apache-2.0
// A leaf blade: rows of points from base to tip, as wide as the outline says, bent along and across.
#pragma once

#include "meristem/base/curve.h"
#include "meristem/base/mesh.h"

namespace meristem {

/// Angles in radians, lengths in metres. The blade's own frame: base at the origin, y along the midrib at its base, z
/// out of the upper face.
struct LeafBlade {
  double length = 0.08;
  double width = 0.05;  ///< across at the widest
  /// Half width over length, both from 0 to 1; below 0 counts as 0.
  Curve outline{{{0.0F, 0.0F}, {0.25F, 0.75F}, {0.5F, 1.0F}, {0.8F, 0.6F}, {1.0F, 0.0F}}};
  double curl = 0;         ///< total bend of the midrib from base to tip; positive: the tip sinks
  double curl_across = 0;  ///< total bend across the widest place, from edge to edge; positive: the edges sink
  double fold = 0;         ///< angle by which each half is raised about the midrib, a V from above
  double petiole = 0;      ///< length of the stalk before the blade
  double petiole_radius = 0.001;
  /// Quads along; more follow outline and curl more closely. They stand where outline and curl need them; each lobe and
  /// bay of the outline gets its row even where that takes more of them.
  int rows = 6;
  int across = 2;  ///< quads across, even, so that a row of points is the midrib
};

/// The blade (front face up, normals smooth, u across from 0 to 1 at the widest, v along from 0 to 1, so that a picture
/// of the leaf lies on it undistorted), with its stalk as a thin three-sided tube if `petiole` is above 0. Vertices
/// coincide in one point where the outline is 0, without degenerate triangles. The whole leaf, stalk included, starts
/// at the origin. Lengths along the midrib and across it are kept under curl and fold. Throws std::invalid_argument for
/// lengths or a width that are not positive, a negative petiole, angles that are not finite, fewer than 1 row, or
/// `across` odd or below 2.
Mesh make_leaf_blade(const LeafBlade& blade);

}  // namespace meristem
