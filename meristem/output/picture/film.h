// SPDX-License-Identifier: Apache-2.0
// What tiles of a picture have been exposed to, until their pixels are wanted: these gather indirect light beyond their
// tile's border, so that no border shows.
#pragma once

#include <vector>

#include "meristem/output/picture/photographer.h"

namespace meristem {

/// What is seen through a pixel.
struct PixelLight {
  Vec3 light{0};  ///< weighted by how much of it hides the background
  float cover = 0;
  int samples = 0;  ///< that were taken in its square
};

class Film {
 public:
  static constexpr int kTile = 64;  ///< pixels along a tile

  /// A film of this many pixels, each as wide as `angle` (radians) is from the camera.
  Film(int width, int height, float angle);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// The pixels of a tile, with fewer in the last column and row.
  Tile tile(int column, int row) const;

  /// Keeps what a tile has been exposed to. Different tiles may be kept at once.
  void keep(int column, int row, Exposure exposure) { exposures_[row * columns_ + column] = std::move(exposure); }
  /// The pixels of a tile, row by row; the tiles around it must have been kept.
  std::vector<PixelLight> pixels(int column, int row) const;
  /// Gives back the memory of a row of tiles.
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
