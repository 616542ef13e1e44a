// SPDX-License-Identifier: Apache-2.0
// Gradient noise: a smooth random function of one to three coordinates. A key gives equal values on every machine.
#pragma once

#include "meristem/base/random.h"

namespace meristem {

/// Returns the noise at a point. Values are in about [-1, 1] with mean 0, vary over a distance of about 1, and are
/// twice continuously differentiable. The noise is zero where all coordinates are whole numbers, so do not sample
/// there. Returns NaN if a coordinate is not finite, and zero if one is too large (2^52) to have a fraction. Different
/// keys give unrelated functions.
double gradient_noise(RandomKey key, double x);
double gradient_noise(RandomKey key, double x, double y);
double gradient_noise(RandomKey key, double x, double y, double z);

}  // namespace meristem
