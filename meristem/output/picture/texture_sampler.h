// SPDX-License-Identifier: Apache-2.0
// Textures as a path tracer reads them: linear light, means over any width from a pyramid of halved pictures.
//
// Based on: L. Williams: Pyramidal parametrics (1983).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meristem/base/image.h"
#include "meristem/base/vec.h"
#include "meristem/plant/texture.h"

namespace meristem {

/// What the pixels of a picture are.
enum class PixelMeaning {
  colour,         ///< sRGB, alpha without a meaning
  masked_colour,  ///< sRGB; pixels count in means as far as their alpha says
  direction,      ///< from -1 at 0 to 1 at 255
};

/// A picture that repeats, at full size and halved down to one pixel. Every level has the same mean.
class PixelPyramid {
 public:
  /// `image` is not empty. Takes 8 bytes per pixel and a third more for the halves.
  PixelPyramid(const Image& image, PixelMeaning meaning);

  /// The mean over a square of `width` about `uv`: bilinear in the level whose pixels are about that wide. The
  /// channels in [0, 1]; of masked colours, multiplied by the fourth.
  Vec4 mean(Vec2 uv, float width) const;

 private:
  using Pixel = std::array<std::uint16_t, 4>;
  struct Level {
    int width = 0;
    int height = 0;
    std::vector<Pixel> pixels;  // rows from top to bottom
  };
  static Level halved(const Level& level);

  std::vector<Level> levels_;
  float pixels_per_uv_;  // of the full size, the geometric mean of both ways
};

/// One texture, ready for any number of threads.
class TextureSampler {
 public:
  explicit TextureSampler(const Texture& texture);

  /// The linear colour about `uv`, a mean over a square of `width` in uvs.
  Vec3 colour(Vec2 uv, float width) const;
  bool has_normals() const { return !normals_.empty(); }
  /// The unit normal in the surface's tangent space: x along u, y along v, z outward.
  Vec3 normal(Vec2 uv, float width) const;

 private:
  PixelPyramid colours_;
  std::vector<PixelPyramid> normals_;  // one, or none
  Vec3 mean_;
};

}  // namespace meristem
