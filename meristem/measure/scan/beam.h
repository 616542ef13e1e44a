// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

/// Returns where the rays that represent a Gaussian beam lie in its cross-section, in units of its radius at 1/e². Each
/// ray represents an equal share of the beam's strength. The beam is cut into rings of equal strength with one ray
/// each. The ray lies at the ring's mean square distance from the axis, and is turned by the golden angle from the ray
/// before. With two rays or more, the mean square distance is therefore exactly that of the beam, 1/2. A single ray
/// lies on the axis.
std::vector<Vec2> beam_offsets(int rays);

}  // namespace meristem
