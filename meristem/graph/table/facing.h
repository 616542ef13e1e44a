// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"

namespace meristem {

/// A way that something faces: a direction, or that out of the surface which it stands at.
struct Facing {
  bool operator==(const Facing&) const = default;

  bool is_from_surface = false;  ///< true: out of the surface that it stands at
  Vec3 direction = kUp;          ///< unit vector; where it is not from the surface
};

}  // namespace meristem
