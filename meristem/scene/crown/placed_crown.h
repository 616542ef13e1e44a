// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/frame.h"
#include "meristem/scene/crown/crown.h"

namespace meristem {

/// A crown that is rotated, scaled and moved by a frame.
class PlacedCrown : public Crown {
 public:
  /// `frame` maps the crown's coordinates to the surrounding space; its axes must be linearly independent.
  PlacedCrown(CrownPointer crown, const Frame& frame);
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override { return bounds_; }
  bool is_convex() const override { return crown_->is_convex(); }

 private:
  CrownPointer crown_;
  DVec3 origin_;
  DMat3 back_;    // maps directions of the surrounding space to the crown's
  double scale_;  // the smallest scale of the axes
  Box bounds_;
};

}  // namespace meristem
