// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

/// Where the rays that stand for a Gaussian beam lie in its cross-section, in its radii at 1/e². Each stands for an
/// equal share of the beam's strength: one per ring of that share, at the ring's mean square distance from the axis and
/// turned by the golden angle. So with two rays or more, the mean square distance is exactly the beam's, a half. One
/// ray is the axis.
std::vector<Vec2> beam_offsets(int rays);

}  // namespace meristem
