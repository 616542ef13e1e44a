// SPDX-License-Identifier: Apache-2.0
#include "thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "base64.h"
#include "meristem/base/read_image.h"
#include "meristem/graph/table/file_access.h"
#include "meristem/output/write/png.h"

namespace meristem::studio {

Image shrunk(const Image& image, int size) {
  const double factor = static_cast<double>(std::max(image.width, image.height)) / size;
  if (factor <= 1) return image;
  Image small{.width = std::max(1, static_cast<int>(std::lround(image.width / factor))),
              .height = std::max(1, static_cast<int>(std::lround(image.height / factor))),
              .rgba = {}};
  small.rgba.resize(std::size_t{4} * small.width * small.height);
  // Colours count as far as their alpha says, so that what is masked does not show at the edges.
  for (int y = 0; y < small.height; ++y) {
    const int top = static_cast<int>(std::int64_t{1} * y * image.height / small.height);
    const int bottom = std::max(top + 1, static_cast<int>(std::int64_t{1} * (y + 1) * image.height / small.height));
    for (int x = 0; x < small.width; ++x) {
      const int left = static_cast<int>(std::int64_t{1} * x * image.width / small.width);
      const int right = std::max(left + 1, static_cast<int>(std::int64_t{1} * (x + 1) * image.width / small.width));
      std::array<double, 4> sum{};
      for (int v = top; v < bottom; ++v) {
        for (int u = left; u < right; ++u) {
          const std::uint8_t* pixel = image.pixel(u, v);
          for (int c = 0; c < 3; ++c) sum[c] += 1.0 * pixel[c] * pixel[3];
          sum[3] += pixel[3];
        }
      }
      std::uint8_t* const made = small.pixel(x, y);
      for (int c = 0; c < 3; ++c) made[c] = static_cast<std::uint8_t>(sum[3] > 0 ? std::lround(sum[c] / sum[3]) : 0);
      made[3] = static_cast<std::uint8_t>(std::lround(sum[3] / (1.0 * (bottom - top) * (right - left))));
    }
  }
  return small;
}

Value thumbnail(const std::string& file, int size, const std::string& document, const std::string& root,
                const Limits& limits) {
  const std::string folder = std::filesystem::path(document).parent_path().string();
  const std::string path = (std::filesystem::path(folder) / file).string();
  FileAccess{.folder = folder, .root = root}.require_within(path);
  const Image image = read_image(path, limits);
  return Value::Object{{"picture", base64(encode_png(shrunk(image, size), PixelKind::srgb, PngPacking::quick))},
                       {"width", image.width},
                       {"height", image.height}};
}

}  // namespace meristem::studio
