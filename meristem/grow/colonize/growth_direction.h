// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "meristem/base/vec.h"

namespace meristem {

/// The unit vector of the unit vector of `pull` (a sum of unit vectors) plus `bias`; nothing where one of them
/// vanishes, as between two opposite points.
std::optional<DVec3> growth_direction(DVec3 pull, DVec3 bias);

}  // namespace meristem
