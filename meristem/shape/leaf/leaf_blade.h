// SPDX-License-Identifier: Apache-2.0
// A leaf blade: a flat outline from base to tip, bent along and across.
#pragma once

#include <vector>

#include "meristem/base/curve.h"
#include "meristem/base/mesh.h"
#include "meristem/shape/texture/texture_recipe.h"

namespace meristem {

/// Angles in radians, lengths in metres. The blade's own frame: its joint with the stalk at the origin, y along the
/// midrib there, z out of the upper face.
struct LeafBlade {
  /// The form of a polygon's corners.
  enum class Corners { sharp, round };
  /// Whether the mesh follows the outline, or the texture cuts it out.
  enum class Edge { shape, picture };

  double length = 0.08;  ///< length of the midrib from the joint to the tip
  double width = 0.05;   ///< across at the widest
  /// Half width over length, both from 0 to 1; below 0 counts as 0.
  Curve outline{{{0.0F, 0.0F}, {0.25F, 0.75F}, {0.5F, 1.0F}, {0.8F, 0.6F}, {1.0F, 0.0F}}};
  /// Instead of the outline, if not empty: the right edge as points (half width, along) from the joint (0, 0) to the
  /// tip (0, 1), which need not be given themselves. It may go back and forth along the midrib, as lobes do, and reach
  /// beyond both its ends, but never touches it or itself.
  std::vector<Vec2> polygon;
  Corners corners = Corners::sharp;  ///< corners of the polygon; round cuts each of them off in three short steps
  double heart = 0;                  ///< how far the base reaches back beside the joint, as a share of the length
  int teeth = 0;                     ///< a side
  double teeth_depth = 0.1;          ///< depth of the largest tooth, as a share of half the width
  double teeth_lean = 0.6;           ///< 0 like a saw cut both ways, toward 1 steeper on the side of the tip

  double curl = 0;           ///< total bend of the midrib from joint to tip; positive: the tip sinks
  double curl_across = 0;    ///< total bend across the widest point, from edge to edge; positive: the edges sink
  double fold = 0;           ///< angle of each half above the flat blade: a V from above
  Curve profile;             ///< height over the distance from the midrib (0 to 1), both in shares of half the width
  int waves = 0;             ///< along each edge; each has at least four rows
  double waves_depth = 0.1;  ///< height of their crests as a share of half the width
  double petiole = 0;        ///< length of the stalk before the blade
  double petiole_radius = 0.001;  ///< radius of the stalk

  /// Quads along; more follow outline and curl more closely. They stand where outline and curl need them; each lobe and
  /// bay of the outline gets its row even where that takes more of them.
  int rows = 6;
  int across = 2;  ///< quads across, even, so that a row of points is the midrib
  /// picture: the mesh is a convex hull of at most about `rows` edges per side, and the texture cuts the edge out.
  Edge edge = Edge::shape;
};

/// The blade (front face up, normals smooth), with its stalk as a thin three-sided tube if `petiole` is above 0. u goes
/// across, from 0 to 1 at the widest, v along, from 0 at the lowest point of the outline to 1 at the highest, so that a
/// picture of the leaf lies on it undistorted; the stalk's lie on the midrib. Vertices coincide in one point where the
/// outline is 0, without degenerate triangles. The whole leaf, stalk included, starts at the origin. Lengths along the
/// midrib and across it are kept under curl and fold. Throws std::invalid_argument for lengths or a width that are not
/// positive, a negative petiole, numbers that are not finite, fewer than 1 row, or `across` odd or below 2.
Mesh make_leaf_blade(const LeafBlade& blade);

/// What its uvs show: the closed outline with lobes, heart and teeth.
TextureShape leaf_texture_shape(const LeafBlade& blade);

}  // namespace meristem
