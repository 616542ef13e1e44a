// SPDX-License-Identifier: Apache-2.0
// Textures for a path tracer: linear light, with means over any width from a pyramid of halved pictures.
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

/// The meaning of a picture's pixels.
enum class PixelMeaning {
  colour,         ///< sRGB; alpha has no meaning
  masked_colour,  ///< sRGB; pixels are weighted by their alpha in means
  direction,      ///< from -1 at 0 to 1 at 255
};

/// A repeating picture at full size, and halved down to one pixel. Every level has the mean of the picture.
class PixelPyramid {
 public:
  /// `image` must not be empty. Uses 8 bytes per pixel, and a third more for the halved pictures.
  PixelPyramid(const Image& image, PixelMeaning meaning);

  /// Returns the mean over a square of `width` about `uv`: bilinear in the level whose pixels are about as wide.
  /// Channels are in [0, 1]. For masked colours they are multiplied by the fourth channel.
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
  float pixels_per_uv_;  // pixels of the full size per uv, geometric mean of both directions
};

/// A prepared texture, for any number of threads.
class TextureSampler {
 public:
  explicit TextureSampler(const Texture& texture);

  /// Returns the linear colour about `uv`, a mean over a square of `width` in uvs.
  Vec3 colour(Vec2 uv, float width) const;
  bool has_normals() const { return !normals_.empty(); }
  /// Returns the unit normal in the surface's tangent space: x along u, y along v, z outward.
  Vec3 normal(Vec2 uv, float width) const;

 private:
  PixelPyramid colours_;
  std::vector<PixelPyramid> normals_;  // one entry, or none
  Vec3 mean_;
};

}  // namespace meristem
