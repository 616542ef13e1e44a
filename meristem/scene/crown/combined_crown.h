// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/scene/crown/crown.h"

namespace meristem {

/// The set operation that combines several crowns into one.
enum class CombineKind {
  unite,      ///< points in any crown
  intersect,  ///< points in all crowns
  subtract,   ///< points in the first crown and in no other
};

/// Several crowns combined into one.
class CombinedCrown : public Crown {
 public:
  /// Throws std::invalid_argument for an empty list or a null crown.
  CombinedCrown(CombineKind kind, std::vector<CrownPointer> crowns);
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override { return bounds_; }
  /// Returns the axis of the first crown, also after a subtraction.
  Vec2 axis() const override;
  /// Returns true for an intersection of convex crowns.
  bool is_convex() const override;

 private:
  CombineKind kind_;
  std::vector<CrownPointer> crowns_;
  std::vector<Box> boxes_;  // box of each crown
  Box bounds_;
};

}  // namespace meristem
