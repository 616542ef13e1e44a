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
