// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/shape/grass/grass_leaf.h"
#include "meristem/shape/grass/measured_leaves.h"

namespace meristem {

/// How closely a fitted leaf follows its digitised points.
struct FitOptions {
  /// How far the midrib may be from its digitised points, root mean square, as a share of its length; raised, smoother;
  /// 0: the points joined as they are.
  double smoothing = 0.0025;
  double width_smoothing = 0.01;  ///< how far widths may be from the digitised ones, as a share of the largest
  int pieces = 48;                ///< equal pieces of the fitted midrib; raised, it follows the spline more closely
};

/// A smoothing spline through a digitised midrib, which begins at its first point.
struct FittedMidrib {
  GrassLeaf leaf;              ///< leaf of equal pieces, 1 long and of constant width
  double length = 0;           ///< in the unit of the points
  double polyline_length = 0;  ///< length of the digitised points joined by lines
  double distance = 0;         ///< root mean square distance of the digitised points from the fitted midrib
};

/// Throws InputError by check_midrib, and std::invalid_argument for options out of range. Cost: points times pieces,
/// for their distance.
FittedMidrib fit_midrib(const MeasuredCurve& midrib, const FitOptions& options = {});

/// Smoothed widths along a blade, from base to tip; both ends stay as measured.
struct FittedWidths {
  std::vector<double> r;    ///< share of the largest at the points of equal pieces
  double width = 0;         ///< the largest, as measured
  double length = 0;        ///< the last position, as measured
  bool are_shares = false;  ///< the positions are shares of the length: they end at 1, or from 0.9 on
  /// Whether the widths are shares, too: their largest is about 1.
  bool are_widths_shares() const { return are_shares && width > 0.9 && width < 1.01; }
  bool was_turned = false;  ///< the points ran from the tip to the base
};

/// Throws InputError by check_widths, and std::invalid_argument for options out of range.
FittedWidths fit_widths(const MeasuredCurve& widths, const FitOptions& options = {});

/// A leaf fitted to measured points, and the quality of the fit.
struct FittedLeaf {
  GrassLeaf leaf;              ///< the fitted leaf
  double midrib_length = 0;    ///< as of FittedMidrib, in the unit of the points
  double polyline_length = 0;  ///< length of the points joined by lines, in their unit
  double distance = 0;         ///< root mean square, of the points from the fitted midrib
  bool was_turned = false;     ///< widths ran from the tip to the base
};

/// Both together. Each is taken over its own length from base to tip, since those who digitise leaves that stand catch
/// less than all of them. Where the positions of the widths are shares, the leaf is as long as its midrib; else as the
/// blade along which widths were measured.
FittedLeaf fit_leaf(const MeasuredCurve& midrib, const MeasuredCurve& widths, const FitOptions& options = {});

}  // namespace meristem
