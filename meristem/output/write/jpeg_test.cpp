// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/write/jpeg.h"

#include <cstdlib>
#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/limits.h"
#include "meristem/base/read_image.h"

namespace meristem::jpeg_test {

/// Returns waves with a little grain, like pictures of leaves.
Image waves(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int grain = (x * 37 + y * 91) % 23;
      for (const int value : {60 + x % 64 + grain, 90 + (x + y) % 48 + grain, 40 + y % 32 + grain, 255}) {
        image.rgba.push_back(static_cast<std::uint8_t>(value));
      }
    }
  }
  return image;
}

double mean_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.rgba.size(); ++k) sum += std::abs(static_cast<int>(a.rgba[k]) - b.rgba[k]);
  return sum / static_cast<double>(a.rgba.size());
}

Image read_back(const std::string& bytes) { return parse_image(bytes, "picture.jpg", SizeLimits{}); }

TEST(Jpeg, ReadsBackWithinWhatItsQualityPromises) {
  const Image image = waves(161, 97);
  const Image fine = read_back(encode_jpeg(image, {.quality = 100}));
  const Image rough = read_back(encode_jpeg(image, {.quality = 20}));
  ASSERT_EQ(fine.width, 161);
  ASSERT_EQ(fine.height, 97);
  EXPECT_LT(mean_difference(image, fine), 1.0);
  EXPECT_GT(mean_difference(image, rough), 2 * mean_difference(image, fine));
}

TEST(Jpeg, GivesTheSameBytesForTheSamePicture) {
  EXPECT_EQ(encode_jpeg(waves(80, 60)), encode_jpeg(waves(80, 60)));
  EXPECT_NE(encode_jpeg(waves(80, 60)), encode_jpeg(waves(80, 60), {.quality = 60}));
}

TEST(Jpeg, ASizeThatMayNotBePassedHasTheHighestQualityThatKeepsToIt) {
  const Image image = waves(200, 150);
  for (const int quality : {30, 55, 80}) {
    const std::string at_quality = encode_jpeg(image, {.quality = quality});
    EXPECT_EQ(encode_jpeg(image, {.max_bytes = at_quality.size()}), at_quality) << quality;
  }
  EXPECT_EQ(encode_jpeg(image, {.quality = 50, .max_bytes = 10'000'000}), encode_jpeg(image, {.quality = 50}));
}

TEST(Jpeg, RefusesQualitiesOutOfRangeAndSizesThatCannotBe) {
  for (const int quality : {0, -3, 101}) {
    EXPECT_THROW(encode_jpeg(waves(8, 8), {.quality = quality}), InputError) << quality;
  }
  EXPECT_THROW(encode_jpeg(waves(64, 64), {.max_bytes = 100}), InputError);
  EXPECT_THROW(encode_jpeg(Image{3, 3, {}}), std::invalid_argument);
}

}  // namespace meristem::jpeg_test
