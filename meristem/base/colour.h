// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"

namespace meristem {

/// The light that a colour as documents write it (sRGB) stands for, each channel in [0, 1], equal on every machine.
Vec3 linear_from_srgb(Vec3 colour);

/// The sRGB value of linear light; values outside [0, 1] count as the nearer end.
Vec3 srgb_from_linear(Vec3 light);

/// How bright linear light looks (Rec. 709 weights).
inline float luminance(Vec3 light) { return 0.2126F * light.r + 0.7152F * light.g + 0.0722F * light.b; }

}  // namespace meristem
