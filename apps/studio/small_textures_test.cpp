// SPDX-License-Identifier: Apache-2.0
#include "small_textures.h"

#include <gtest/gtest.h>

namespace meristem::studio::small_textures_test {

Image plain(int width, int height, std::uint8_t grey) {
  return {.width = width, .height = height, .rgba = std::vector<std::uint8_t>(std::size_t{4} * width * height, grey)};
}

Material wearing(std::shared_ptr<const Texture> texture) {
  Material material;
  material.texture = std::move(texture);
  return material;
}

TEST(SmallTextures, AreMadeOnceForAllWhoWearThem) {
  const auto bark = std::make_shared<const Texture>(
      Texture{.name = "bark", .colour = plain(128, 64, 90), .normals = plain(128, 64, 128), .mean = Vec3(0.1F)});
  const auto leaf =
      std::make_shared<const Texture>(Texture{.name = "leaf", .colour = plain(16, 16, 200), .normals = {}});
  const auto sketch =
      std::make_shared<const Texture>(Texture{.name = "sketch", .colour = {128, 128, {}}, .normals = {}});
  std::vector<Material> first{wearing(bark), wearing(leaf), wearing(nullptr)};
  std::vector<Material> second{wearing(sketch), wearing(bark)};
  SmallTextures textures;
  const Progress progress;
  textures.fit({&first, &second}, 32, progress);
  const std::shared_ptr<const Texture> small = first[0].texture;
  EXPECT_EQ(small->colour.width, 32);
  EXPECT_EQ(small->colour.height, 16);
  EXPECT_EQ(small->colour.rgba[0], 90);
  EXPECT_EQ(small->normals.width, 32);
  EXPECT_EQ(small->mean, bark->mean);
  EXPECT_EQ(first[1].texture, leaf) << "it is small enough";
  EXPECT_EQ(second[0].texture, sketch) << "it has no pixels";
  EXPECT_EQ(second[1].texture, small);

  std::vector<Material> later{wearing(bark)};
  textures.fit({&later}, 32, progress);
  EXPECT_EQ(later[0].texture, small) << "it stays for the next pictures";
  later = {wearing(bark)};
  textures.fit({&later}, 64, progress);
  EXPECT_EQ(later[0].texture->colour.width, 64);
}

}  // namespace meristem::studio::small_textures_test
