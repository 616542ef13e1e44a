// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/write/encoded_pictures.h"

#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/read_image.h"

namespace meristem::encoded_pictures_test {

using Kind = TexturePicture::Kind;

/// Returns colours and normals as textures have them: smooth, with some noise.
Texture some_texture() {
  Texture texture;
  texture.masked = true;
  for (Image* image : {&texture.colour, &texture.normals}) {
    *image = {64, 48, {}};
    for (int i = 0; i < 64 * 48; ++i) {
      for (const int value : {i / 64 + i * i % 7, 2 * (i % 64) + i % 3, 128, i % 64 < 30 ? 0 : 255}) {
        image->rgba.push_back(static_cast<std::uint8_t>(value));
      }
    }
  }
  return texture;
}

/// Returns the picture that a reader decodes from the bytes of a PNG.
Image read_back(const std::string& bytes) { return parse_image(bytes, "test.png", SizeLimits()); }

TEST(EncodedPictures, EveryPixelReadsBackAsItWas) {
  const Texture texture = some_texture();
  EncodedPictures pictures;
  const std::vector<TexturePicture> asked{{&texture, Kind::colour}, {&texture, Kind::normals}, {&texture, Kind::mask}};
  const auto bytes = pictures.encode(asked, Progress());
  ASSERT_EQ(bytes.size(), 3U);
  EXPECT_EQ(read_back(*bytes[0]).rgba, texture.colour.rgba);
  EXPECT_EQ(read_back(*bytes[1]).rgba, texture.normals.rgba);
  const Image mask = read_back(*bytes[2]);
  for (std::size_t i = 0; i < mask.rgba.size(); ++i) ASSERT_EQ(mask.rgba[i], texture.colour.rgba[i / 4 * 4 + 3]) << i;
}

TEST(EncodedPictures, AreEncodedOnce) {
  const Texture texture = some_texture();
  EncodedPictures pictures;
  const std::vector<TexturePicture> all{{&texture, Kind::colour}, {&texture, Kind::mask}, {&texture, Kind::colour}};
  const auto first = pictures.encode(all, Progress());
  EXPECT_EQ(first[0], first[2]);
  EXPECT_NE(first[0], first[1]);
  const auto second =
      pictures.encode(std::vector<TexturePicture>{{&texture, Kind::normals}, {&texture, Kind::mask}}, Progress());
  EXPECT_EQ(second[1], first[1]);
}

TEST(EncodedPictures, StayInOrderWhenCancelledOrASketch) {
  const Texture texture = some_texture();
  Texture sketch;
  sketch.colour = {64, 48, {}};
  EncodedPictures pictures;
  Progress stopped;
  stopped.cancel();
  const std::vector<TexturePicture> colour{{&texture, Kind::colour}};
  EXPECT_THROW(pictures.encode(colour, stopped), Cancelled);
  EXPECT_THROW(pictures.encode(std::vector<TexturePicture>{{&sketch, Kind::colour}}, Progress()),
               std::invalid_argument);
  EXPECT_EQ(read_back(*pictures.encode(colour, Progress())[0]).rgba, texture.colour.rgba);
}

}  // namespace meristem::encoded_pictures_test
