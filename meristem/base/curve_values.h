// SPDX-License-Identifier: Apache-2.0
// Curves, for those that need many values at once.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "meristem/base/curve.h"

namespace meristem {

/// Second derivatives at the points of the natural cubic spline through them.
std::vector<double> natural_moments(std::span<const Vec2> points);

/// Rising positions along curves that share their points' x: found once, without a search for each, for all of them.
class CurvePositions {
 public:
  /// Cost is linear in points and positions.
  CurvePositions(std::span<const Vec2> points, std::span<const double> rising);

  /// The values of Curve(points, kind) at the positions; `points` have the x of the others.
  std::vector<double> values(std::span<const Vec2> points, CurveKind kind) const;

 private:
  std::size_t count_;                // of positions
  std::vector<std::size_t> first_;   // by piece, of the positions in it; and those beyond the last
  std::unique_ptr<double[]> parts_;  // what follows, in one piece of memory, and only of the positions on pieces
  // By position, how much of the piece's ends its value has, and how much of the second derivatives there, in squares
  // of widths.
  double *left_, *right_, *left_bend_, *right_bend_;
};

}  // namespace meristem
