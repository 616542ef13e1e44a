// SPDX-License-Identifier: Apache-2.0
// Curves for callers that need many values at once.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "meristem/base/curve.h"

namespace meristem {

/// Returns the second derivatives, at the points, of the natural cubic spline through the points.
std::vector<double> natural_moments(std::span<const Vec2> points);

/// Ascending positions on curves whose points have equal x. The positions are located once for all curves, without a
/// search for each position.
class CurvePositions {
 public:
  /// Locates the positions. The cost is linear in points and positions.
  CurvePositions(std::span<const Vec2> points, std::span<const double> rising);

  /// Returns the values of Curve(points, kind) at the positions. `points` must have the x of the points in the
  /// constructor.
  std::vector<double> values(std::span<const Vec2> points, CurveKind kind) const;

 private:
  std::size_t count_;                // number of positions
  std::vector<std::size_t> first_;   // for each piece, its first position; and last, the first position beyond all
                                     // pieces
  std::unique_ptr<double[]> parts_;  // memory of the four arrays below, only for positions on pieces
  // For each position, the weights of the values at the ends of its piece, and the weights of the second derivatives
  // there, in squares of widths.
  double *left_, *right_, *left_bend_, *right_bend_;
};

}  // namespace meristem
