// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/scene/crown/crown.h"

namespace meristem {

/// What of several crowns makes one.
enum class CombineKind {
  unite,      ///< what is in any of the crowns
  intersect,  ///< what is in all of them
  subtract,   ///< what is in the first and in none of the others
};

/// Crowns combined into one.
class CombinedCrown : public Crown {
 public:
  /// At least one crown, none of them null; throws std::invalid_argument otherwise.
  CombinedCrown(CombineKind kind, std::vector<CrownPointer> crowns);
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override { return bounds_; }
  /// The axis of the first crown, also of what remains of it after a subtraction.
  Vec2 axis() const override;
  /// Where convex crowns are intersected.
  bool is_convex() const override;

 private:
  CombineKind kind_;
  std::vector<CrownPointer> crowns_;
  std::vector<Box> boxes_;  // box of each crown
  Box bounds_;
};

}  // namespace meristem
