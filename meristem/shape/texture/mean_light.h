// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/image.h"
#include "meristem/base/vec.h"

namespace meristem {

/// Returns the linear mean of a picture's colours, weighted by alpha if `masked`. Returns white for a picture without
/// visible pixels.
Vec3 mean_light(const Image& colour, bool masked);

}  // namespace meristem
