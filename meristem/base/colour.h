// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "meristem/base/vec.h"

namespace meristem {

/// Returns the linear light of an sRGB colour, the form in documents. Each channel is in [0, 1]. Results are equal on
/// every machine.
Vec3 linear_from_srgb(Vec3 colour);

/// Returns the sRGB value of linear light. Values outside [0, 1] are clamped.
Vec3 srgb_from_linear(Vec3 light);

/// Returns a channel in [0, 1] as a byte of a picture. Values outside are clamped.
inline std::uint8_t byte_from_srgb(float channel) {
  return static_cast<std::uint8_t>(std::clamp(255 * channel + 0.5F, 0.0F, 255.0F));
}

/// Returns how bright linear light looks (Rec. 709 weights).
inline float luminance(Vec3 light) { return 0.2126F * light.r + 0.7152F * light.g + 0.0722F * light.b; }

}  // namespace meristem
