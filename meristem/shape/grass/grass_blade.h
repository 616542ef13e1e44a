// SPDX-License-Identifier: Apache-2.0
// The blade of a grass leaf over its midrib, and what holds it to the stem.
#pragma once

#include <functional>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/base/mesh.h"
#include "meristem/base/vec.h"
#include "meristem/shape/grass/grass_leaf.h"

namespace meristem {

/// Edge waves. Their height rises with the square of the distance from the midrib, where it is 0.
struct EdgeWaves {
  double number = 0;   ///< from base to tip
  double depth = 0;    ///< depth of the crests at the edge, as a share of half the blade's width there
  double left = 0;     ///< phase of the left edge, radians; seen from above with the tip ahead
  double right = kPi;  ///< phase of the right edge, radians
};

/// What bends the blade's sections. Angles in radians.
struct GrassBlade {
  double twist = 0;                                        ///< torsion about the midrib from base to tip
  Curve twist_along{{{0, 0}, {1, 1}}, CurveKind::linear};  ///< share of it that is reached, over the position
  double fold = 0;                                         ///< angle of each half above the flat blade: a V
  double roll = 0;          ///< bend from edge to edge where the blade is widest; raised, the edges rise more
  EdgeWaves waves;          ///< waves along the edges
  int across = 2;           ///< quads from edge to edge, an even number
  double clasp = 0;         ///< share of the length over which the blade unrolls from the sheath's round
  double clasp_radius = 0;  ///< radius of the sheath's round, metres; 0: the blade begins as it goes on
  /// Moves the point at the position s (0 to 1) and u (-0.5 to 0.5 across): away from the stem, along it, and across,
  /// in widths of the blade. Empty: not at all. The source's f, g and h.
  std::function<DVec3(double s, double u)> displace;
};

/// Torsion at a position, radians.
double torsion(const GrassBlade& blade, double place);

/// How far twist, waves, clasp and displacement move the edges and the midrib away from those of a flat blade:
/// lists of one number per point of the leaf, in lengths, for a reduction to keep. None where nothing does.
std::vector<std::vector<double>> blade_relief(const GrassLeaf& leaf, const GrassBlade& blade);

/// The blade on all points of the leaf (smooth normals, front face up; u across, 0 to 1 where it is widest, v from base
/// to tip). Its frame: the collar at the origin, y along the stem, the midrib leading away to -z, so that a blade that
/// stands up has its upper face to the stem, at +z. Where a width is nothing at either end, there is one point. Widths
/// along the surface are those of the leaf, whatever twists and folds it. Throws std::invalid_argument by
/// check_grass_leaf, for an odd `across` or one below 2, and for numbers that are not finite.
Mesh make_grass_blade(const GrassLeaf& leaf, const GrassBlade& blade);

/// A sheath: an open tube of radius 1 from the collar at the origin down to y = -1, about the y axis. It is open at +z
/// by `open` radians. Its front is outside. u goes around, v up.
Mesh make_sheath(double open);

/// A ligule: a membrane that goes on from the upper rim of such a sheath on the blade's side, 1 high in its middle,
/// with a front to either side.
Mesh make_ligule();

}  // namespace meristem
