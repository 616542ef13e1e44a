// SPDX-License-Identifier: Apache-2.0
// The natural cubic spline by its second derivatives at the points, from one tridiagonal system.
//
// Based on: J. Stoer, R. Bulirsch: Introduction to Numerical Analysis, section 2.4 (moments of a cubic spline).
#include "meristem/base/curve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace meristem {

namespace {

/// Second derivatives of the natural spline at the points, by elimination without pivoting (Thomas), which is stable
/// here because the diagonal dominates.
std::vector<double> natural_moments(const std::vector<Vec2>& points) {
  const std::size_t count = points.size();
  std::vector<double> second(count, 0.0);
  if (count < 3) return second;
  const auto width = [&](std::size_t k) { return double{points[k + 1].x} - double{points[k].x}; };
  const auto slope = [&](std::size_t k) { return (double{points[k + 1].y} - double{points[k].y}) / width(k); };

  // Eliminate downwards: row k then reads second[k] + ratio[k] * second[k + 1] = second[k] as stored.
  std::vector<double> ratio(count, 0.0);
  for (std::size_t k = 1; k + 1 < count; ++k) {
    const double diagonal = 2 * (width(k - 1) + width(k)) - width(k - 1) * ratio[k - 1];
    ratio[k] = width(k) / diagonal;
    second[k] = (6 * (slope(k) - slope(k - 1)) - width(k - 1) * second[k - 1]) / diagonal;
  }
  // Substitute upwards.
  for (std::size_t k = count - 1; k-- > 1;) second[k] -= ratio[k] * second[k + 1];
  return second;
}

}  // namespace

Curve::Curve(std::vector<Vec2> points, CurveKind kind) : points_(std::move(points)), kind_(kind) {
  if (points_.empty()) throw std::invalid_argument("a curve needs a point");
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (!std::isfinite(points_[k].x) || !std::isfinite(points_[k].y)) {
      throw std::invalid_argument("a curve's points are finite");
    }
    if (k > 0 && points_[k].x <= points_[k - 1].x) throw std::invalid_argument("a curve's points rise in x");
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

/// The index of the piece that holds x; the first or last one for an x outside.
std::size_t Curve::piece(double x) const {
  const auto after = std::upper_bound(points_.begin() + 1, points_.end() - 1, x,
                                      [](double value, Vec2 point) { return value < point.x; });
  return static_cast<std::size_t>(after - points_.begin()) - 1;
}

}  // namespace meristem
