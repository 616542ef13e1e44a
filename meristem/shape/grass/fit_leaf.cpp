// SPDX-License-Identifier: Apache-2.0
// Fits a leaf to measured points. Both coordinates of the midrib are functions of the chord length and are smoothed
// together. The spline is then sampled in small steps, and the leaf's points are the points on it with equal chords.
// Tried first: points at equal distances along the spline. At a broken leaf their chords are shorter, and making these
// equal moved the rest of the leaf by up to 1.5 % of its length.
//
// Based on: Fournier and Pradal (2012), section 2.2.
#include "meristem/shape/grass/fit_leaf.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>

#include "meristem/base/curve_values.h"
#include "meristem/base/smoothing_spline.h"
#include "meristem/base/vec.h"

namespace meristem {

namespace {

constexpr double kEndWeight = 1000;  // weight of fixed points: the base of the blade and both ends of the widths
constexpr int kSteps = 8;            // steps along the spline per piece
constexpr int kEvenings = 20;        // maximum number of rounds that equalise chords
constexpr double kEven = 1e-7;       // share of the length; smaller moves of a position count as none
constexpr double kWhole = 1e-6;      // share of the last position; values nearer to 0 count as 0
constexpr double kMaxExcess = 0.01;  // share of the area of widths joined by lines
constexpr int kAreaPlaces = 512;     // number of positions at which such areas are summed
constexpr double kMinShares = 0.9,
                 kMaxShares = 1.001;  // maximum last position if positions of widths are shares of the length

using Points = std::vector<glm::dvec2>;

/// Sets `lengths` to the lengths of the chords up to each point.
void measure_chords(const Points& points, std::vector<double>& lengths) {
  lengths.resize(points.size());
  lengths[0] = 0;
  // Compute all roots first, so that they do not wait for the sum.
  for (std::size_t k = 1; k < points.size(); ++k) lengths[k] = glm::distance(points[k - 1], points[k]);
  for (std::size_t k = 1; k < points.size(); ++k) lengths[k] += lengths[k - 1];
}

std::vector<double> chord_lengths(const Points& points) {
  std::vector<double> lengths;
  measure_chords(points, lengths);
  return lengths;
}

/// Returns equal steps from 0 to 1.
std::vector<double> shares_of(int steps) {
  std::vector<double> shares(static_cast<std::size_t>(steps) + 1);
  for (int k = 0; k <= steps; ++k) shares[static_cast<std::size_t>(k)] = static_cast<double>(k) / steps;
  return shares;
}

/// Returns the distance for smooth_values with which points are `distance` off in the mean, although heavy points are
/// not.
double weighted(double distance, const std::vector<double>& weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  return distance * std::sqrt(static_cast<double>(weights.size()) / sum);
}

std::vector<Vec2> curve_points(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<Vec2> points(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) points[k] = {static_cast<float>(x[k]), static_cast<float>(y[k])};
  return points;
}

/// Returns dense points along the fitted midrib. The whole digitised midrib has length 1.
Points follow_midrib(const Points& points, const std::vector<double>& lengths, const FitOptions& options) {
  const double length = lengths.back();
  std::vector<double> places(points.size()), weights(points.size(), 1);
  std::vector<std::vector<double>> coordinates(2, std::vector<double>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    places[k] = lengths[k] / length;
    coordinates[0][k] = (points[k].x - points[0].x) / length;
    coordinates[1][k] = (points[k].y - points[0].y) / length;
  }
  weights.front() = kEndWeight;
  const auto smooth = smooth_values(places, std::move(coordinates), weighted(options.smoothing, weights), weights);
  const CurveKind kind = options.smoothing > 0 ? CurveKind::spline : CurveKind::linear;
  const std::vector<double> shares = shares_of(std::max(options.pieces, static_cast<int>(points.size())) * kSteps);
  const std::vector<Vec2> points_x = curve_points(places, smooth[0]);
  const CurvePositions positions(points_x, shares);
  const std::vector<double> followed_x = positions.values(points_x, kind);
  const std::vector<double> followed_y = positions.values(curve_points(places, smooth[1]), kind);
  Points followed(shares.size());
  for (std::size_t k = 0; k < shares.size(); ++k) followed[k] = {followed_x[k], followed_y[k]};
  return followed;
}

/// Returns the root mean square, over `points`, of the distance to the nearest point on `curve`.
double mean_distance(const Points& points, const Points& curve) {
  // Stored in columns, so that a processor handles several pieces at once.
  const std::size_t pieces = curve.size() - 1;
  std::vector<double> x(pieces), y(pieces), along_x(pieces), along_y(pieces), inverse(pieces), shares(pieces);
  for (std::size_t k = 0; k < pieces; ++k) {
    x[k] = curve[k].x;
    y[k] = curve[k].y;
    along_x[k] = curve[k + 1].x - curve[k].x;
    along_y[k] = curve[k + 1].y - curve[k].y;
    const double square = along_x[k] * along_x[k] + along_y[k] * along_y[k];
    inverse[k] = square > 0 ? 1 / square : 0;
  }
  double sum = 0;
  for (const glm::dvec2 point : points) {
    for (std::size_t k = 0; k < pieces; ++k) {
      shares[k] = ((point.x - x[k]) * along_x[k] + (point.y - y[k]) * along_y[k]) * inverse[k];
    }
    for (double& share : shares) share = std::max(share, 0.0);
    for (double& share : shares) share = std::min(share, 1.0);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < pieces; ++k) {
      const double off_x = point.x - x[k] - shares[k] * along_x[k];
      const double off_y = point.y - y[k] - shares[k] * along_y[k];
      nearest = std::min(nearest, off_x * off_x + off_y * off_y);
    }
    sum += nearest;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

/// Returns the share of the k-th piece of ascending `lengths` that lies before `length`.
double share_in_piece(const std::vector<double>& lengths, double length, std::size_t k) {
  const double step = lengths[k + 1] - lengths[k];
  return step > 0 ? std::min(std::max((length - lengths[k]) / step, 0.0), 1.0) : 0;
}

/// Positions along a line of points that are moved to equal chords.
class EvenPositions {
 public:
  EvenPositions(const Points& followed, int pieces)
      : followed_(followed),
        lengths_(chord_lengths(followed)),
        shares_(shares_of(pieces)),
        positions_(shares_.size()),
        pieces_(shares_.size()),
        points_(shares_.size()) {
    const std::size_t steps = followed.size() - 1;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      positions_[i] = shares_[i] * lengths_.back();
      // Approximate, since the points are in equal steps.
      pieces_[i] = std::min(i * steps / static_cast<std::size_t>(pieces), steps - 1);
    }
    moved_ = positions_;
    find_points();
  }

  double length() const { return lengths_.back(); }
  const Points& points() const { return points_; }

  /// Makes the chords more equal. Returns the largest move of a position.
  double even() {
    measure_chords(points_, chords_);
    double farthest = 0;
    std::size_t k = 0;
    for (std::size_t i = 1; i + 1 < positions_.size(); ++i) {
      const double wanted = shares_[i] * chords_.back();
      while (k + 2 < chords_.size() && chords_[k + 1] < wanted) ++k;
      const double within = share_in_piece(chords_, wanted, k);
      // Move only half of the way. Where the midrib turns back, a full move would oscillate.
      const double step = 0.5 * (positions_[k] + within * (positions_[k + 1] - positions_[k]) - positions_[i]);
      moved_[i] = positions_[i] + step;
      farthest = std::max(farthest, std::abs(step));
    }
    positions_.swap(moved_);
    find_points();
    return farthest;
  }

 private:
  void find_points() {
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      // Positions move little in a round, so the new piece of a position is near the old one.
      std::size_t& k = pieces_[i];
      while (k > 0 && lengths_[k] >= positions_[i]) --k;
      while (k + 2 < lengths_.size() && lengths_[k + 1] < positions_[i]) ++k;
      points_[i] = glm::mix(followed_[k], followed_[k + 1], share_in_piece(lengths_, positions_[i], k));
    }
  }

