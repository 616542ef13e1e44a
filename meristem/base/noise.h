// SPDX-License-Identifier: Apache-2.0
// Gradient noise: a smooth random function of one to three coordinates, the same for the same key everywhere.
#pragma once

#include "meristem/base/random.h"

namespace meristem {

/// Values lie in about [-1, 1] with mean 0 and vary over a distance of about 1; twice continuously differentiable. Zero
/// wherever all coordinates are whole numbers, so do not sample there. NaN where a coordinate is not finite; zero where
/// one is too large (2^52) to have a fraction. Different keys give unrelated functions.
double gradient_noise(RandomKey key, double x);
double gradient_noise(RandomKey key, double x, double y);
double gradient_noise(RandomKey key, double x, double y, double z);

}  // namespace meristem
