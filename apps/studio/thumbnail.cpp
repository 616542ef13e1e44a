// SPDX-License-Identifier: Apache-2.0
// Shrinks pictures by the mean of the pixels in each block. Colours are averaged as linear light and weighted by alpha.
#include "thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "base64.h"
#include "meristem/base/colour.h"
#include "meristem/base/read_image.h"
#include "meristem/base/vec.h"
#include "meristem/graph/table/file_access.h"

namespace meristem::studio {

namespace {

/// Returns the value of each byte of a picture, 0 to 1.
std::array<float, 256> meanings(PixelKind kind) {
  std::array<float, 256> meanings{};
  for (std::size_t k = 0; k < meanings.size(); ++k) {
    const float share = static_cast<float>(k) / 255.0F;
    meanings[k] = kind == PixelKind::srgb ? linear_from_srgb(Vec3(share)).r : share;
  }
  return meanings;
}

/// Returns the sums of a block of pixels: red, green and blue, weighted by alpha, and alpha.
Vec4 sum_of(const Image& image, const std::array<float, 256>& meaning, int left, int top, int right, int bottom) {
  Vec4 sum(0);
  for (int y = top; y < bottom; ++y) {
    const std::uint8_t* pixel = image.pixel(left, y);
    for (int x = left; x < right; ++x, pixel += 4) {
      sum += static_cast<float>(pixel[3]) * Vec4(meaning[pixel[0]], meaning[pixel[1]], meaning[pixel[2]], 1);
    }
  }
  return sum;
}

}  // namespace

Image shrunk(const Image& image, int size, PixelKind kind) {
  const double factor = static_cast<double>(std::max(image.width, image.height)) / size;
  if (factor <= 1) return image;
  Image small{.width = std::max(1, static_cast<int>(std::lround(image.width / factor))),
              .height = std::max(1, static_cast<int>(std::lround(image.height / factor))),
              .rgba = {}};
  small.rgba.resize(std::size_t{4} * small.width * small.height);
  const std::array<float, 256> meaning = meanings(kind);
  const auto edge = [](int at, int count, int of) { return static_cast<int>(std::int64_t{1} * at * count / of); };
  for (int y = 0; y < small.height; ++y) {
    const int top = edge(y, image.height, small.height);
    const int bottom = std::max(top + 1, edge(y + 1, image.height, small.height));
    for (int x = 0; x < small.width; ++x) {
      const int left = edge(x, image.width, small.width);
      const int right = std::max(left + 1, edge(x + 1, image.width, small.width));
      // Colours are weighted by alpha, so that masked pixels do not show at the edges.
      const Vec4 sum = sum_of(image, meaning, left, top, right, bottom);
      const Vec3 mean = sum.w > 0 ? Vec3(sum) / sum.w : Vec3(0);
      const Vec3 shown = kind == PixelKind::srgb ? srgb_from_linear(mean) : mean;
      std::uint8_t* const made = small.pixel(x, y);
      for (int c = 0; c < 3; ++c) made[c] = byte_from_srgb(shown[c]);
      made[3] = byte_from_srgb(sum.w / (255.0F * static_cast<float>((bottom - top) * (right - left))));
    }
  }
  return small;
}

Value thumbnail(const std::string& file, int size, const std::string& document, const std::string& root,
                const SizeLimits& limits) {
  const std::string folder = std::filesystem::path(document).parent_path().string();
  const std::string path = (std::filesystem::path(folder) / file).string();
  FileAccess{.folder = folder, .root = root}.require_within(path);
  const Image image = read_image(path, limits);
  return Value::Object{
      {"picture", base64(encode_png(shrunk(image, size, PixelKind::srgb), PixelKind::srgb, PngPacking::quick))},
      {"width", image.width},
      {"height", image.height}};
}

}  // namespace meristem::studio
