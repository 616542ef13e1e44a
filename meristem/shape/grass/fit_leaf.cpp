// SPDX-License-Identifier: Apache-2.0
// Both coordinates of the midrib are functions of the length of the chords up to there, and smoothed as one. The spline
// is then followed in small steps to points on it that are equally far apart; these are the leaf's. Tried first: points
// equally far apart along the spline. Where a leaf is broken their chords are shorter, and making them equal moved the
// rest of the leaf by up to 1.5 % of its length.
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
#include "meristem/shape/flat/segment.h"

namespace meristem {

namespace {

constexpr double kEndWeight = 1000;   // of the points that stay: where a blade is held, and both ends of its widths
constexpr int kSteps = 8;             // along the spline, a piece
constexpr int kEvenings = 20;         // rounds at most that make chords equally long
constexpr double kEven = 1e-7;        // of the length: a position that moves by less stays
constexpr double kWhole = 1e-6;       // of the last position: nearer to 0 than that it is 0
constexpr double kMostExcess = 0.01;  // of the area of widths that are joined by lines
constexpr double kLeastShares = 0.9,
                 kMostShares = 1.001;  // where positions of widths end that are shares of the length

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

/// Root mean square over `points` of the distance to the nearest point on `curve`.
double mean_distance(const Points& points, const Points& curve) {
  double squares = 0;
  for (const glm::dvec2 point : points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
      nearest = std::min(nearest, glm::length(from_segment(point - curve[k], curve[k + 1] - curve[k])));
    }
    squares += nearest * nearest;
  }
  return std::sqrt(squares / static_cast<double>(points.size()));
}

/// Moves `k` on to the piece of rising `places` in which `place` lies, and gives its share there.
double share_in_piece(const std::vector<double>& places, double place, std::size_t& k) {
  while (k + 2 < places.size() && places[k + 1] < place) ++k;
  const double step = places[k + 1] - places[k];
  return step > 0 ? std::clamp((place - places[k]) / step, 0.0, 1.0) : 0;
}

/// The points at rising positions along others.
Points points_at(const Points& followed, const std::vector<double>& lengths, const std::vector<double>& places) {
  Points points;
  std::size_t k = 0;
  for (const double place : places) {
    const double share = share_in_piece(lengths, place, k);
    points.push_back(glm::mix(followed[k], followed[k + 1], share));
  }
  return points;
}

/// `pieces` chords of equal length along the points: where the way is bent within one, it is shorter than the way.
Points equal_chords(const Points& followed, std::size_t pieces) {
  const std::vector<double> lengths = chord_lengths(followed);
  const auto share = [&](std::size_t i) { return static_cast<double>(i) / static_cast<double>(pieces); };
  std::vector<double> places;
  for (std::size_t i = 0; i < pieces; ++i) places.push_back(share(i) * lengths.back());
  places.push_back(lengths.back());
  for (int round = 0; round < kEvenings; ++round) {
    const std::vector<double> chords = chord_lengths(points_at(followed, lengths, places));
    const std::vector<double> last = places;
    double farthest = 0;
    std::size_t k = 0;
    for (std::size_t i = 1; i < pieces; ++i) {
      const double within = share_in_piece(chords, share(i) * chords.back(), k);
      // Half of the way: where the midrib turns back, all of it leads to and fro.
      const double step = 0.5 * (last[k] + within * (last[k + 1] - last[k]) - last[i]);
      places[i] += step;
      farthest = std::max(farthest, std::abs(step));
    }
    if (farthest <= kEven * lengths.back()) break;
  }
  return points_at(followed, lengths, places);
}

/// The leaf with these points, whose pieces are made as long as each other to the last digit.
GrassLeaf leaf_through(const Points& points) {
  const std::size_t pieces = points.size() - 1;
  GrassLeaf leaf{.s = {}, .x = {}, .y = {}, .r = std::vector<double>(points.size(), 1)};
  for (std::size_t k = 0; k <= pieces; ++k) {
    leaf.s.push_back(k == pieces ? 1 : static_cast<double>(k) / static_cast<double>(pieces));
    leaf.x.push_back(points[k].x - points[0].x);
    leaf.y.push_back(points[k].y - points[0].y);
  }
  return resampled(leaf, pieces);
}

/// Smoothed widths as shares of the largest measured one, over the share of the length.
struct WidthCurve {
  Curve spline{};
  Curve lines{};            // through the same points
  double straightness = 0;  // the share that the lines have
  double widest = 0;        // the share of the length where the smoothed ones are largest
  double largest = 0;       // measured one

