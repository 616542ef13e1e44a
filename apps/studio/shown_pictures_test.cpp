// SPDX-License-Identifier: Apache-2.0
#include "shown_pictures.h"

#include <gtest/gtest.h>

#include "meristem/shape/texture/texture_recipe.h"

namespace meristem::studio::shown_pictures_test {

constexpr int kPixels = 128;
const Vec3 kBrown(0.42F, 0.35F, 0.28F);
const Vec3 kRed(0.66F, 0.2F, 0.15F);
const Vec3 kGreen(0.3F, 0.45F, 0.16F);

TEST(ShownPictures, BarkOfAnotherColourIsATintOfTheSamePicture) {
  for (const BarkRecipe::Style style : {BarkRecipe::Style::smooth, BarkRecipe::Style::furrowed}) {
    const BarkRecipe recipe{.style = style};
    EXPECT_TRUE(look_alike(make_bark_texture(recipe, kBrown, kPixels), make_bark_texture(recipe, kRed, kPixels), kRed));
  }
}

TEST(ShownPictures, SeamsOfAColourOfTheirOwnAreToldFromTintedOnes) {
  const BarkRecipe recipe{.style = BarkRecipe::Style::furrowed, .seams = Vec3(0.1F, 0.4F, 0.1F)};
  const Texture brown = make_bark_texture(recipe, kBrown, kPixels);
  EXPECT_FALSE(look_alike(brown, make_bark_texture(recipe, kRed, kPixels), kRed));
  EXPECT_TRUE(look_alike(brown, brown, kRed));
}

TEST(ShownPictures, LeavesOfNearColoursLookAlikeAndOfFarOnesDoNot) {
  const LeafRecipe recipe;
  const TextureShape shape;
  const Texture green = make_leaf_texture(recipe, shape, kGreen, kPixels);
  const Vec3 near = kGreen + Vec3(0.01F, 0.01F, 0);
  EXPECT_TRUE(look_alike(green, make_leaf_texture(recipe, shape, near, kPixels), near));
  EXPECT_FALSE(look_alike(green, make_leaf_texture(recipe, shape, kRed, kPixels), kRed));
}

TEST(ShownPictures, PicturesOfOtherSizesAreNeverAlike) {
  const BarkRecipe recipe;
  EXPECT_FALSE(
      look_alike(make_bark_texture(recipe, kRed, kPixels), make_bark_texture(recipe, kRed, 2 * kPixels), kRed));
}

}  // namespace meristem::studio::shown_pictures_test
