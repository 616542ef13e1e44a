// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "meristem/base/vec.h"

namespace meristem {

/// Returns the unit vector along normalize(`pull`) + `bias`. `pull` is a sum of unit vectors. Returns nothing if one of
/// the vectors vanishes, as between two opposite points.
std::optional<DVec3> growth_direction(DVec3 pull, DVec3 bias);

}  // namespace meristem
