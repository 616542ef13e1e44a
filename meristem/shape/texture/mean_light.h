// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/image.h"
#include "meristem/base/vec.h"

namespace meristem {

/// The linear mean of a picture's colours, weighted by alpha where `masked`; white for one that is all cut out.
Vec3 mean_light(const Image& colour, bool masked);

}  // namespace meristem