  double operator()(double place) const {
    const double smooth = std::max(0.0, spline(place));
    return straightness > 0 ? smooth + straightness * (std::max(0.0, lines(place)) - smooth) : smooth;
  }
};

double area_under(const Curve& curve) {
  constexpr int kPlaces = 512;
  double sum = 0;
  for (int k = 0; k < kPlaces; ++k) sum += std::max(0.0, curve((k + 0.5) / kPlaces));
  return sum / kPlaces;
}

/// Between few rows a spline bulges: it may have 6 % more area than the widths that were measured. So much of it is
/// given up for the straight lines that the area keeps to theirs.
double straightness_for_area(const Curve& spline, const Curve& lines) {
  const double wanted = area_under(lines);
  const double excess = std::abs(area_under(spline) - wanted);
  const double allowed = kMostExcess * wanted;
  return excess > allowed ? 1 - allowed / excess : 0;
}

WidthCurve smooth_widths(const Points& points, double smoothing) {
  WidthCurve smoothed;
  std::vector<double> places, widths;
  // A position that is not measured has the width of the next one.
  if (points.front().x > kWhole * points.back().x) {
    places.push_back(0);
    widths.push_back(points.front().y);
  }
  for (const glm::dvec2 point : points) {
    places.push_back(point.x / points.back().x);
    widths.push_back(point.y);
    smoothed.largest = std::max(smoothed.largest, point.y);
  }
  std::vector<double> weights(places.size(), 1);
  weights.front() = weights.back() = kEndWeight;
  const double distance = weighted(smoothing * smoothed.largest, weights);
  std::vector<double> smooth = smooth_values(places, {widths}, distance, weights)[0];
  for (double& width : smooth) width = std::max(0.0, width / smoothed.largest);
  smoothed.widest = places[static_cast<std::size_t>(std::ranges::max_element(smooth) - smooth.begin())];
  smoothed.lines = through(places, smooth, CurveKind::linear);
  smoothed.spline = smoothing > 0 ? through(places, smooth, CurveKind::spline) : smoothed.lines;
  smoothed.straightness = straightness_for_area(smoothed.spline, smoothed.lines);
  return smoothed;
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
  Points points =
      equal_chords(follow_midrib(midrib.points, lengths, options), static_cast<std::size_t>(options.pieces));
  for (glm::dvec2& point : points) point = midrib.points[0] + fitted.polyline_length * point;
  fitted.length = chord_lengths(points).back();
  fitted.distance = mean_distance(midrib.points, points);
  fitted.leaf = leaf_through(points);
  return fitted;
}

FittedWidths fit_widths(const MeasuredCurve& widths, const FitOptions& options) {
  check_options(options);
  check_widths(widths);
  FittedWidths fitted;
  MeasuredCurve from_base = widths;
  fitted.was_turned = turn_to_base(from_base);
  fitted.length = from_base.points.back().x;
  fitted.are_shares = fitted.length > kLeastShares && fitted.length < kMostShares;
  const WidthCurve smooth = smooth_widths(from_base.points, options.width_smoothing);
  double largest = 0;
  for (int k = 0; k <= options.pieces; ++k) {
    fitted.r.push_back(smooth(static_cast<double>(k) / options.pieces));
    largest = std::max(largest, fitted.r.back());
  }
  if (largest == 0) {
    // A blade that is narrower than a piece and lies between two points.
    fitted.r[static_cast<std::size_t>(smooth.widest * options.pieces + 0.5)] = largest = 1;
  }
  for (double& share : fitted.r) share = std::min(1.0, share / largest);
  fitted.width = largest * smooth.largest;
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
