// SPDX-License-Identifier: Apache-2.0
// Builds bodies from solids and operations as a list of clauses in postfix order. The box around the solids and the
// swelling by blends are updated with each operation.
#include "meristem/shape/implicit/implicit_body.h"

#include <cmath>

#include "meristem/base/require.h"

namespace meristem {

namespace {

bool is_finite(DVec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_size(double value) { return value > 0 && std::isfinite(value); }

/// Splits a frame that may scale into its rotation and the sizes along its axes.
void part(const Frame& frame, Vec3 half, glm::dmat3& axes, DVec3& sizes) {
  axes = glm::dmat3(frame.axes);
  for (int k = 0; k < 3; ++k) {
    const double length = glm::length(axes[k]);
    sizes[k] = length * half[k];
    require(is_size(sizes[k]), "a body's sizes must be above 0 and finite");
    axes[k] /= length;
  }
  require(is_finite(DVec3(frame.origin)), "a body's position must be finite");
}

/// Returns how far an operation swells beyond its sides, if the sides themselves swell by `a` and `b`. Blends rise with
/// both sides, so the lowest value occurs where both sides are lowest.
double swelling(BodyClause::Kind kind, double a, double b, double width) {
  return kind < BodyClause::Kind::poly ? std::max(a, b) : -apply(kind, -a, -b, width);
}

}  // namespace

ImplicitBody::ImplicitBody(ImplicitSolid solid, DVec3 low, DVec3 high) : low_(low), high_(high) {
  clauses_.emplace_back();
  solids_.push_back(std::move(solid));
}

ImplicitBody ImplicitBody::sphere(DVec3 centre, double radius) { return capsule(centre, centre, radius); }

ImplicitBody ImplicitBody::capsule(DVec3 from, DVec3 to, double radius) { return round_cone(from, radius, to, radius); }

ImplicitBody ImplicitBody::round_cone(DVec3 from, double from_radius, DVec3 to, double to_radius) {
  require(is_finite(from) && is_finite(to), "a body's position must be finite");
  require(from_radius >= 0 && to_radius >= 0 && is_size(std::max(from_radius, to_radius)),
          "a cone's radii must not be negative, and one must be above 0");
  const DVec3 low = glm::min(from - from_radius, to - to_radius);
  const DVec3 high = glm::max(from + from_radius, to + to_radius);
  distance::RoundCone<double> cone{.origin = from, .axis = DVec3(0, 1, 0), .radius = from_radius};
  const double length = glm::distance(from, to);
  const double slope = length > 0 ? (from_radius - to_radius) / length : 2;
  if (std::abs(slope) >= 1) {
    // One ball contains the other.
    if (to_radius > from_radius) cone.origin = to;
    cone.radius = std::max(from_radius, to_radius);
  } else {
    cone.axis = (to - from) / length;
    cone.high = length;
    cone.slope = slope;
    cone.tangent = slope / std::sqrt(1 - slope * slope);
  }
  return {cone, low, high};
}

ImplicitBody ImplicitBody::flat_cone(DVec3 from, double from_radius, DVec3 to, double to_radius) {
  const double length = glm::distance(from, to);
  require(is_finite(from) && is_finite(to) && is_size(length), "a flat cone needs a length");
  require(from_radius >= 0 && to_radius >= 0 && is_size(std::max(from_radius, to_radius)),
          "a cone's radii must not be negative, and one must be above 0");
  const DVec3 axis = (to - from) / length;
  // Along each direction, a disc extends by the sine of the angle between its axis and the direction.
  const DVec3 spread = glm::sqrt(glm::max(1.0 - axis * axis, 0.0));
  const DVec3 low = glm::min(from - from_radius * spread, to - to_radius * spread);
  const DVec3 high = glm::max(from + from_radius * spread, to + to_radius * spread);
  return {distance::FlatCone<double>{0.5 * (from + to), axis, 0.5 * length, from_radius, to_radius}, low, high};
}

ImplicitBody ImplicitBody::box(const Frame& frame, Vec3 half) {
  distance::Box<double> box{.origin = DVec3(frame.origin)};
  part(frame, half, box.axes, box.half);
  DVec3 reach{0};
  for (int k = 0; k < 3; ++k) reach += glm::abs(box.axes[k]) * box.half[k];
  return {box, box.origin - reach, box.origin + reach};
}

ImplicitBody ImplicitBody::ellipsoid(const Frame& frame, Vec3 radii) {
  distance::Ellipsoid<double> ellipsoid{.origin = DVec3(frame.origin)};
  part(frame, radii, ellipsoid.axes, ellipsoid.radii);
  DVec3 reach{0};
  for (int k = 0; k < 3; ++k) {
    const DVec3 along = ellipsoid.axes[k] * ellipsoid.radii[k];
    reach += along * along;
  }
  reach = glm::sqrt(reach);
  return {ellipsoid, ellipsoid.origin - reach, ellipsoid.origin + reach};
}

ImplicitBody& ImplicitBody::unite(const ImplicitBody& other) { return append(other, BodyClause::Kind::unite, 0); }

ImplicitBody& ImplicitBody::intersect(const ImplicitBody& other) {
  return append(other, BodyClause::Kind::intersect, 0);
}

ImplicitBody& ImplicitBody::subtract(const ImplicitBody& other) { return append(other, BodyClause::Kind::subtract, 0); }

ImplicitBody& ImplicitBody::blend(const ImplicitBody& other, BlendKind kind, double width) {
  require(width >= 0 && std::isfinite(width), "a blend's width must not be negative");
  if (width == 0) return unite(other);
  switch (kind) {
    case BlendKind::root:
      return append(other, BodyClause::Kind::root, width);
    case BlendKind::pasko:
      return append(other, BodyClause::Kind::pasko, width);
    default:
      return append(other, BodyClause::Kind::poly, width);
  }
}

ImplicitBody& ImplicitBody::append(const ImplicitBody& other, BodyClause::Kind kind, double width) {
  const bool is_union = kind != BodyClause::Kind::intersect && kind != BodyClause::Kind::subtract;
  if (&other == this) return append(ImplicitBody(other), kind, width);
  if (is_empty() || other.is_empty()) {
    if (is_empty() ? is_union : kind == BodyClause::Kind::intersect) *this = other;
    return *this;
  }
  if (is_union) {
    low_ = glm::min(low_, other.low_);
    high_ = glm::max(high_, other.high_);
    reach_ = swelling(kind, reach_, other.reach_, width);
  } else if (kind == BodyClause::Kind::intersect) {
    // The common part lies within each body with its swelling.
    low_ = glm::max(low_ - reach_, other.low_ - other.reach_);
    high_ = glm::max(low_, glm::min(high_ + reach_, other.high_ + other.reach_));
    reach_ = 0;
  }
  const auto first_solid = static_cast<std::uint32_t>(solids_.size());
  solids_.insert(solids_.end(), other.solids_.begin(), other.solids_.end());
  const std::size_t first_clause = clauses_.size();
  clauses_.insert(clauses_.end(), other.clauses_.begin(), other.clauses_.end());
  for (std::size_t k = first_clause; k < clauses_.size(); ++k) clauses_[k].solid += first_solid;
  const auto size = static_cast<std::uint32_t>(clauses_.size() + 1);
  clauses_.push_back({.kind = kind, .size = size, .width = width});
  return *this;
}

double ImplicitBody::value(DVec3 position) const {
  if (is_empty()) return std::numeric_limits<double>::infinity();
  std::vector<double> stack;
  for (const BodyClause& clause : clauses_) {
    if (clause.kind == BodyClause::Kind::solid) {
      stack.push_back(std::visit([&](const auto& solid) { return solid.distance(position.x, position.y, position.z); },
                                 solids_[clause.solid]));
      continue;
    }
    const double b = stack.back();
    stack.pop_back();
    stack.back() = apply(clause.kind, stack.back(), b, clause.width);
  }
  return stack.back();
}

}  // namespace meristem
