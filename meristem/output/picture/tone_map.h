// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"
#include "meristem/scene/light/sky.h"

namespace meristem {

/// Returns the brightening factor of a camera for the light of `sky`, and of lamps that cause this illuminance, so that
/// both noon and dusk give a usable picture. Only most of the difference is compensated, since full adaptation would
/// turn night into day.
float exposure(const Sky& sky, float lamplight = 0);

/// Returns the sRGB colour, in [0, 1], of exposed linear light. The contrast imitates film, and highlights roll off and
/// lose colour.
Vec3 tone_mapped(Vec3 light);

}  // namespace meristem
