// SPDX-License-Identifier: Apache-2.0
// Both coordinates of the midrib are functions of the length of the chords up to there, and smoothed as one. The spline
// is then followed in small steps to points that are evenly far apart along it; the leaf keeps the directions between
// these, so that its pieces are exactly as long as it says.
// Based on: Fournier and Pradal (2012), section 2.2.
#include "meristem/shape/grass/fit_leaf.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "meristem/base/curve.h"
#include "meristem/base/smoothing_spline.h"
#include "meristem/base/vec.h"

namespace meristem {

namespace {

constexpr double kEndWeight = 1000;  // of the points that stay: where a blade is held, and both ends of its widths
constexpr int kSteps = 8;            // along the spline, a piece
constexpr double kWhole = 1e-6;      // from 1, where the places of widths are shares

using Points = std::vector<glm::dvec2>;

/// The length of the chords up to each point.
std::vector<double> chord_lengths(const Points& points) {
  std::vector<double> lengths{0};
  for (std::size_t k = 1; k < points.size(); ++k)
    lengths.push_back(lengths.back() + glm::distance(points[k - 1], points[k]));
  return lengths;
}

/// The distance of smooth_values that lets points be `distance` off in the mean, if heavy ones are not.
double weighted(double distance, const std::vector<double>& weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  return distance * std::sqrt(static_cast<double>(weights.size()) / sum);
}

Curve through(const std::vector<double>& x, const std::vector<double>& y, CurveKind kind) {
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < x.size(); ++k) points.emplace_back(static_cast<float>(x[k]), static_cast<float>(y[k]));
  return Curve(std::move(points), kind);
}

/// Points along the fitted midrib, close together; the whole digitised one is 1 long.
Points follow_midrib(const Points& points, const std::vector<double>& lengths, const FitOptions& options) {
  const double length = lengths.back();
  std::vector<double> places, x, y, weights(points.size(), 1);
  for (std::size_t k = 0; k < points.size(); ++k) {
    places.push_back(lengths[k] / length);
    x.push_back((points[k].x - points[0].x) / length);
    y.push_back((points[k].y - points[0].y) / length);
  }
  weights.front() = kEndWeight;
  const auto smooth = smooth_values(places, {x, y}, weighted(options.smoothing, weights), weights);
  const CurveKind kind = options.smoothing > 0 ? CurveKind::spline : CurveKind::linear;
  const Curve fitted_x = through(places, smooth[0], kind), fitted_y = through(places, smooth[1], kind);
  Points followed;
  const int steps = std::max(options.pieces, static_cast<int>(points.size())) * kSteps;
  for (int k = 0; k <= steps; ++k) {
    const double place = static_cast<double>(k) / steps;
    followed.emplace_back(fitted_x(place), fitted_y(place));
  }
  return followed;
}

double distance_to_segment(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 along = b - a;
  const double square = glm::dot(along, along);
  const double share = square > 0 ? std::clamp(glm::dot(point - a, along) / square, 0.0, 1.0) : 0;
  return glm::distance(point, a + share * along);
}

/// Root mean square over `points` of the distance to the nearest place on `curve`.
double mean_distance(const Points& points, const Points& curve) {
  double squares = 0;
  for (const glm::dvec2 point : points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
      nearest = std::min(nearest, distance_to_segment(point, curve[k], curve[k + 1]));
    }
    squares += nearest * nearest;
  }
  return std::sqrt(squares / static_cast<double>(points.size()));
}

/// Equal pieces along the points, which are scaled so that these are 1 long together.
GrassLeaf even_midrib(const Points& followed, std::size_t pieces) {
  const std::vector<double> lengths = chord_lengths(followed);
  GrassLeaf leaf{.s = {}, .x = {}, .y = {}, .r = {}};
  std::size_t k = 0;
  for (std::size_t i = 0; i <= pieces; ++i) {
    const double share = i == pieces ? 1 : static_cast<double>(i) / static_cast<double>(pieces);
    const double place = share * lengths.back();
    while (k + 2 < lengths.size() && lengths[k + 1] < place) ++k;
    const double step = lengths[k + 1] - lengths[k];
    const glm::dvec2 point =
        glm::mix(followed[k], followed[k + 1], step > 0 ? std::min(1.0, (place - lengths[k]) / step) : 0);
    leaf.s.push_back(share);
    leaf.x.push_back(point.x - followed[0].x);
    leaf.y.push_back(point.y - followed[0].y);
  }
  leaf.r.assign(leaf.s.size(), 1);
  return resampled(leaf, pieces);
}

