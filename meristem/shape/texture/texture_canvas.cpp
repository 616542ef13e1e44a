// SPDX-License-Identifier: Apache-2.0
// Converts a canvas to a texture. A gain per channel, found from a histogram of light, brings the mean to the wanted
// colour in spite of clipping. Heights become normals.
#include "meristem/shape/texture/texture_canvas.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "meristem/base/colour.h"
#include "meristem/shape/texture/mean_light.h"

namespace meristem {

namespace {

/// Converts linear light to bytes by its square root, which is nearly even to the eye.
class ByteOfLight {
 public:
  ByteOfLight() {
    for (std::size_t k = 0; k < bytes_.size(); ++k) {
      const float root = (static_cast<float>(k) + 0.5F) / static_cast<float>(bytes_.size());
      bytes_[k] = static_cast<std::uint8_t>(255 * srgb_from_linear(Vec3(root * root)).r + 0.5F);
    }
  }
  std::uint8_t operator()(float light) const {
    const float root = std::sqrt(std::clamp(light, 0.0F, 1.0F));
    return bytes_[std::min(static_cast<std::size_t>(root * static_cast<float>(bytes_.size())), bytes_.size() - 1)];
  }

 private:
  std::array<std::uint8_t, 8192> bytes_{};
};

/// A histogram of the light of one channel on a canvas, in steps of the brightest.
struct LightCounts {
  LightCounts(const Canvas& canvas, int channel) {
    for (const Dab& dab : canvas.dabs) brightest = std::max(brightest, dab.light[channel]);
    if (brightest <= 0) return;
    const float scale = static_cast<float>(counts.size() - 1) / brightest;
    for (std::size_t k = 0; k < canvas.dabs.size(); ++k) {
      const auto step = static_cast<std::size_t>(std::max(canvas.dabs[k].light[channel], 0.0F) * scale + 0.5F);
      // In 255ths of a pixel, so that sums are exact.
      counts[step] += canvas.cover.empty() ? 255 : static_cast<std::uint64_t>(255 * canvas.cover[k] + 0.5F);
    }
  }

  /// Returns the mean after all lights are multiplied by `gain` and clipped at 1.
  double mean(double gain) const {
    double sum = 0;
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < counts.size(); ++k) {
      const double light = brightest * static_cast<double>(k) / static_cast<double>(counts.size() - 1);
      sum += static_cast<double>(counts[k]) * std::min(gain * light, 1.0);
      count += counts[k];
    }
    return count == 0 ? 0 : sum / static_cast<double>(count);
  }

  float brightest = 0;
  std::array<std::uint64_t, 2048> counts{};
};

/// Returns the factor that brings a channel to its mean.
float gain_to(const LightCounts& lights, double mean) {
  constexpr int kHalvings = 30;
  if (lights.brightest <= 0) return 0;
  double low = 0;
  double high = 64 / static_cast<double>(lights.brightest);
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (lights.mean(middle) < mean ? low : high) = middle;
  }
  return static_cast<float>(low);
}

Image colours_of(const Canvas& canvas, Vec3 gain) {
  static const ByteOfLight byte_of_light;
  Image image{canvas.pixels, canvas.pixels, {}};
  image.rgba.resize(4 * canvas.dabs.size());
  for (std::size_t k = 0; k < canvas.dabs.size(); ++k) {
    std::uint8_t* pixel = image.rgba.data() + 4 * k;
    const Vec3 light = gain * canvas.dabs[k].light;
    for (int channel = 0; channel < 3; ++channel) pixel[channel] = byte_of_light(light[channel]);
    pixel[3] = canvas.cover.empty() ? 255 : static_cast<std::uint8_t>(255 * canvas.cover[k] + 0.5F);
  }
  return image;
}

}  // namespace

Texture finish_texture(const Canvas& canvas, const Finish& finish) {
  const Vec3 wanted = linear_from_srgb(finish.colour);
  Vec3 gain;
  for (int channel = 0; channel < 3; ++channel) {
    gain[channel] = gain_to(LightCounts(canvas, channel), wanted[channel]);
  }
  Texture texture;
  texture.name = finish.name;
  texture.masked = !canvas.cover.empty();
  texture.colour = colours_of(canvas, gain);
  texture.mean = mean_light(texture.colour, texture.masked);
  if (finish.form.relief > 0) {
    std::vector<float> heights(canvas.dabs.size());
    for (std::size_t k = 0; k < heights.size(); ++k) heights[k] = canvas.dabs[k].height;
    texture.normals = normals_of_heights(heights, canvas.pixels, finish.form);
  }
  return texture;
}

}  // namespace meristem