  const Points& followed_;
  std::vector<double> lengths_;  // of the chords of `followed_`
  std::vector<double> shares_;   // for each point, its share of all chords
  std::vector<double> positions_, moved_;
  std::vector<std::size_t> pieces_;  // pieces of `followed_` in which the positions lie
  Points points_;
  std::vector<double> chords_;  // chords between the positions
};

/// Returns `pieces` chords of equal length along the points. A chord is shorter than the path if the path bends within
/// it.
Points equal_chords(const Points& followed, int pieces) {
  EvenPositions positions(followed, pieces);
  for (int round = 0; round < kEvenings; ++round) {
    if (positions.even() <= kEven * positions.length()) break;
  }
  return positions.points();
}

/// Returns the leaf whose pieces have the directions of these chords and exactly equal lengths.
GrassLeaf leaf_through(const Points& points) {
  const std::size_t count = points.size();
  const double piece = 1 / static_cast<double>(count - 1);
  GrassLeaf leaf{.s = std::vector<double>(count),
                 .x = std::vector<double>(count),
                 .y = std::vector<double>(count),
                 .r = std::vector<double>(count, 1)};
  for (std::size_t k = 1; k < count; ++k) {
    const glm::dvec2 chord = points[k] - points[k - 1];
    const double length = glm::length(chord);
    const glm::dvec2 step = length > 0 ? piece / length * chord : glm::dvec2(0, piece);
    leaf.s[k] = piece * static_cast<double>(k);
    leaf.x[k] = leaf.x[k - 1] + step.x;
    leaf.y[k] = leaf.y[k - 1] + step.y;
  }
  leaf.s.back() = 1;
  return leaf;
}

/// Returns the share of straight lines that keeps the area. Between few rows a spline bulges: it can have 6 % more area
/// than the measured widths. Blending it with straight lines restores their area.
double straightness_for_area(std::span<const Vec2> curve) {
  static const std::vector<double> places = [] {
    std::vector<double> middles;
    for (int k = 0; k < kAreaPlaces; ++k) middles.push_back((k + 0.5) / kAreaPlaces);
    return middles;
  }();
  const CurvePositions positions(curve, places);
  const std::vector<double> lines = positions.values(curve, CurveKind::linear);
  const std::vector<double> bent = positions.values(curve, CurveKind::spline);
  // Compute both areas where the curves are above 0 at once, so that neither sum waits for the other.
  double wanted = 0, area = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    wanted += std::max(0.0, lines[k]);
    area += std::max(0.0, bent[k]);
  }
  wanted /= kAreaPlaces;
  const double excess = std::abs(area / kAreaPlaces - wanted);
  const double allowed = kMaxExcess * wanted;
  return excess > allowed ? 1 - allowed / excess : 0;
}

