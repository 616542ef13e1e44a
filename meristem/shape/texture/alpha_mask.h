// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/image.h"
#include "meristem/base/mesh.h"
#include "meristem/base/vec.h"
#include "meristem/plant/material.h"
#include "meristem/shape/texture/pixel_neighbours.h"

namespace meristem {

/// The holes of a masked texture, for rays that query them at every leaf they hit. A small map of blocks, which stays
/// in the cache, answers most queries. Pixels are looked up only along the edges of holes.
class AlphaMask {
 public:
  explicit AlphaMask(const Image& image);
  /// Returns true if alpha, bilinear between pixels, is below one half.
  bool is_hole(Vec2 uv) const;

 private:
  enum class Block : std::uint8_t { solid, hole, edge };

  bool is_hole_at(const PixelNeighbours& columns, const PixelNeighbours& rows) const;
  Block block_at(int column, int row) const;

  int width_;
  int height_;
  int blocks_across_;
  std::vector<std::uint8_t> alpha_;
  std::vector<Block> blocks_;  ///< state of all positions in a square of 8 pixels, row by row
};

/// Returns the texture whose mask cuts holes into a mesh of this material, or null if there are no holes.
const Texture* texture_with_holes(const Material& material, const Mesh& mesh);

}  // namespace meristem
