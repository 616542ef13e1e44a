// SPDX-License-Identifier: Apache-2.0
// Combines the exposures of tiles into pixels. Each pixel adds its direct light to its albedo times the indirect light
// that the squares around it gather (indirect_light.h).
#include "meristem/output/picture/film.h"

#include <algorithm>

namespace meristem {

Film::Film(int width, int height, float angle)
    : width_(width),
      height_(height),
      angle_(angle),
      columns_((width + kTile - 1) / kTile),
      rows_((height + kTile - 1) / kTile),
      exposures_(static_cast<std::size_t>(columns_) * rows_) {}

Tile Film::tile(int column, int row) const {
  return {column * kTile, row * kTile, std::min((column + 1) * kTile, width_), std::min((row + 1) * kTile, height_)};
}

const IndirectLight& Film::square(int x, int y) const {
  const int column = x / kTile;
  const Tile place = tile(column, y / kTile);
  return exposures_[y / kTile * columns_ + column]
      .indirect[(y - place.top) * (place.right - place.left) + x - place.left];
}

std::vector<PixelLight> Film::pixels(int column, int row) const {
  const Tile place = tile(column, row);
  const int left = std::max(0, place.left - kReachOfGathering);
  const int top = std::max(0, place.top - kReachOfGathering);
  const int right = std::min(width_, place.right + kReachOfGathering);
  const int bottom = std::min(height_, place.bottom + kReachOfGathering);
  std::vector<IndirectLight> squares;
  squares.reserve(static_cast<std::size_t>(right - left) * (bottom - top));
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) squares.push_back(square(x, y));
  }
  const std::vector<PerLayer<Vec3>> irradiance = gathered_irradiance(squares, right - left, angle_);

  std::vector<PixelLight> pixels;
  const std::vector<PixelExposure>& exposed = exposures_[row * columns_ + column].pixels;
  pixels.reserve(exposed.size());
  for (int y = place.top; y < place.bottom; ++y) {
    for (int x = place.left; x < place.right; ++x) {
      const PixelExposure& pixel = exposed[pixels.size()];
      const PerLayer<Vec3>& falling = irradiance[(y - top) * (right - left) + x - left];
      Vec3 light = pixel.direct;
      for (int layer = 0; layer < kLayers; ++layer) light += pixel.albedo[layer] * falling[layer];
      pixels.push_back({light, pixel.cover, square(x, y).samples});
    }
  }
  return pixels;
}

void Film::drop(int row) {
  for (int column = 0; column < columns_; ++column) exposures_[row * columns_ + column] = {};
}

}  // namespace meristem
