// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/field/ready_fields.h"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

#include "meristem/base/noise.h"

namespace meristem {

namespace {

constexpr double kCore = 1e-3;  // radius in metres around a point or line where the field has no direction

/// Returns the vector from the axis to a position, at right angles to the axis.
DVec3 from_axis(const FieldAxis& axis, Vec3 position) {
  const DVec3 way = DVec3(position) - DVec3(axis.point);
  const DVec3 direction(axis.direction);
  return way - glm::dot(way, direction) * direction;
}

}  // namespace

Vec3 PointField::at(Vec3 position) const {
  const DVec3 way = point_ - DVec3(position);
  const double distance = glm::length(way);
  const double farther = distance / reach_;
  return Vec3(way / (std::max(distance, kCore) * (1 + farther * farther)));
}

Vec3 CylinderField::at(Vec3 position) const {
  const DVec3 way = from_axis(axis_, position);
  const double distance = glm::length(way);
  const double outside = std::clamp((distance - radius_) / edge_, -1.0, 1.0);
  return Vec3(-outside / std::max(distance, kCore) * way);
}

Vec3 VortexField::at(Vec3 position) const {
  const DVec3 way = from_axis(axis_, position);
  return Vec3(glm::cross(DVec3(axis_.direction), way) / std::max(glm::length(way), core_));
}

Vec3 WindField::at(Vec3 position) const {
  if (gusts_.share == 0) return wind_;
  const DVec3 wind(wind_);
  const double speed = glm::length(wind);
  const DVec3 drifted = speed > 0 ? DVec3(position) - gusts_.drift / speed * wind : DVec3(position);
  const DVec3 cell = drifted / gusts_.size;
  DVec3 gust(0);
  for (int k = 0; k < 3; ++k) {
    gust[k] = gradient_noise(gusts_.key.child(static_cast<std::uint64_t>(k)), cell.x, cell.y, cell.z);
  }
  return Vec3(wind + speed * gusts_.share * gust);
}

PlacedField::PlacedField(FieldPointer field, const Frame& frame, double strength)
    : field_(std::move(field)), origin_(frame.origin), back_(glm::inverse(frame.axes)) {
  for (int k = 0; k < 3; ++k) {
    turn_[k] = static_cast<float>(strength) * normalized_or(frame.axes[k], Vec3(0));
  }
}

Vec3 PlacedField::at(Vec3 position) const { return turn_ * field_->at(back_ * (position - origin_)); }

}  // namespace meristem
