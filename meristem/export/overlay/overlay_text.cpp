// SPDX-License-Identifier: Apache-2.0
// Draws labels and the legend of overlays onto a finished picture. Letters get a light rim, so that they are legible on
// any background.
#include "meristem/export/overlay/overlay_text.h"

#include <algorithm>

#include "meristem/base/colour.h"
#include "meristem/output/write/small_text.h"

namespace meristem {

namespace {

constexpr Pixel kLegendInk{24, 26, 28};
constexpr Pixel kLegendRim{250, 250, 248};
constexpr int kRowsOfText = 60;  // number of text rows in a picture, without gaps

void write_with_rim(Image& image, int x, int y, int scale, std::string_view text) {
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) draw_small_text(image, x + dx * scale, y + dy * scale, scale, kLegendRim, text);
  }
  draw_small_text(image, x, y, scale, kLegendInk, text);
}

/// Draws a square of a colour with a rim.
void draw_key(Image& image, int x, int y, int size, Vec3 colour) {
  fill_square(image, x, y, size, kLegendRim);
  fill_square(image, x + 1, y + 1, size - 2,
              {byte_from_srgb(colour.r), byte_from_srgb(colour.g), byte_from_srgb(colour.b)});
}

}  // namespace

void write_overlay_text(Image& image, std::span<const OverlayLayer> layers, OnFilm on_film) {
  const int scale = std::max(1, image.height / (kRowsOfText * kSmallTextHeight));
  for (const OverlayLayer& layer : layers) {
    for (const OverlayLabel& label : layer.labels) {
      const std::optional<Vec2> seen = on_film(label.at);
      if (!seen) continue;
      const int x = static_cast<int>(0.5F * (seen->x + 1) * static_cast<float>(image.width));
      const int y = static_cast<int>(0.5F * (1 - seen->y) * static_cast<float>(image.height));
      write_with_rim(image, x - small_text_width(label.text, scale) / 2, y - scale * kSmallTextHeight / 2, scale,
                     label.text);
    }
  }
  const int line = scale * (kSmallTextHeight + 4);
  int y = line / 2;
  for (const OverlayLayer& layer : layers) {
    for (const OverlayKey& key : layer.legend) {
      const int square = scale * kSmallTextHeight;
      draw_key(image, line / 2, y, square, key.colour);
      write_with_rim(image, line / 2 + square + 4 * scale, y, scale, key.text);
      y += line;
    }
  }
}

}  // namespace meristem
