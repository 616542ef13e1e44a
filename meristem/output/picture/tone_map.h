// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"
#include "meristem/scene/light/sky.h"

namespace meristem {

/// How much a camera would open for the light of `sky`, and of lamps that give what it sees this illuminance, so that
/// noon and dusk both make a picture: full adaptation would turn night into day, so only most of the change is made up
/// for.
float exposure(const Sky& sky, float lamplight = 0);

/// The sRGB colour, in [0, 1], of exposed linear light: contrast of film, highlights that roll off and lose colour.
Vec3 tone_mapped(Vec3 light);

}  // namespace meristem
