// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/crown/combined_crown.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace meristem {

namespace {

/// Returns the intersection of two boxes, or an empty box if they do not overlap.
Box common(const Box& a, const Box& b) {
  const Box shared{.low = glm::max(a.low, b.low), .high = glm::min(a.high, b.high)};
  const bool meets = shared.low.x <= shared.high.x && shared.low.y <= shared.high.y && shared.low.z <= shared.high.z;
  return meets ? shared : Box{};
}

}  // namespace

CombinedCrown::CombinedCrown(CombineKind kind, std::vector<CrownPointer> crowns)
    : kind_(kind), crowns_(std::move(crowns)) {
  if (crowns_.empty()) throw std::invalid_argument("combined crown: no crowns");
  for (const CrownPointer& crown : crowns_) {
    if (crown == nullptr) throw std::invalid_argument("combined crown: a null crown");
    boxes_.push_back(crown->bounds());
  }
  bounds_ = boxes_[0];
  for (std::size_t k = 1; k < boxes_.size(); ++k) {
    if (kind_ == CombineKind::unite) bounds_.add(boxes_[k]);
    if (kind_ == CombineKind::intersect) bounds_ = common(bounds_, boxes_[k]);
  }
}

bool CombinedCrown::contains(Vec3 point) const {
  const auto is_in = [&](std::size_t k) { return boxes_[k].holds(point) && crowns_[k]->contains(point); };
  const bool in_first = is_in(0);
  if (in_first == (kind_ == CombineKind::unite)) return in_first;
  for (std::size_t k = 1; k < crowns_.size(); ++k) {
    // The first crown that decides ends the loop: one that contains the point for a union or a difference, one that
    // does not for an intersection.
    if (is_in(k) != (kind_ == CombineKind::intersect)) return kind_ == CombineKind::unite;
  }
  return kind_ != CombineKind::unite;
}

bool CombinedCrown::is_convex() const {
  return kind_ == CombineKind::intersect &&
         std::ranges::all_of(crowns_, [](const CrownPointer& crown) { return crown->is_convex(); });
}

double CombinedCrown::distance(Vec3 point) const {
  double distance = crowns_[0]->distance(point);
  for (std::size_t k = 1; k < crowns_.size(); ++k) {
    const double other = crowns_[k]->distance(point);
    if (kind_ == CombineKind::unite) distance = std::min(distance, other);
    if (kind_ == CombineKind::intersect) distance = std::max(distance, other);
    if (kind_ == CombineKind::subtract) distance = std::max(distance, -other);
  }
  return distance;
}

Vec2 CombinedCrown::axis() const { return kind_ == CombineKind::subtract ? crowns_[0]->axis() : Crown::axis(); }

}  // namespace meristem
