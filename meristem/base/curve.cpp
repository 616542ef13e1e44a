// SPDX-License-Identifier: Apache-2.0
// Evaluates a function through points, as straight lines or as the natural cubic spline. The second derivatives at the
// points are found once (curve_values.h), and each value then needs a binary search and one cubic.
#include "meristem/base/curve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "meristem/base/curve_values.h"

namespace meristem {

Curve::Curve(std::vector<Vec2> points, CurveKind kind) : points_(std::move(points)), kind_(kind) {
  if (points_.empty()) throw std::invalid_argument("a curve needs at least one point");
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (!std::isfinite(points_[k].x) || !std::isfinite(points_[k].y)) {
      throw std::invalid_argument("a curve's points must be finite");
    }
    if (k > 0 && points_[k].x <= points_[k - 1].x) throw std::invalid_argument("a curve's points must rise in x");
  }
  if (kind_ == CurveKind::spline) second_ = natural_moments(points_);
}

double Curve::operator()(double x) const {
  if (x <= points_.front().x) return points_.front().y;
  if (x >= points_.back().x) return points_.back().y;
  const std::size_t k = piece(x);
  const Vec2 left = points_[k];
  const Vec2 right = points_[k + 1];
  const double width = double{right.x} - double{left.x};
  const double b = (x - left.x) / width;
  const double a = 1 - b;
  const double straight = a * left.y + b * right.y;
  if (kind_ == CurveKind::linear) return straight;
  return straight + ((a * a * a - a) * second_[k] + (b * b * b - b) * second_[k + 1]) * (width * width / 6);
}

double Curve::slope(double x) const {
  const bool is_past_last_piece = kind_ == CurveKind::linear ? x >= points_.back().x : x > points_.back().x;
  if (points_.size() < 2 || x < points_.front().x || is_past_last_piece) return 0;
  const std::size_t k = piece(x);
  const Vec2 left = points_[k];
  const Vec2 right = points_[k + 1];
  const double width = double{right.x} - double{left.x};
  const double straight = (double{right.y} - double{left.y}) / width;
  if (kind_ == CurveKind::linear) return straight;
  const double b = (x - left.x) / width;
  const double a = 1 - b;
  return straight + ((3 * b * b - 1) * second_[k + 1] - (3 * a * a - 1) * second_[k]) * (width / 6);
}

/// Returns the index of the piece that contains x. Returns the first or the last piece for an x outside.
std::size_t Curve::piece(double x) const {
  const auto after = std::upper_bound(points_.begin() + 1, points_.end() - 1, x,
                                      [](double value, Vec2 point) { return value < point.x; });
  return static_cast<std::size_t>(after - points_.begin()) - 1;
}

}  // namespace meristem
