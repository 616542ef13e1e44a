// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meristem {

/// An 8-bit picture with alpha, rows from top to bottom, alpha not premultiplied.
struct Image {
  int width = 0;                   ///< pixels
  int height = 0;                  ///< pixels
  std::vector<std::uint8_t> rgba;  ///< 4 bytes per pixel; colours are in sRGB

  bool is_empty() const { return width == 0 || height == 0; }  ///< true for a picture without pixels
  /// Returns the four bytes of the pixel in column `x` from the left and row `y` from the top. The pixel must be in the
  /// picture.
  const std::uint8_t* pixel(int x, int y) const { return rgba.data() + 4 * (std::size_t{1} * y * width + x); }
  std::uint8_t* pixel(int x, int y) { return rgba.data() + 4 * (std::size_t{1} * y * width + x); }
};

}  // namespace meristem
