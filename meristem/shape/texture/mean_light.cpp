// SPDX-License-Identifier: Apache-2.0
// Averages the linear light of a picture. Bytes are counted first, so that the sums are exact and independent of order.
#include "meristem/shape/texture/mean_light.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "meristem/base/colour.h"

namespace meristem {

namespace {

std::array<double, 256> light_of_bytes() {
  std::array<double, 256> lights{};
  for (std::size_t k = 0; k < lights.size(); ++k) {
    lights[k] = linear_from_srgb(Vec3(static_cast<float>(k) / 255)).r;
  }
  return lights;
}

}  // namespace

Vec3 mean_light(const Image& colour, bool masked) {
  static const std::array<double, 256> light_of_byte = light_of_bytes();
  // Sums of whole numbers are exact, so count the bytes first.
  std::array<std::array<std::uint64_t, 256>, 3> counts{};
  std::uint64_t total = 0;
  for (std::size_t k = 0; k < colour.rgba.size(); k += 4) {
    const std::uint64_t weight = masked ? colour.rgba[k + 3] : 255;
    for (std::size_t channel = 0; channel < 3; ++channel) counts[channel][colour.rgba[k + channel]] += weight;
    total += weight;
  }
  if (total == 0) return Vec3(1);
  Vec3 mean;
  for (int channel = 0; channel < 3; ++channel) {
    double sum = 0;
    for (std::size_t byte = 0; byte < 256; ++byte) {
      sum += static_cast<double>(counts[static_cast<std::size_t>(channel)][byte]) * light_of_byte[byte];
    }
    mean[channel] = static_cast<float>(sum / static_cast<double>(total));
  }
  return mean;
}

}  // namespace meristem
