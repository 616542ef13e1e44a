// SPDX-License-Identifier: Apache-2.0
// Based on: K. Narkowicz: ACES filmic tone mapping curve (2016), the rational fit, here over a mix of luminance and
// channels, because channels alone turn bright leaves yellow.
#include "meristem/output/tone_map.h"

#include <algorithm>

#include "meristem/base/math.h"
#include "meristem/output/colour.h"

namespace meristem {

namespace {

float filmic(float x) {
  x = std::max(x, 0.0F) * 0.6F;
  return std::min((x * (2.51F * x + 0.03F)) / (x * (2.43F * x + 0.59F) + 0.14F), 1.0F);
}

}  // namespace

float exposure(const Sky& sky) {
  constexpr double kBase = 1.25;
  const double level = luminance(sky.sun_irradiance()) * std::max(0.35, static_cast<double>(sky.sun_direction().y)) +
                       luminance(sky.dome_irradiance());
  return static_cast<float>(kBase * math::pow(std::max(level, 1e-4) / 2.45, -0.7));
}

Vec3 tone_mapped(Vec3 light) {
  const Vec3 by_channel(filmic(light.r), filmic(light.g), filmic(light.b));
  const float bright = luminance(light);
  const Vec3 by_luminance = bright > 0 ? light * (filmic(bright) / bright) : Vec3(0);
  return srgb_from_linear(glm::mix(by_luminance, by_channel, 0.6F));
}

}  // namespace meristem
