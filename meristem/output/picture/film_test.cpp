// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/film.h"

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::film_test {

constexpr int kWidth = 150;
constexpr int kHeight = 100;

/// Returns the exposure of a tile of a surface whose light grows from left to right, with noise.
Exposure exposure(const Tile& tile) {
  Exposure exposed;
  for (int y = tile.top; y < tile.bottom; ++y) {
    for (int x = tile.left; x < tile.right; ++x) {
      const Vec3 light(static_cast<float>(0.01 * x + RandomKey(3).child(x).uniform(y)));
      Seen seen;
      seen.sight = Sight::surface;
      seen.normal = kUp;
      seen.distance = 5;
      seen.albedo = Vec3(0.5F);
      seen.indirect = 0.5F * light;
      IndirectLight square;
      square.add(seen);
      exposed.indirect.push_back(square);
      exposed.pixels.push_back({Vec3(0.1F), {Vec3(0.5F), Vec3(0)}, 1});
    }
  }
  return exposed;
}

Film exposed_film(int width, int height) {
  Film film(width, height, 0.001F);
  for (int row = 0; row < film.rows(); ++row) {
    for (int column = 0; column < film.columns(); ++column) film.keep(column, row, exposure(film.tile(column, row)));
  }
  return film;
}

TEST(Film, TilesCoverEachPixelOnce) {
  const Film film(kWidth, kHeight, 0.001F);
  EXPECT_EQ(film.columns(), 3);
  EXPECT_EQ(film.rows(), 2);
  const Tile last = film.tile(2, 1);
  EXPECT_EQ(last.left, 128);
  EXPECT_EQ(last.top, 64);
  EXPECT_EQ(last.right, kWidth);
  EXPECT_EQ(last.bottom, kHeight);
}

TEST(Film, NoBorderOfATileShows) {
  // The pixels of tiles must equal the pixels of the whole picture.
  const Film film = exposed_film(kWidth, kHeight);
  const Exposure whole = exposure({0, 0, kWidth, kHeight});
  const std::vector<PerLayer<Vec3>> irradiance = gathered_irradiance(whole.indirect, kWidth, 0.001F);
  for (int row = 0; row < film.rows(); ++row) {
    for (int column = 0; column < film.columns(); ++column) {
      const Tile tile = film.tile(column, row);
      const std::vector<PixelLight> pixels = film.pixels(column, row);
      std::size_t at = 0;
      for (int y = tile.top; y < tile.bottom; ++y) {
        for (int x = tile.left; x < tile.right; ++x) {
          const Vec3 expected = Vec3(0.1F) + Vec3(0.5F) * irradiance[y * kWidth + x][0];
          ASSERT_EQ(pixels[at].light, expected) << x << ' ' << y;
          ASSERT_EQ(pixels[at].samples, 1);
          ++at;
        }
      }
      EXPECT_EQ(at, pixels.size());
    }
  }
}

TEST(Film, RowsThatAreFarCanBeDropped) {
  Film film = exposed_film(20, 250);
  const std::vector<PixelLight> before = film.pixels(0, 3);
  film.drop(0);
  film.drop(1);
  const std::vector<PixelLight> after = film.pixels(0, 3);
  for (std::size_t i = 0; i < before.size(); ++i) ASSERT_EQ(before[i].light, after[i].light);
}

}  // namespace meristem::film_test
