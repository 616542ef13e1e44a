// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/texture/alpha_mask.h"

#include <memory>

#include <gtest/gtest.h>

namespace meristem::alpha_mask_test {

TEST(AlphaMask, IsAHoleBelowOneHalf) {
  const AlphaMask mask({2, 2, {0, 0, 0, 255, 0, 0, 0, 128, 0, 0, 0, 127, 0, 0, 0, 0}});
  EXPECT_FALSE(mask.is_hole({0.25F, 0.75F}));
  EXPECT_FALSE(mask.is_hole({0.75F, 0.75F}));
  EXPECT_TRUE(mask.is_hole({0.25F, 0.25F}));
  EXPECT_TRUE(mask.is_hole({0.75F, 0.25F}));
}

// An error in the map of blocks would show at the edges of blocks and of the picture, which repeats.
TEST(AlphaMask, IsAHoleWhereTheMeanOfItsPixelsSaysSo) {
  constexpr int kWidth = 37;
  constexpr int kHeight = 21;
  Image image{kWidth, kHeight, {}};
  const auto alpha = [](int x, int y) {
    x = (x + kWidth) % kWidth;
    y = (y + kHeight) % kHeight;
    if (x < 18) return 255;
    return (x - 27) * (x - 27) + (y - 10) * (y - 10) < 60 ? 128 : 127;
  };
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      image.rgba.insert(image.rgba.end(), {0, 0, 0, static_cast<std::uint8_t>(alpha(x, y))});
    }
  }
  const AlphaMask mask(image);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = -kWidth; x < kWidth; ++x) {
      // Three quarters of the distance from the middle of one pixel to the next, in both directions.
      const Vec2 uv((static_cast<float>(x) + 1.25F) / kWidth, 1 - (static_cast<float>(y) + 1.25F) / kHeight);
      const double upper = 0.25 * alpha(x, y) + 0.75 * alpha(x + 1, y);
      const double lower = 0.25 * alpha(x, y + 1) + 0.75 * alpha(x + 1, y + 1);
      ASSERT_EQ(mask.is_hole(uv), 0.25 * upper + 0.75 * lower < 127.5) << x << ", " << y;
    }
  }
}

TEST(AlphaMask, HolesNeedAMaskedTextureAndUvs) {
  auto texture = std::make_shared<Texture>();
  texture->colour = {1, 1, {255, 255, 255, 255}};
  texture->masked = true;
  Mesh mesh;
  mesh.positions.resize(3);
  mesh.uvs.resize(3);
  const Material material{.texture = texture};
  EXPECT_EQ(texture_with_holes(material, mesh), texture.get());
  EXPECT_EQ(texture_with_holes({}, mesh), nullptr);
  EXPECT_EQ(texture_with_holes(material, {}), nullptr);
  texture->masked = false;
  EXPECT_EQ(texture_with_holes(material, mesh), nullptr);
}

}  // namespace meristem::alpha_mask_test
