// SPDX-License-Identifier: Apache-2.0
// A canvas on which textures are painted, and the conversion to a texture.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "meristem/base/parallel.h"
#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/plant/texture.h"
#include "meristem/shape/texture/texture_normals.h"

namespace meristem {

/// One pixel of a canvas.
struct Dab {
  Vec3 light{1};     ///< linear colour; only proportions count, because the result is scaled to a mean
  float height = 0;  ///< in heights of the texture
};

/// A square, rows from top to bottom.
struct Canvas {
  /// `work` must outlive the canvas.
  Canvas(int pixels_a_side, const Progress& work)
      : pixels(pixels_a_side), progress(work), dabs(static_cast<std::size_t>(pixels) * pixels) {}

  int pixels;
  const Progress& progress;
  std::vector<Dab> dabs;
  std::vector<float> cover;  ///< visible share of each pixel; empty if nothing is cut out
};

/// Calls `dab_at(u, v, index)` for the middle of each pixel, v up. Throws Cancelled.
template <class DabAt>
void paint(Canvas& canvas, const DabAt& dab_at) {
  const auto pixels = static_cast<std::size_t>(canvas.pixels);
  const float step = 1 / static_cast<float>(canvas.pixels);
  parallel_for(pixels, 8, [&](std::size_t begin, std::size_t end) {
    canvas.progress.check();
    for (std::size_t y = begin; y < end; ++y) {
      const float v = 1 - (static_cast<float>(y) + 0.5F) * step;
      for (std::size_t x = 0; x < pixels; ++x) {
        const std::size_t index = y * pixels + x;
        canvas.dabs[index] = dab_at((static_cast<float>(x) + 0.5F) * step, v, index);
      }
    }
  });
}

/// Rises smoothly from 0 at `low` to 1 at `high`. Falls if `high` is lower than `low`.
inline float rise(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

struct Finish {
  std::string name;
  Vec3 colour{0.5F};  ///< sRGB; wanted mean, reached if possible
  ReliefParameters form;
};

/// Returns the texture of a canvas. Colours are scaled channel by channel to the mean, and clipped to white if they
/// would be brighter. Normals are computed unless the canvas is flat.
Texture finish_texture(const Canvas& canvas, const Finish& finish);

}  // namespace meristem
