// SPDX-License-Identifier: Apache-2.0
// The film of a picture: it stores the exposures of tiles until their pixels are computed. Pixels gather indirect light
// beyond the border of their tile, so that borders are invisible.
#pragma once

#include <vector>

#include "meristem/output/picture/photographer.h"

namespace meristem {

/// The light through one pixel.
struct PixelLight {
  Vec3 light{0};  ///< weighted by how much of the background is hidden
  float cover = 0;
  int samples = 0;  ///< number of samples taken in the pixel's square
};

class Film {
 public:
  static constexpr int kTile = 64;  ///< pixels along a tile

  /// Creates a film of width x height pixels. `angle` is the width of a pixel as seen from the camera, radians.
  Film(int width, int height, float angle);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// Returns the pixels of a tile. Tiles in the last column and row can be smaller.
  Tile tile(int column, int row) const;

  /// Stores the exposure of a tile. Different tiles may be stored at the same time.
  void keep(int column, int row, Exposure exposure) { exposures_[row * columns_ + column] = std::move(exposure); }
  /// Returns the pixels of a tile, row by row. The surrounding tiles must have been stored.
  std::vector<PixelLight> pixels(int column, int row) const;
  /// Frees the memory of a row of tiles.
  void drop(int row);

 private:
  const IndirectLight& square(int x, int y) const;

  int width_;
  int height_;
  float angle_;
  int columns_;
  int rows_;
  std::vector<Exposure> exposures_;
};

}  // namespace meristem
