// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>

#include "meristem/scene/crown/crown.h"

namespace meristem {

/// A crown that is turned and scaled about its root.
class TurnedCrown : public Crown {
 public:
  /// `axes` takes directions of the crown to those of the space; they must be independent.
  TurnedCrown(CrownPointer crown, const Mat3& axes);
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override { return bounds_; }

 private:
  CrownPointer crown_;
  glm::dmat3 back_;
  double scale_;  // the least of the axes
  Box bounds_;
};

}  // namespace meristem
