// SPDX-License-Identifier: Apache-2.0
// A leaf blade: a flat outline from base to tip, bent along and across.
#pragma once

#include <cstddef>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/base/mesh.h"
#include "meristem/shape/texture/texture_recipe.h"

namespace meristem {

/// The parameters of a leaf blade. Angles in radians, lengths in metres. In the blade's own frame, its joint with the
/// petiole is at the origin, y goes along the midrib there, and z out of the upper face.
struct LeafBlade {
  /// The form of a polygon's corners.
  enum class Corners { sharp, round };
  /// Whether the mesh follows the outline, or the texture cuts out the outline.
  enum class Edge { shape, picture };

  double length = 0.08;  ///< length of the midrib from the joint to the tip
  double width = 0.05;   ///< width at the widest position
  /// Half width as a function of length, both from 0 to 1. Values below 0 count as 0.
  Curve outline{{{0.0F, 0.0F}, {0.25F, 0.75F}, {0.5F, 1.0F}, {0.8F, 0.6F}, {1.0F, 0.0F}}};
  /// Replaces the outline if not empty: the right edge as points (half width, along) from the joint (0, 0) to the tip
  /// (0, 1). These two may be omitted. The edge may go back and forth along the midrib, as lobes do, and extend beyond
  /// both ends, but must not touch the midrib or itself.
  std::vector<Vec2> polygon;
  Corners corners = Corners::sharp;  ///< corners of the polygon; round cuts off each of them in three short steps
  double heart = 0;                  ///< how far the base extends back beside the joint, as a share of the length
  int teeth = 0;                     ///< teeth per side
  double teeth_depth = 0.1;          ///< depth of the largest tooth, as a share of half the width
  double teeth_lean = 0.6;           ///< 0: symmetric teeth, as of a saw that cuts both ways; toward 1: steeper on the
                                     ///< side of the tip

  double curl = 0;           ///< total bend of the midrib from joint to tip; positive: the tip sinks
  double curl_across = 0;    ///< total bend across the widest position, from edge to edge; positive: the edges sink
  double fold = 0;           ///< angle of each half above the flat blade: a V seen from the base
  Curve profile;             ///< height as a function of the distance from the midrib (0 to 1), in shares of half the
                             ///< width
  int waves = 0;             ///< number of waves along each edge, each with at least four rows
  double waves_depth = 0.1;  ///< height of the waves' crests as a share of half the width
  double petiole = 0;        ///< length of the petiole before the blade
  double petiole_radius = 0.001;  ///< radius of the petiole

  /// Quads along the blade. More follow outline and curl more closely. Rows are placed where outline and curl need
  /// them. Each lobe and bay of the outline gets a row even if this needs more quads.
  int rows = 6;
  int across = 2;  ///< quads across, an even number, so that a row of points is the midrib
  /// picture: the mesh is a convex hull of about at most `rows` edges per side, and the texture cuts out the edge.
  Edge edge = Edge::shape;
};

/// Returns the blade (front face up, normals smooth). If `petiole` is above 0, it has a petiole as a thin three-sided
/// tube. u goes across, from 0 to 1 at the widest position. v goes along, from 0 at the lowest point of the outline to
/// 1 at the highest, so that a picture of the leaf is not distorted. The petiole's uvs lie on the midrib. Where the
/// outline is 0, the blade has a single vertex and no degenerate triangles. The leaf with its petiole begins at the
/// origin. Curl and fold keep lengths along and across the midrib. Throws std::invalid_argument for lengths or a width
/// that are not positive, a negative petiole, numbers that are not finite, fewer than 1 row, or `across` odd or below
/// 2.
Mesh make_leaf_blade(const LeafBlade& blade);

/// Returns the number of triangles of make_leaf_blade without making the mesh: the flat outline is cut, but no point is
/// put on the bent surface. Throws like make_leaf_blade.
std::size_t leaf_blade_triangles(const LeafBlade& blade);

/// Returns the shape that the uvs show: the closed outline with lobes, heart and teeth.
TextureShape leaf_texture_shape(const LeafBlade& blade);

}  // namespace meristem
