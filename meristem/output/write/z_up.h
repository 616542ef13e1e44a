// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"

namespace meristem {

/// Converts a position to the axes of surveyors' and foresters' files: x east, y north, z up.
inline Vec3 z_up(Vec3 position) { return {position.x, 0 - position.z, position.y}; }

}  // namespace meristem
