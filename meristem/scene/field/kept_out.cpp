// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/field/kept_out.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/matrix.hpp>

namespace meristem {

KeptOut::KeptOut(CrownPointer body, const Frame& frame, double reach)
    : body_(std::move(body)),
      origin_(frame.origin),
      back_(glm::inverse(frame.axes)),
      scale_(glm::length(frame.heading())),
      reach_(reach) {}

double KeptOut::distance(Vec3 position) const { return scale_ * body_->distance(back_ * (position - origin_)); }

/// Computes the gradient by finite differences, because bodies only provide distances.
Vec3 KeptOut::outward(Vec3 position) const {
  const auto step = static_cast<float>(1e-3 * reach_);
  Vec3 slope(0);
  for (int k = 0; k < 3; ++k) {
    Vec3 side(0);
    side[k] = step;
    slope[k] = static_cast<float>(distance(position + side) - distance(position - side));
  }
  return normalized_or(slope, kUp);
}

Vec3 KeptOut::open_heading(const Section& section) const {
  const double near = std::max(reach_, section.step);
  const double away = distance(section.position) - section.radius;
  if (away >= near) return section.heading;
  const Vec3 out = outward(section.position);
  const double wanted = glm::dot(section.heading, out);
  const double min = std::min(1.0, -away / near);
  if (wanted >= min) return section.heading;
  // Take the nearest direction that rises enough, in the plane of the heading and the outward direction.
  const Vec3 along = normalized_or(section.heading - static_cast<float>(wanted) * out, any_perpendicular(out));
  return glm::normalize(static_cast<float>(std::sqrt(1 - min * min)) * along + static_cast<float>(min) * out);
}

}  // namespace meristem
