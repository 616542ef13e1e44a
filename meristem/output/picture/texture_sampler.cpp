// SPDX-License-Identifier: Apache-2.0
// Builds a pyramid of halved pictures in linear light, and reads means of any width from the nearest level.
#include "meristem/output/picture/texture_sampler.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/colour.h"
#include "meristem/shape/texture/pixel_neighbours.h"

namespace meristem {

namespace {

constexpr float kOne = 65535;

using ByteTable = std::array<std::uint16_t, 256>;

/// Returns the meaning of each byte of a picture, in 16 bits.
ByteTable decoded_bytes(PixelMeaning meaning) {
  ByteTable table;
  for (int i = 0; i < 256; ++i) {
    const float value = static_cast<float>(i) / 255;
    const float light = meaning == PixelMeaning::direction ? value : linear_from_srgb(Vec3(value)).g;
    table[i] = static_cast<std::uint16_t>(kOne * light + 0.5F);
  }
  return table;
}

/// The pixels of `count` that the `index`-th of `halves` covers, and the covered share of the last pixels.
struct Cover {
  int begin;
  int end;
  float first_share;
  float last_share;

  Cover(int index, int count, int halves) {
    const double scale = static_cast<double>(count) / halves;
    const double low = index * scale;
    const double high = (index + 1) * scale;
    begin = static_cast<int>(low);
    end = std::min(static_cast<int>(std::ceil(high - 1e-9)), count);
    first_share = static_cast<float>(begin + 1 - low);
    last_share = static_cast<float>(high - (end - 1));
  }
  float share(int at) const { return at == begin ? first_share : at == end - 1 ? last_share : 1.0F; }
};

}  // namespace

PixelPyramid::PixelPyramid(const Image& image, PixelMeaning meaning)
    : pixels_per_uv_(std::sqrt(static_cast<float>(image.width) * static_cast<float>(image.height))) {
  const ByteTable decoded = decoded_bytes(meaning);
  Level full{image.width, image.height, {}};
  full.pixels.resize(std::size_t{1} * image.width * image.height);
  for (std::size_t i = 0; i < full.pixels.size(); ++i) {
    const std::uint8_t* rgba = image.rgba.data() + 4 * i;
    const std::uint32_t alpha = meaning == PixelMeaning::masked_colour ? rgba[3] : 255;
    for (int c = 0; c < 3; ++c) {
      full.pixels[i][c] = static_cast<std::uint16_t>((decoded[rgba[c]] * alpha + 127) / 255);
    }
    full.pixels[i][3] = static_cast<std::uint16_t>(alpha * 257);
  }
  levels_.push_back(std::move(full));
  while (levels_.back().width > 1 || levels_.back().height > 1) levels_.push_back(halved(levels_.back()));
}

PixelPyramid::Level PixelPyramid::halved(const Level& level) {
  Level half{std::max(1, level.width / 2), std::max(1, level.height / 2), {}};
  half.pixels.reserve(std::size_t{1} * half.width * half.height);
  for (int y = 0; y < half.height; ++y) {
    const Cover rows(y, level.height, half.height);
    for (int x = 0; x < half.width; ++x) {
      const Cover columns(x, level.width, half.width);
      Vec4 sum(0);
      float weights = 0;
      for (int row = rows.begin; row < rows.end; ++row) {
        for (int column = columns.begin; column < columns.end; ++column) {
          const float weight = rows.share(row) * columns.share(column);
          const Pixel& pixel = level.pixels[std::size_t{1} * row * level.width + column];
          sum += weight * Vec4(pixel[0], pixel[1], pixel[2], pixel[3]);
          weights += weight;
        }
      }
      const Vec4 mean = sum / weights + 0.5F;
      half.pixels.push_back({static_cast<std::uint16_t>(mean.x), static_cast<std::uint16_t>(mean.y),
                             static_cast<std::uint16_t>(mean.z), static_cast<std::uint16_t>(mean.w)});
    }
  }
  return half;
}

Vec4 PixelPyramid::mean(Vec2 uv, float width) const {
  // Level n has pixels of width 2^n. Choose the nearest power of two, on a logarithmic scale.
  const float pixels = std::clamp(1.41421356F * width * pixels_per_uv_, 1.0F, 1e9F);
  const Level& level = levels_[std::min<std::size_t>(std::ilogb(pixels), levels_.size() - 1)];
  const PixelNeighbours columns(uv.x, level.width);
  const PixelNeighbours rows(1 - uv.y, level.height);
  const auto at = [&](int row, int column) {
    const Pixel& pixel = level.pixels[std::size_t{1} * row * level.width + column];
    return Vec4(pixel[0], pixel[1], pixel[2], pixel[3]);
  };
  const Vec4 upper = glm::mix(at(rows.first, columns.first), at(rows.first, columns.second), columns.share);
  const Vec4 lower = glm::mix(at(rows.second, columns.first), at(rows.second, columns.second), columns.share);
  return glm::mix(upper, lower, rows.share) / kOne;
}

TextureSampler::TextureSampler(const Texture& texture)
    : colours_(texture.colour, texture.masked ? PixelMeaning::masked_colour : PixelMeaning::colour),
      mean_(texture.mean) {
  if (texture.has_normals()) normals_.emplace_back(texture.normals, PixelMeaning::direction);
}

Vec3 TextureSampler::colour(Vec2 uv, float width) const {
  const Vec4 mean = colours_.mean(uv, width);
  return mean.w > 0.02F ? Vec3(mean) / mean.w : mean_;  // in a hole, only the mean is visible
}

Vec3 TextureSampler::normal(Vec2 uv, float width) const {
  const Vec3 mean = 2.0F * Vec3(normals_[0].mean(uv, width)) - 1.0F;
  const float length = glm::length(mean);
  return length > 1e-3F ? mean / length : Vec3(0, 0, 1);
}

}  // namespace meristem
