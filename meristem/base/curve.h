// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

/// How the points of a curve are joined.
enum class CurveKind { spline, linear };

/// A function y(x) through given points, joined by straight lines or by the natural cubic spline (continuous second
/// derivative that is zero at both ends). Beyond the points, the function is constant with the value of the nearest
/// end. Evaluation takes O(log n).
class Curve {
 public:
  /// The constant 0.
  Curve() : Curve({{0, 0}}) {}
  /// Creates a curve through points (x, y) with finite coordinates and strictly ascending x, at least one. Throws
  /// std::invalid_argument otherwise.
  explicit Curve(std::vector<Vec2> points, CurveKind kind = CurveKind::spline);

  /// Returns y at `x`.
  double operator()(double x) const;
  /// Returns dy/dx. Returns 0 outside the points. At a point of a linear curve, returns the slope of the piece to the
  /// right.
  double slope(double x) const;

  const std::vector<Vec2>& points() const { return points_; }  ///< (x, y), ascending by x
  CurveKind kind() const { return kind_; }                     ///< how the points are joined
  bool operator==(const Curve& other) const { return points_ == other.points_ && kind_ == other.kind_; }

 private:
  std::size_t piece(double x) const;

  std::vector<Vec2> points_;
  std::vector<double> second_;  // second derivatives at the points; empty for linear curves
  CurveKind kind_;
};

}  // namespace meristem