/// Smoothed widths as shares of the largest measured width, as a function of the share of the length.
struct SmoothWidths {
  std::vector<double> shares;  // at equal steps
  double widest = 0;           // share of the length at which the smoothed width is largest
  double largest = 0;          // largest measured width
};

SmoothWidths smooth_widths(const Points& points, const FitOptions& options) {
  SmoothWidths smoothed;
  std::vector<double> places, widths;
  // A base that was not measured gets the width of the next position.
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
  const double distance = weighted(options.width_smoothing * smoothed.largest, weights);
  std::vector<double> smooth = smooth_values(places, {widths}, distance, weights)[0];
  for (double& width : smooth) width = std::max(0.0, width / smoothed.largest);
  smoothed.widest = places[static_cast<std::size_t>(std::ranges::max_element(smooth) - smooth.begin())];
  const CurveKind kind = options.width_smoothing > 0 ? CurveKind::spline : CurveKind::linear;
  const std::vector<Vec2> curve = curve_points(places, smooth);
  const CurvePositions positions(curve, shares_of(options.pieces));
  smoothed.shares = positions.values(curve, kind);
  for (double& share : smoothed.shares) share = std::max(0.0, share);
  const double straightness = kind == CurveKind::spline ? straightness_for_area(curve) : 0;
  if (straightness > 0) {
    const std::vector<double> lines = positions.values(curve, CurveKind::linear);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      smoothed.shares[k] += straightness * (std::max(0.0, lines[k]) - smoothed.shares[k]);
    }
  }
  return smoothed;
}

void check_options(const FitOptions& options) {
  const auto is_share = [](double value) { return std::isfinite(value) && value >= 0 && value <= 1; };
  if (!is_share(options.smoothing) || !is_share(options.width_smoothing)) {
    throw std::invalid_argument("the smoothing of a fit must be from 0 to 1");
  }
  if (options.pieces < 2) throw std::invalid_argument("a fitted leaf needs at least 2 pieces");
}

}  // namespace

FittedMidrib fit_midrib(const MeasuredCurve& midrib, const FitOptions& options) {
  check_options(options);
  check_midrib(midrib);
  FittedMidrib fitted;
  const std::vector<double> lengths = chord_lengths(midrib.points);
  fitted.polyline_length = lengths.back();
  Points points = equal_chords(follow_midrib(midrib.points, lengths, options), options.pieces);
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
  fitted.are_shares = fitted.length > kMinShares && fitted.length < kMaxShares;
  SmoothWidths smooth = smooth_widths(from_base.points, options);
  fitted.r = std::move(smooth.shares);
  double largest = 0;
  for (const double share : fitted.r) largest = std::max(largest, share);
  if (largest == 0) {
    // The blade is narrower than a piece and lies between two points.
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
