// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "meristem/base/vec.h"

namespace meristem {

/// The unit vector in which a shoot that ends at `tip` grows along a line, and back to it where it has strayed: toward
/// the point on the line that lies `ahead` metres on. The line goes on straight beyond its last point.
Vec3 way_along(std::span<const Vec3> line, Vec3 tip, float ahead);

}  // namespace meristem
