// SPDX-License-Identifier: Apache-2.0
// The natural cubic spline by its second derivatives at the points, from one tridiagonal system.
//
// Based on: J. Stoer, R. Bulirsch: Introduction to Numerical Analysis, section 2.4 (moments of a cubic spline).
#include "meristem/base/curve_values.h"

#include <algorithm>

namespace meristem {

/// Solves by elimination without pivoting (Thomas), which is stable here because the diagonal dominates.
std::vector<double> natural_moments(std::span<const Vec2> points) {
  const std::size_t count = points.size();
  std::vector<double> second(count, 0.0);
  if (count < 3) return second;
  const auto width = [&](std::size_t k) { return double{points[k + 1].x} - double{points[k].x}; };
  const auto slope = [&](std::size_t k) { return (double{points[k + 1].y} - double{points[k].y}) / width(k); };

  // Eliminate downwards. Row k then means second[k] + ratio[k] * second[k + 1] = the stored second[k].
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

CurvePositions::CurvePositions(std::span<const Vec2> points, std::span<const double> rising)
    : count_(rising.size()),
      first_(points.size() + 1),
      parts_(std::make_unique_for_overwrite<double[]>(4 * count_)),
      left_(parts_.get()),
      right_(left_ + count_),
      left_bend_(right_ + count_),
      right_bend_(left_bend_ + count_) {
  std::size_t next = 0;
  while (next < rising.size() && rising[next] <= points.front().x) ++next;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    first_[k] = next;
    while (next < rising.size() && rising[next] < points[k + 1].x) ++next;
    const double from = points[k].x;
    const double width = double{points[k + 1].x} - from;
    for (std::size_t i = first_[k]; i < next; ++i) {
      const double b = (rising[i] - from) / width;
      const double a = 1 - b;
      left_[i] = a;
      right_[i] = b;
      left_bend_[i] = a * a * a - a;
      right_bend_[i] = b * b * b - b;
    }
  }
  first_[points.size() - 1] = next;
  first_[points.size()] = rising.size();
}

std::vector<double> CurvePositions::values(std::span<const Vec2> points, CurveKind kind) const {
  std::vector<double> values(count_, points.back().y);
  std::fill_n(values.begin(), first_[0], points.front().y);
  const std::vector<double> moments = kind == CurveKind::spline ? natural_moments(points) : std::vector<double>();
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const double left = points[k].y;
    const double right = points[k + 1].y;
    for (std::size_t i = first_[k]; i < first_[k + 1]; ++i) values[i] = left_[i] * left + right_[i] * right;
    if (kind == CurveKind::linear) continue;
    const double width = double{points[k + 1].x} - double{points[k].x};
    const double square = width * width / 6;
    for (std::size_t i = first_[k]; i < first_[k + 1]; ++i) {
      values[i] += (left_bend_[i] * moments[k] + right_bend_[i] * moments[k + 1]) * square;
    }
  }
  return values;
}

}  // namespace meristem