/// Smoothed widths as shares of the largest measured one, over the share of the length.
Curve smooth_widths(const Points& points, double smoothing) {
  std::vector<double> places, widths;
  double largest = 0;
  // A place that is not measured has the width of the next one.
  if (points.front().x > 0) {
    places.push_back(0);
    widths.push_back(points.front().y);
  }
  for (const glm::dvec2 point : points) {
    places.push_back(point.x / points.back().x);
    widths.push_back(point.y);
    largest = std::max(largest, point.y);
  }
  std::vector<double> weights(places.size(), 1);
  weights.front() = weights.back() = kEndWeight;
  std::vector<double> smooth = smooth_values(places, {widths}, weighted(smoothing * largest, weights), weights)[0];
  for (double& width : smooth) width = std::max(0.0, width / largest);
  return through(places, smooth, smoothing > 0 ? CurveKind::spline : CurveKind::linear);
}

void check_options(const FitOptions& options) {
  const auto is_share = [](double value) { return std::isfinite(value) && value >= 0 && value <= 1; };
  if (!is_share(options.smoothing) || !is_share(options.width_smoothing)) {
    throw std::invalid_argument("the smoothing of a fit is from 0 to 1");
  }
  if (options.pieces < 2) throw std::invalid_argument("a fitted leaf has at least 2 pieces");
}

}  // namespace

FittedMidrib fit_midrib(const MeasuredCurve& midrib, const FitOptions& options) {
  check_options(options);
  check_midrib(midrib);
  FittedMidrib fitted;
  const std::vector<double> lengths = chord_lengths(midrib.points);
  fitted.polyline_length = lengths.back();
  Points followed = follow_midrib(midrib.points, lengths, options);
  for (glm::dvec2& point : followed) point = midrib.points[0] + fitted.polyline_length * point;
  fitted.length = chord_lengths(followed).back();
  fitted.distance = mean_distance(midrib.points, followed);
  fitted.leaf = even_midrib(followed, static_cast<std::size_t>(options.pieces));
  return fitted;
}

FittedWidths fit_widths(const MeasuredCurve& widths, const FitOptions& options) {
  check_options(options);
  check_widths(widths);
  FittedWidths fitted;
  MeasuredCurve from_base = widths;
  fitted.was_turned = turn_to_base(from_base);
  fitted.length = from_base.points.back().x;
  fitted.are_shares = std::abs(fitted.length - 1) < kWhole;
  const Curve smooth = smooth_widths(from_base.points, options.width_smoothing);
  double largest = 0;
  for (int k = 0; k <= options.pieces; ++k) {
    fitted.r.push_back(std::max(0.0, smooth(static_cast<double>(k) / options.pieces)));
    largest = std::max(largest, fitted.r.back());
  }
  for (double& share : fitted.r) share /= largest;
  for (const glm::dvec2 point : from_base.points) fitted.width = std::max(fitted.width, point.y);
  fitted.width *= largest;
  return fitted;
}

FittedLeaf fit_leaf(const MeasuredCurve& midrib, const MeasuredCurve& widths, const FitOptions& options) {
  FittedMidrib along = fit_midrib(midrib, options);
  FittedWidths across = fit_widths(widths, options);
  FittedLeaf fitted{std::move(along.leaf), along.length, along.polyline_length, along.distance, across.was_turned};
  fitted.leaf.r = std::move(across.r);
  fitted.leaf.width = across.width;
  fitted.leaf.length = across.are_shares ? along.length : across.length;
  return fitted;
}

}  // namespace meristem
