// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/crown/placed_crown.h"

#include <algorithm>
#include <utility>

#include <glm/matrix.hpp>

namespace meristem {

PlacedCrown::PlacedCrown(CrownPointer crown, const Frame& frame)
    : crown_(std::move(crown)),
      origin_(frame.origin),
      back_(glm::inverse(DMat3(frame.axes))),
      scale_(std::min({glm::length(frame.axes[0]), glm::length(frame.axes[1]), glm::length(frame.axes[2])})) {
  const Box own = crown_->bounds();
  if (own.is_empty()) return;
  for (int corner = 0; corner < 8; ++corner) {
    bounds_.add(frame.point({(corner & 1) != 0 ? own.high.x : own.low.x, (corner & 2) != 0 ? own.high.y : own.low.y,
                             (corner & 4) != 0 ? own.high.z : own.low.z}));
  }
  // Enlarge the bounds, so that rounding cuts nothing off.
  const Vec3 edge = 1e-5F * bounds_.size();
  bounds_ = {bounds_.low - edge, bounds_.high + edge};
}

bool PlacedCrown::contains(Vec3 point) const { return crown_->contains(Vec3(back_ * (DVec3(point) - origin_))); }

double PlacedCrown::distance(Vec3 point) const {
  return scale_ * crown_->distance(Vec3(back_ * (DVec3(point) - origin_)));
}

}  // namespace meristem
