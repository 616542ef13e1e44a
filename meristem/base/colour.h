// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "meristem/base/vec.h"

namespace meristem {

/// The light that a colour as documents write it (sRGB) stands for, each channel in [0, 1], equal on every machine.
Vec3 linear_from_srgb(Vec3 colour);

/// The sRGB value of linear light; values outside [0, 1] count as the nearer end.
Vec3 srgb_from_linear(Vec3 light);

/// A channel in [0, 1] as pictures hold it; values outside count as the nearer end.
inline std::uint8_t byte_from_srgb(float channel) {
  return static_cast<std::uint8_t>(std::clamp(255 * channel + 0.5F, 0.0F, 255.0F));
}

/// How bright linear light looks (Rec. 709 weights).
inline float luminance(Vec3 light) { return 0.2126F * light.r + 0.7152F * light.g + 0.0722F * light.b; }

}  // namespace meristem
