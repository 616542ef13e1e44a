// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/crown/solid_crowns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meristem {

namespace {

/// The box between two corners in double, grown by the rounding to float.
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

Box EllipsoidCrown::bounds() const { return outward(centre_ - radii_, centre_ + radii_); }

bool ConeCrown::contains(Vec3 point) const {
  const DVec3 from_base = DVec3(point) - base_;
  if (from_base.y < 0 || from_base.y > height_) return false;
  // r / radius <= 1 - y / height, without dividing.
  const double reach = radius_ * (height_ - from_base.y);
  return (from_base.x * from_base.x + from_base.z * from_base.z) * height_ * height_ <= reach * reach;
}

Box ConeCrown::bounds() const {
  return outward(base_ - DVec3(radius_, 0, radius_), base_ + DVec3(radius_, height_, radius_));
}

bool CylinderCrown::contains(Vec3 point) const {
  const DVec3 from_base = DVec3(point) - base_;
  if (from_base.y < 0 || from_base.y > height_) return false;
  return from_base.x * from_base.x + from_base.z * from_base.z <= radius_ * radius_;
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

Box PyramidCrown::bounds() const {
  return outward(base_ - DVec3(half_width_, 0, half_width_), base_ + DVec3(half_width_, height_, half_width_));
}

bool HalfSpaceCrown::contains(Vec3 point) const { return glm::dot(DVec3(point) - point_, normal_) <= 0; }

Box HalfSpaceCrown::bounds() const { return {.low = Vec3(-kEndlessReach), .high = Vec3(kEndlessReach)}; }

bool BoxCrown::contains(Vec3 point) const {
  for (int k = 0; k < 3; ++k) {
    if (point[k] < box_.low[k] || point[k] > box_.high[k]) return false;
  }
  return true;
}

}  // namespace meristem
