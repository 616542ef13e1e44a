// SPDX-License-Identifier: Apache-2.0
// The blade of a grass leaf over its midrib, with its sheath and ligule.
#pragma once

#include <functional>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/base/mesh.h"
#include "meristem/base/vec.h"
#include "meristem/shape/grass/grass_leaf.h"

namespace meristem {

/// Waves along the edges. Their height grows with the square of the distance from the midrib, where it is 0.
struct EdgeWaves {
  double number = 0;   ///< number of waves from base to tip
  double depth = 0;    ///< depth of the crests at the edge, as a share of half the blade's width at that position
  double left = 0;     ///< phase of the left edge, radians, as seen from above with the tip ahead
  double right = kPi;  ///< phase of the right edge, radians
};

/// The bend of the blade's cross-sections. Angles in radians.
struct GrassBlade {
  double twist = 0;                                        ///< torsion about the midrib from base to tip
  Curve twist_along{{{0, 0}, {1, 1}}, CurveKind::linear};  ///< share of the torsion that is reached, as a function of
                                                           ///< position
  double fold = 0;                                         ///< angle of each half above the flat blade, which forms a V
  double roll = 0;          ///< bend from edge to edge at the widest position; larger values raise the edges
  EdgeWaves waves;          ///< waves along the edges
  int across = 2;           ///< quads from edge to edge, an even number
  double clasp = 0;         ///< share of the length over which the blade unrolls from the round of the sheath
  double clasp_radius = 0;  ///< radius of the sheath, metres; 0: the blade does not clasp
  /// Moves the point at the position s (0 to 1) and u (-0.5 to 0.5 across): away from the stem, along it, and across,
  /// in widths of the blade. Empty: no displacement. The source's f, g and h.
  std::function<DVec3(double s, double u)> displace;
};

/// Returns the torsion at a position, radians.
double torsion(const GrassBlade& blade, double place);

/// Returns how far twist, waves, clasp and displacement move the edges and the midrib away from their positions on a
/// flat blade. The result is lists with one number per point of the leaf, in lengths, which a reduction must preserve.
/// Returns no lists if nothing is moved.
std::vector<std::vector<double>> blade_relief(const GrassLeaf& leaf, const GrassBlade& blade);

/// Returns the blade on all points of the leaf, with smooth normals and the front face up. u goes across, from 0 to 1
/// at the widest position, and v from base to tip. The collar is at the origin of the blade's frame, y goes along the
/// stem, and the midrib leads away to -z. The upper face of an upright blade therefore looks to the stem, at +z. An end
/// of width 0 is a single point. Widths along the surface equal the leaf's widths, despite twist and fold. Throws
/// std::invalid_argument like check_grass_leaf, for an odd `across` or one below 2, and for numbers that are not
/// finite.
Mesh make_grass_blade(const GrassLeaf& leaf, const GrassBlade& blade);

/// Returns a sheath: an open tube of radius 1 about the y axis, from the collar at the origin down to y = -1. It is
/// open at +z by `open` radians. The front is outside. u goes around, v up.
Mesh make_sheath(double open);

/// Returns a ligule: a membrane that continues the upper rim of such a sheath on the blade's side. It is 1 high in its
/// middle and has a front on both sides.
Mesh make_ligule();

}  // namespace meristem
