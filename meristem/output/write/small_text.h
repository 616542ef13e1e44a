// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "meristem/base/image.h"

namespace meristem {

using Pixel = std::array<std::uint8_t, 3>;  ///< sRGB

inline constexpr int kSmallTextHeight = 7;  ///< height in dots

/// Draws Latin letters, digits, spaces and some marks (% : - . _ [ ] ( ) , / + =), 5 by 7 dots each, from the upper
/// left corner (x, y). A dot is `scale` pixels wide. Parts outside the picture are left out, and all other characters
/// are blanks. If the picture has an alpha channel, the text is opaque.
void draw_small_text(Image& image, int x, int y, int scale, Pixel colour, std::string_view text);
/// Fills a square of `size` pixels from the upper left corner (x, y), opaque. Parts outside the picture are left out.
void fill_square(Image& image, int x, int y, int size, Pixel colour);
int small_text_width(std::string_view text, int scale);  ///< width in pixels

}  // namespace meristem
