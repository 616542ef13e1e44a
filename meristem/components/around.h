// SPDX-License-Identifier: Apache-2.0
// How multipliers spread children about their heading.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/frame.h"

namespace meristem {

/// The turns (radians) of `number` children that are spread evenly over `arc`. A full turn ends where it began; a part
/// of one lies to both sides of 0 and has children at both ends.
std::vector<double> turns_around(std::uint32_t number, double arc);

/// Axes that are turned about the heading (y) by `turn` and tilted away from it by `angle`: the upper face looks to the
/// old heading.
Mat3 tilted(double turn, double angle);

}  // namespace meristem
