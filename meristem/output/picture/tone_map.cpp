// SPDX-License-Identifier: Apache-2.0
// Maps exposed light to display colours. The curve describes an exposed film, 1 - exp(-x), which keeps shadows open and
// rolls highlights off. It acts on a mix of luminance and channels: with channels alone, bright leaves turn yellow, and
// with luminance alone, glare stays coloured.
#include "meristem/output/picture/tone_map.h"

#include <algorithm>

#include "meristem/base/colour.h"
#include "meristem/base/math.h"

namespace meristem {

namespace {

float exposed(float light) { return static_cast<float>(1 - math::exp(-std::max(0.0F, light))); }

}  // namespace

float exposure(const Sky& sky, float lamplight) {
  constexpr double kBase = 2.7;
  const double level = luminance(sky.sun_irradiance()) * std::max(0.35, static_cast<double>(sky.sun_direction().y)) +
                       luminance(sky.dome_irradiance()) + static_cast<double>(lamplight);
  return static_cast<float>(kBase * math::pow(std::max(level, 1e-4) / 2.45, -0.7));
}

Vec3 tone_mapped(Vec3 light) {
  constexpr float kSaturation = 1.15F;
  light = glm::max(glm::mix(Vec3(luminance(light)), light, kSaturation), Vec3(0));
  const Vec3 by_channel(exposed(light.r), exposed(light.g), exposed(light.b));
  const float bright = luminance(light);
  const Vec3 by_luminance = bright > 0 ? light * (exposed(bright) / bright) : Vec3(0);
  return srgb_from_linear(glm::mix(by_luminance, by_channel, 0.6F));
}

}  // namespace meristem
