// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/shape/grass/grass_leaf.h"
#include "meristem/shape/grass/measured_leaves.h"

namespace meristem {

/// How closely a fitted leaf follows its digitised points.
struct FitOptions {
  /// Maximum root mean square distance of the midrib from its digitised points, as a share of its length. Larger values
  /// give a smoother midrib, and 0 joins the points by lines.
  double smoothing = 0.0025;
  double width_smoothing = 0.01;  ///< maximum distance of widths from the digitised widths, as a share of the largest
  int pieces = 48;                ///< equal pieces of the fitted midrib; more follow the spline more closely
};

/// A smoothing spline through a digitised midrib. It begins at the first point.
struct FittedMidrib {
  GrassLeaf leaf;              ///< leaf of equal pieces, of length 1 and constant width
  double length = 0;           ///< in the unit of the points
  double polyline_length = 0;  ///< length of the digitised points joined by lines
  double distance = 0;         ///< root mean square distance of the digitised points from the fitted midrib
};

/// Fits a midrib. Throws InputError like check_midrib, and std::invalid_argument for options out of range. The cost is
/// points times pieces, for their distance.
FittedMidrib fit_midrib(const MeasuredCurve& midrib, const FitOptions& options = {});

/// Smoothed widths along a blade, from base to tip. Both ends stay as measured.
struct FittedWidths {
  std::vector<double> r;    ///< share of the largest width at the points of equal pieces
  double width = 0;         ///< largest measured width
  double length = 0;        ///< last measured position
  bool are_shares = false;  ///< true if the positions are shares of the length, which end at 1, or at 0.9 or more
  /// Returns true if the widths are shares as well, so that the largest is about 1.
  bool are_widths_shares() const { return are_shares && width > 0.9 && width < 1.01; }
  bool was_turned = false;  ///< true if the points ran from the tip to the base
};

/// Fits widths. Throws InputError like check_widths, and std::invalid_argument for options out of range.
FittedWidths fit_widths(const MeasuredCurve& widths, const FitOptions& options = {});

/// A leaf fitted to measured points, and the quality of the fit.
struct FittedLeaf {
  GrassLeaf leaf;              ///< the fitted leaf
  double midrib_length = 0;    ///< as in FittedMidrib, in the unit of the points
  double polyline_length = 0;  ///< length of the points joined by lines, in their unit
  double distance = 0;         ///< root mean square distance of the points from the fitted midrib
  bool was_turned = false;     ///< true if the widths ran from the tip to the base
};

/// Fits a midrib and widths and combines them. Each is scaled over its own length from base to tip, since digitised
/// midribs of standing leaves are often incomplete. If the positions of the widths are shares, the leaf has the length
/// of its midrib. Otherwise it has the length of the blade along which widths were measured.
FittedLeaf fit_leaf(const MeasuredCurve& midrib, const MeasuredCurve& widths, const FitOptions& options = {});

}  // namespace meristem
