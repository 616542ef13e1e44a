// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"

namespace meristem {

/// A direction that something faces: a given one, or away from the surface on which it stands.
struct FacingDirection {
  bool operator==(const FacingDirection&) const = default;

  bool is_from_surface = false;  ///< true: away from the surface on which it stands
  Vec3 direction = kUp;          ///< unit vector; used if is_from_surface is false
};

}  // namespace meristem
