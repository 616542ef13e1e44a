// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/crown/turned_crown.h"

#include <algorithm>
#include <utility>

#include <glm/matrix.hpp>

namespace meristem {

TurnedCrown::TurnedCrown(CrownPointer crown, const Mat3& axes)
    : crown_(std::move(crown)),
      back_(glm::inverse(glm::dmat3(axes))),
      scale_(std::min({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])})) {
  const Box own = crown_->bounds();
  if (own.is_empty()) return;
  for (int corner = 0; corner < 8; ++corner) {
    bounds_.add(axes * Vec3((corner & 1) != 0 ? own.high.x : own.low.x, (corner & 2) != 0 ? own.high.y : own.low.y,
                            (corner & 4) != 0 ? own.high.z : own.low.z));
  }
  // Rounding takes nothing away.
  const Vec3 edge = 1e-5F * bounds_.size();
  bounds_ = {bounds_.low - edge, bounds_.high + edge};
}

bool TurnedCrown::contains(Vec3 point) const { return crown_->contains(Vec3(back_ * DVec3(point))); }

double TurnedCrown::distance(Vec3 point) const { return scale_ * crown_->distance(Vec3(back_ * DVec3(point))); }

}  // namespace meristem
