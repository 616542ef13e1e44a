// SPDX-License-Identifier: Apache-2.0
// The needles of a shoot in one mesh: a spruce's twig, a pine's tuft, a larch's rosette.
#pragma once

#include <cstdint>

#include "meristem/base/mesh.h"

namespace meristem {

/// The parameters of a shoot. Angles in radians, lengths in metres. The shoot begins at the origin and points along y.
/// z is its upper side.
struct NeedleShoot {
  int count = 24;                  ///< bundles along the shoot
  double length = 0.02;            ///< length of a needle
  double width = 0.0012;           ///< width of a needle at its middle
  double along = 0.08;             ///< length of the shoot that bears needles; 0: all at one point
  double base_angle = 1.2;         ///< angle between shoot and needle at the beginning of the shoot
  double tip_angle = 0.7;          ///< angle between shoot and needle at the end of the shoot
  double divergence = 2.39996323;  ///< angle about the shoot from one bundle to the next
  int fascicle = 1;                ///< needles in a bundle
  double spread = 0.3;             ///< angle between the outer needles of a bundle and its middle
  double curl = 0;                 ///< bend of a needle from base to tip; positive: away from the shoot
  double flatten = 0;              ///< 0: all around; 1: combed to both sides, in one plane
  double irregular = 0.15;         ///< variation of lengths and directions, as a share
  int sides = 2;                   ///< 2: flat, two triangles; 3: a spike, three triangles
  double axis_radius = 0;          ///< radius of a thin three-sided twig along the shoot; 0: no twig
  std::uint64_t variant = 0;       ///< another number gives another shoot of the same kind
};

/// Returns `count * fascicle` needles (normals smooth; u across, v from base to tip). Adds the twig if it has a radius
/// and a length. Needles widen toward their middle and end in a point. Throws std::invalid_argument for lengths or
/// widths that are not positive, a negative `along` or `axis_radius`, and numbers that are not finite. Also throws for
/// `flatten` or `irregular` outside 0 to 1, fewer than 1 bundle or needle per bundle, and `sides` other than 2 and 3.
Mesh make_needles(const NeedleShoot& shoot);

}  // namespace meristem
