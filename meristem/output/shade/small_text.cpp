// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/shade/small_text.h"

#include <algorithm>
#include <cstddef>

namespace meristem {
namespace {

constexpr int kWidth = 5;
constexpr int kAdvance = 6;
constexpr std::string_view kLetters = "0123456789%:-.m";

/// Seven rows of each letter from above; the highest of a row's five bits is the left dot.
constexpr std::array<std::array<std::uint8_t, 7>, 15> kDots = {{
    {0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110},
    {0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110},
    {0b01110, 0b10001, 0b00001, 0b00010, 0b00100, 0b01000, 0b11111},
    {0b11111, 0b00010, 0b00100, 0b00010, 0b00001, 0b10001, 0b01110},
    {0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010},
    {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110},
    {0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110},
    {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000},
    {0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110},
    {0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100},
    {0b11000, 0b11001, 0b00010, 0b00100, 0b01000, 0b10011, 0b00011},
    {0b00000, 0b00110, 0b00110, 0b00000, 0b00110, 0b00110, 0b00000},
    {0b00000, 0b00000, 0b00000, 0b11111, 0b00000, 0b00000, 0b00000},
    {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b00110, 0b00110},
    {0b00000, 0b00000, 0b11010, 0b10101, 0b10101, 0b10001, 0b10001},
}};

void fill(Image& image, int x, int y, int size, Pixel colour) {
  for (int row = std::max(y, 0); row < std::min(y + size, image.height); ++row) {
    for (int column = std::max(x, 0); column < std::min(x + size, image.width); ++column) {
      std::copy(colour.begin(), colour.end(), image.pixel(column, row));
    }
  }
}

}  // namespace

void draw_small_text(Image& image, int x, int y, int scale, Pixel colour, std::string_view text) {
  for (const char letter : text) {
    const std::size_t number = kLetters.find(letter);
    for (int row = 0; number != std::string_view::npos && row < kSmallTextHeight; ++row) {
      for (int column = 0; column < kWidth; ++column) {
        const bool is_dot = (kDots[number][static_cast<std::size_t>(row)] >> (kWidth - 1 - column) & 1) != 0;
        if (is_dot) fill(image, x + scale * column, y + scale * row, scale, colour);
      }
    }
    x += scale * kAdvance;
  }
}

int small_text_width(std::string_view text, int scale) {
  return text.empty() ? 0 : scale * (kAdvance * static_cast<int>(text.size()) - 1);
}

}  // namespace meristem
