// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include "meristem/shape/grass/grass_leaf.h"
#include "meristem/shape/grass/measured_leaves.h"

namespace meristem {

struct FitOptions {
  /// How far the midrib may be from its digitised points, root mean square, as a share of its length; raised, smoother;
  /// 0: the points joined as they are.
  double smoothing = 0.0025;
  double width_smoothing = 0.01;  ///< the same for the widths, as a share of the largest
  int pieces = 48;                ///< equal pieces of the fitted midrib; raised, it follows the spline more closely
};

/// A leaf fitted to measured points, with what can be said of the fit.
struct FittedLeaf {
  GrassLeaf leaf;
  double midrib_length = 0;    ///< of the fitted midrib, in the unit of its points
  double polyline_length = 0;  ///< of the digitised points joined by lines
  double distance = 0;         ///< root mean square distance of the digitised points from the fitted midrib
  bool was_turned = false;     ///< the widths ran from the tip to the base
};

/// Fits smoothing splines to a midrib and to the widths along a blade. The midrib begins at its first point. Both are
/// taken over their own length from base to tip, since those who digitise leaves that stand catch less than all of
/// them. Where the places of the widths end at 1 they are shares of the length, which then is the midrib's; else they
/// are in the unit of the points, and their last one is the blade's length. Throws InputError by check_midrib and
/// check_widths, and std::invalid_argument for options out of range. Cost: linear in points and pieces.
FittedLeaf fit_leaf(const MeasuredCurve& midrib, const MeasuredCurve& widths, const FitOptions& options = {});

}  // namespace meristem
