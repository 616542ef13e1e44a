// SPDX-License-Identifier: Apache-2.0
// A leaf blade: rows of points from base to tip, as wide as the outline says, bent along and across.
#pragma once

#include "meristem/base/curve.h"
#include "meristem/base/mesh.h"

namespace meristem {

/// Angles in radians, lengths in metres. The blade's own frame: base at the origin, y along the midrib at its base, z out
/// of the upper face.
struct LeafBlade {
  double length = 0.08;
  double width = 0.05;       ///< across at the widest
  Curve outline{{{0.0F, 0.0F}, {0.25F, 0.75F}, {0.5F, 1.0F}, {0.8F, 0.6F}, {1.0F, 0.0F}}};  ///< half width over length, both from 0 to 1
  double curl = 0;           ///< total bend of the midrib from base to tip; positive: the tip sinks
  double curl_across = 0;    ///< total bend across, from edge to edge; positive: the edges sink
  double fold = 0;           ///< angle by which each half is raised about the midrib, a V from above
  double petiole = 0;        ///< length of the stalk before the blade
  double petiole_radius = 0.001;
  int rows = 6;              ///< quads along; more follow outline and curl more closely
  int across = 2;            ///< quads across, even, so that a row of points is the midrib
};

/// The blade (front face up, normals smooth, u across from 0 to 1, v along from 0 to 1), with its stalk as a thin
/// three-sided tube if `petiole` is above 0. Vertices coincide in one point where the outline is 0, without degenerate
/// triangles. The whole leaf, stalk included, starts at the origin.
Mesh make_leaf_blade(const LeafBlade& blade);

}  // namespace meristem
