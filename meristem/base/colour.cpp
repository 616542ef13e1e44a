// SPDX-License-Identifier: Apache-2.0
// Converts colours between sRGB and linear light.
//
// Based on: IEC 61966-2-1:1999, the sRGB transfer function.
#include "meristem/base/colour.h"

#include <algorithm>

#include "meristem/base/math.h"

namespace meristem {

namespace {

float decoded(float value) {
  const double v = std::clamp(static_cast<double>(value), 0.0, 1.0);
  return static_cast<float>(v <= 0.04045 ? v / 12.92 : math::pow((v + 0.055) / 1.055, 2.4));
}

float encoded(float light) {
  const double v = std::clamp(static_cast<double>(light), 0.0, 1.0);
  return static_cast<float>(v <= 0.0031308 ? v * 12.92 : 1.055 * math::pow(v, 1 / 2.4) - 0.055);
}

}  // namespace

Vec3 linear_from_srgb(Vec3 colour) { return {decoded(colour.r), decoded(colour.g), decoded(colour.b)}; }

Vec3 srgb_from_linear(Vec3 light) { return {encoded(light.r), encoded(light.g), encoded(light.b)}; }

}  // namespace meristem
