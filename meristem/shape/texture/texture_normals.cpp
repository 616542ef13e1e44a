// SPDX-License-Identifier: Apache-2.0
// Converts a field of heights to a normal map by central differences.
#include "meristem/shape/texture/texture_normals.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr std::size_t kNormalRowsPerBlock = 16;

std::uint8_t byte_of(float component) { return static_cast<std::uint8_t>(127.5F * (component + 1) + 0.5F); }

}  // namespace

Image normals_of_heights(const std::vector<float>& heights, int pixels, const ReliefParameters& form) {
  Image image{pixels, pixels, {}};
  image.rgba.resize(4 * heights.size());
  const auto beside = [&](int index) {
    if (index >= 0 && index < pixels) return index;
    return form.wraps ? (index + pixels) % pixels : std::clamp(index, 0, pixels - 1);
  };
  const auto row_at = [&](int y) { return heights.data() + std::size_t{1} * pixels * beside(y); };
  // Central differences over two pixels, each 1 / pixels high.
  const float steep_v = static_cast<float>(form.relief) * 0.5F * static_cast<float>(pixels);
  const float steep_u = steep_v / static_cast<float>(form.aspect);
  parallel_for(static_cast<std::size_t>(pixels), kNormalRowsPerBlock, [&](std::size_t begin, std::size_t end) {
    for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      const float* row = row_at(y);
      const float* upper = row_at(y - 1);
      const float* lower = row_at(y + 1);
      for (int x = 0; x < pixels; ++x) {
        const float along_u = steep_u * (row[beside(x + 1)] - row[beside(x - 1)]);
        const float along_v = steep_v * (upper[x] - lower[x]);
        const float z = 1 / std::sqrt(along_u * along_u + along_v * along_v + 1);
        std::uint8_t* pixel = image.pixel(x, y);
        pixel[0] = byte_of(-along_u * z);
        pixel[1] = byte_of(-along_v * z);
        pixel[2] = byte_of(z);
        pixel[3] = 255;
      }
    }
  });
  return image;
}

}  // namespace meristem
