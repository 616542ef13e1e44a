// SPDX-License-Identifier: Apache-2.0
// Crowns given by profiles: the radius at each height is a natural cubic spline, and between profiles at different
// azimuths it is linear.
//
// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
// 2020, section 3.3 (equations 3.8 to 3.13; 3.12 with the height where it prints x).
#include "meristem/scene/crown/profile_crown.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "meristem/base/math.h"
#include "meristem/scene/crown/line_distance.h"

namespace meristem {

namespace {

Curve radius_over_height(const ProfileCrown::Profile& profile) {
  if (profile.size() < 2) throw std::invalid_argument("crown profile: at least two points are needed");
  std::vector<Vec2> points;
  points.reserve(profile.size());
  for (const Vec2 marked : profile) points.emplace_back(marked.y, marked.x);
  return Curve(std::move(points));
}

double radius_on(const Curve& side, double height) {
  if (height < side.points().front().x || height > side.points().back().x) return 0;
  return std::max(0.0, side(height));
}

/// Returns an upper bound of a spline. A cubic piece stays below its largest Bézier control value. Each piece is
/// divided into eight, so that the bound is close.
double max(const Curve& curve) {
  constexpr int kParts = 8;
  double bound = 0;
  for (std::size_t k = 0; k + 1 < curve.points().size(); ++k) {
    const double first = curve.points()[k].x;
    const double part = (curve.points()[k + 1].x - first) / kParts;
    for (int p = 0; p < kParts; ++p) {
      const double left = first + p * part;
      const double right = p + 1 == kParts ? double{curve.points()[k + 1].x} : left + part;
      bound = std::max({bound, curve(left), curve(left) + curve.slope(left) * part / 3,
                        curve(right) - curve.slope(right) * part / 3, curve(right)});
    }
  }
  return bound;
}

}  // namespace

double wrapped_azimuth(double azimuth) {
  constexpr double kTurn = 2 * kPi;
  const double wrapped = azimuth - kTurn * std::floor(azimuth / kTurn);
  return wrapped < kTurn ? wrapped : 0;
}

ProfileCrown::ProfileCrown(const Sides& sides) {
  if (sides.empty()) throw std::invalid_argument("crown: no profile");
  for (const AtAzimuth& side : sides) {
    sides_.push_back({wrapped_azimuth(side.azimuth), radius_over_height(side.profile)});
  }
  std::stable_sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) { return a.azimuth < b.azimuth; });
  lowest_ = sides_[0].radius.points().front().x;
  highest_ = sides_[0].radius.points().back().x;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    if (k > 0 && sides_[k].azimuth == sides_[k - 1].azimuth) {
      throw std::invalid_argument("crown: two profiles at one azimuth");
    }
    const Curve& radius = sides_[k].radius;
    lowest_ = std::min(lowest_, double{radius.points().front().x});
    highest_ = std::max(highest_, double{radius.points().back().x});
    reach_ = std::max(reach_, max(radius));
  }
}

double ProfileCrown::radius_at(double height, double azimuth) const {
  if (sides_.size() == 1) return radius_on(sides_[0].radius, height);
  const double wrapped = wrapped_azimuth(azimuth);
  const auto after = std::upper_bound(sides_.begin(), sides_.end(), wrapped,
                                      [](double value, const Side& side) { return value < side.azimuth; });
  const Side& right = after == sides_.end() ? sides_.front() : *after;
  const Side& left = after == sides_.begin() ? sides_.back() : *(after - 1);
  const double share = wrapped_azimuth(wrapped - left.azimuth) / wrapped_azimuth(right.azimuth - left.azimuth);
  return (1 - share) * radius_on(left.radius, height) + share * radius_on(right.radius, height);
}

bool ProfileCrown::contains(Vec3 point) const {
  if (point.y < lowest_ || point.y > highest_) return false;
  const double x = point.x;
  const double z = point.z;
  const double squared = x * x + z * z;
  if (squared > reach_ * reach_) return false;
  const double azimuth = sides_.size() == 1 ? 0 : math::atan2(x, -z);
  const double radius = radius_at(point.y, azimuth);
  return radius > 0 && squared <= radius * radius;
}

/// Returns the distance to the outline at the point's azimuth, approximated by straight pieces.
double ProfileCrown::distance(Vec3 point) const {
  constexpr int kPieces = 64;
  const double x = point.x;
  const double z = point.z;
  const glm::dvec2 at(std::sqrt(x * x + z * z), point.y);
  const double azimuth = sides_.size() == 1 ? 0 : math::atan2(x, -z);
  const double piece = (highest_ - lowest_) / kPieces;
  double min = std::numeric_limits<double>::infinity();
  glm::dvec2 last(0, lowest_);
  for (int k = 0; k <= kPieces; ++k) {
    const double height = k == kPieces ? highest_ : lowest_ + k * piece;
    const glm::dvec2 next(radius_at(height, azimuth), height);
    min = std::min(min, squared_distance_to_line(at, last, next));
    last = next;
  }
  min = std::min(min, squared_distance_to_line(at, last, {0, highest_}));
  return contains(point) ? -std::sqrt(min) : std::sqrt(min);
}

Box ProfileCrown::bounds() const {
  Box box;
  if (!(reach_ > 0)) return box;
  const auto reach = static_cast<float>(reach_ * (1 + 1e-6));
  box.add({-reach, static_cast<float>(lowest_), -reach});
  box.add({reach, static_cast<float>(highest_), reach});
  return box;
}

}  // namespace meristem
