// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "meristem/base/vec.h"

namespace meristem {

/// Returns the unit growth direction of a shoot that ends at `tip` along a line. It points from `tip` to the point on
/// the line `ahead` metres after the nearest point, so a shoot beside the line returns to it. The line continues
/// straight beyond its last point.
Vec3 way_along(std::span<const Vec3> line, Vec3 tip, float ahead);

}  // namespace meristem
