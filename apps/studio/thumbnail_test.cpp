// SPDX-License-Identifier: Apache-2.0
#include "thumbnail.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/output/write/png.h"
#include "tests/support/temporary_folder.h"

namespace meristem::studio::thumbnail_test {

Image plain(int width, int height, std::array<std::uint8_t, 4> colour) {
  Image image{.width = width, .height = height, .rgba = {}};
  for (int k = 0; k < width * height; ++k) image.rgba.insert(image.rgba.end(), colour.begin(), colour.end());
  return image;
}

TEST(Thumbnail, KeepsTheShapeAndTheColour) {
  const Image small = shrunk(plain(300, 100, {10, 200, 30, 255}), 30, PixelKind::srgb);
  EXPECT_EQ(small.width, 30);
  EXPECT_EQ(small.height, 10);
  for (std::size_t k = 0; k < small.rgba.size(); k += 4) EXPECT_EQ(small.rgba[k + 1], 200);
  EXPECT_EQ(shrunk(plain(20, 10, {1, 2, 3, 4}), 30, PixelKind::srgb).width, 20);
  EXPECT_EQ(shrunk(plain(5000, 1, {1, 2, 3, 4}), 50, PixelKind::srgb).height, 1);
}

TEST(Thumbnail, TakesTheMeanOfLightAndOfNumbersAsTheyAre) {
  Image image = plain(2, 1, {255, 255, 255, 255});
  const std::array<std::uint8_t, 4> black{0, 0, 0, 255};
  std::copy(black.begin(), black.end(), image.pixel(1, 0));
  EXPECT_EQ(shrunk(image, 1, PixelKind::srgb).rgba[0], 188) << "half of the light";
  EXPECT_EQ(shrunk(image, 1, PixelKind::numbers).rgba[0], 128);
}

TEST(Thumbnail, TakesNoColourFromWhatIsMasked) {
  Image image = plain(2, 1, {200, 0, 0, 255});
  const std::array<std::uint8_t, 4> masked{0, 0, 255, 0};
  std::copy(masked.begin(), masked.end(), image.pixel(1, 0));
  const Image small = shrunk(image, 1, PixelKind::srgb);
  EXPECT_EQ(small.pixel(0, 0)[0], 200);
  EXPECT_EQ(small.pixel(0, 0)[2], 0);
  EXPECT_EQ(small.pixel(0, 0)[3], 128);
}

TEST(Thumbnail, ReadsBesideTheDocumentAndNothingOutside) {
  const TemporaryFolder folder;
  const std::string inside = (folder / "inside").string();
  std::filesystem::create_directory(inside);
  write_png(plain(40, 20, {1, 2, 3, 255}), inside + "/bark.png");
  write_png(plain(40, 20, {1, 2, 3, 255}), (folder / "secret.png").string());
  const Value made = thumbnail("bark.png", 16, inside + "/plant.json", inside, SizeLimits());
  EXPECT_EQ(*made.find("width")->number(), 40);
  EXPECT_EQ(made.find("picture")->text()->substr(0, 8), "iVBORw0K");
  EXPECT_THROW(thumbnail("../secret.png", 16, inside + "/plant.json", inside, SizeLimits()), InputError);
  EXPECT_THROW(thumbnail("plant.json", 16, inside + "/plant.json", inside, SizeLimits()), std::runtime_error);
}

}  // namespace meristem::studio::thumbnail_test
