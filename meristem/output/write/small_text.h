// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "meristem/base/image.h"

namespace meristem {

using Pixel = std::array<std::uint8_t, 3>;  ///< sRGB

inline constexpr int kSmallTextHeight = 7;  ///< dots

/// Draws Latin letters, digits, spaces and some marks (% : - . _ [ ] ( ) , / + =) of 5 by 7 dots, a dot being `scale`
/// pixels wide, from the upper left corner (x, y) on. What lies beyond the picture is left out, and all else is as wide
/// as a space. Where the picture has an alpha channel, the text is opaque.
void draw_small_text(Image& image, int x, int y, int scale, Pixel colour, std::string_view text);
/// Fills a square of `size` pixels, from the upper left corner (x, y) on, as far as it is in the picture; opaque.
void fill_square(Image& image, int x, int y, int size, Pixel colour);
int small_text_width(std::string_view text, int scale);  ///< pixels

}  // namespace meristem
