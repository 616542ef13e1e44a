// SPDX-License-Identifier: Apache-2.0
// Containment, distances and bounds of simple bodies in closed form.
#include "meristem/scene/crown/solid_crowns.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meristem/scene/crown/line_distance.h"

namespace meristem {

namespace {

/// Returns the box between two corners, enlarged by the rounding from double to float.
Box outward(DVec3 low, DVec3 high) {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  Box box{.low = Vec3(low), .high = Vec3(high)};
  for (int k = 0; k < 3; ++k) {
    box.low[k] = std::nextafter(box.low[k], -kFar);
    box.high[k] = std::nextafter(box.high[k], kFar);
  }
  return box;
}

}  // namespace

bool EllipsoidCrown::contains(Vec3 point) const {
  if (!(radii_.x > 0 && radii_.y > 0 && radii_.z > 0)) return false;
  const DVec3 scaled = (DVec3(point) - centre_) / radii_;
  return glm::dot(scaled, scaled) <= 1;
}

/// Approximates the distance to first order. Exact for spheres.
double EllipsoidCrown::distance(Vec3 point) const {
  const DVec3 way = DVec3(point) - centre_;
  const double share = glm::length(way / radii_);
  const double slope = glm::length(way / (radii_ * radii_));
  if (!(slope > 0)) return -std::min({radii_.x, radii_.y, radii_.z});
  return share * (share - 1) / slope;
}

Box EllipsoidCrown::bounds() const { return outward(centre_ - radii_, centre_ + radii_); }

bool ConeCrown::contains(Vec3 point) const {
  const DVec3 from_base = DVec3(point) - base_;
  if (from_base.y < 0 || from_base.y > height_) return false;
  // r / radius <= 1 - y / height, without a division.
  const double reach = radius_ * (height_ - from_base.y);
  return (from_base.x * from_base.x + from_base.z * from_base.z) * height_ * height_ <= reach * reach;
}

double ConeCrown::distance(Vec3 point) const {
  const DVec3 way = DVec3(point) - base_;
  const glm::dvec2 at(std::sqrt(way.x * way.x + way.z * way.z), way.y);
  const double away = std::sqrt(std::min(squared_distance_to_line(at, {0, 0}, {radius_, 0}),
                                         squared_distance_to_line(at, {radius_, 0}, {0, height_})));
  return contains(point) ? -away : away;
}

Box ConeCrown::bounds() const {
  return outward(base_ - DVec3(radius_, 0, radius_), base_ + DVec3(radius_, height_, radius_));
}

bool CylinderCrown::contains(Vec3 point) const {
  const DVec3 from_base = DVec3(point) - base_;
  if (from_base.y < 0 || from_base.y > height_) return false;
  return from_base.x * from_base.x + from_base.z * from_base.z <= radius_ * radius_;
}

double CylinderCrown::distance(Vec3 point) const {
  const DVec3 way = DVec3(point) - base_;
  const glm::dvec2 beyond(std::sqrt(way.x * way.x + way.z * way.z) - radius_, std::max(-way.y, way.y - height_));
  return glm::length(glm::max(beyond, glm::dvec2(0))) + std::min(0.0, std::max(beyond.x, beyond.y));
}

Box CylinderCrown::bounds() const {
  return outward(base_ - DVec3(radius_, 0, radius_), base_ + DVec3(radius_, height_, radius_));
}

bool PyramidCrown::contains(Vec3 point) const {
  const DVec3 from_base = DVec3(point) - base_;
  if (from_base.y < 0 || from_base.y > height_) return false;
  const double reach = half_width_ * (height_ - from_base.y);
  return std::max(std::abs(from_base.x), std::abs(from_base.z)) * height_ <= reach;
}

/// Returns the largest distance to a plane of the pyramid. This is exact near faces. Beyond edges and corners it is too
/// small.
double PyramidCrown::distance(Vec3 point) const {
  const DVec3 way = DVec3(point) - base_;
  const double side = std::max(std::abs(way.x), std::abs(way.z));
  const double slant = (side * height_ + (way.y - height_) * half_width_) / std::hypot(height_, half_width_);
  return std::max(slant, -way.y);
}

Box PyramidCrown::bounds() const {
  return outward(base_ - DVec3(half_width_, 0, half_width_), base_ + DVec3(half_width_, height_, half_width_));
}

bool TorusCrown::contains(Vec3 point) const { return distance(point) <= 0; }

double TorusCrown::distance(Vec3 point) const {
  const DVec3 way = DVec3(point) - centre_;
  const double off = std::sqrt(way.x * way.x + way.z * way.z) - radius_;
  return std::sqrt(off * off + way.y * way.y) - tube_;
}

Box TorusCrown::bounds() const {
  const DVec3 reach(radius_ + tube_, tube_, radius_ + tube_);
  return outward(centre_ - reach, centre_ + reach);
}

bool HalfSpaceCrown::contains(Vec3 point) const { return glm::dot(DVec3(point) - point_, normal_) <= 0; }

double HalfSpaceCrown::distance(Vec3 point) const {
  return glm::dot(DVec3(point) - point_, normal_) / glm::length(normal_);
}

Box HalfSpaceCrown::bounds() const { return {.low = Vec3(-kEndlessReach), .high = Vec3(kEndlessReach)}; }

bool BoxCrown::contains(Vec3 point) const {
  for (int k = 0; k < 3; ++k) {
    if (point[k] < box_.low[k] || point[k] > box_.high[k]) return false;
  }
  return true;
}

double BoxCrown::distance(Vec3 point) const {
  const DVec3 beyond = glm::max(DVec3(box_.low) - DVec3(point), DVec3(point) - DVec3(box_.high));
  return glm::length(glm::max(beyond, DVec3(0))) + std::min(0.0, std::max({beyond.x, beyond.y, beyond.z}));
}

}  // namespace meristem
