// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "meristem/base/colour.h"
#include "meristem/base/parallel.h"
#include "meristem/shape/texture/mean_light.h"
#include "meristem/shape/texture/texture_recipe.h"

namespace meristem::leaf_texture_test {

constexpr int kPixels = 128;
constexpr Vec3 kGreen{0.33F, 0.46F, 0.2F};

constexpr LeafRecipe::Veins kVeins[] = {LeafRecipe::Veins::pinnate, LeafRecipe::Veins::palmate,
                                        LeafRecipe::Veins::parallel};

const TextureShape kLozenge{{{0.5F, 0}, {1, 0.5F}, {0.5F, 1}, {0, 0.5F}}, true};

float light_at(const Texture& texture, int x, int y) {
  const std::uint8_t* pixel = texture.colour.pixel(x, y);
  return static_cast<float>(pixel[0] + pixel[1] + pixel[2]);
}

TEST(LeafTexture, IsMaskedByItsOutlineWithSoftEdges) {
  const Texture texture = make_leaf_texture({}, kLozenge, kGreen, kPixels);
  EXPECT_TRUE(texture.masked);
  double sum = 0;
  std::set<int> values;
  for (std::size_t k = 3; k < texture.colour.rgba.size(); k += 4) {
    sum += texture.colour.rgba[k] / 255.0;
    values.insert(texture.colour.rgba[k]);
  }
  EXPECT_NEAR(sum / (kPixels * kPixels), 0.5, 0.002);
  EXPECT_GE(values.size(), 3U);
  EXPECT_EQ(texture.colour.pixel(0, 0)[3], 0);
  EXPECT_EQ(texture.colour.pixel(kPixels / 2, kPixels / 2)[3], 255);
}

TEST(LeafTexture, FillsTheSquareWithoutAMask) {
  TextureShape shape = kLozenge;
  for (shape.masked = false; const std::vector<Vec2>& outline : {kLozenge.outline, std::vector<Vec2>{}}) {
    shape.outline = outline;
    const Texture texture = make_leaf_texture({}, shape, kGreen, kPixels);
    EXPECT_FALSE(texture.masked);
    for (std::size_t k = 3; k < texture.colour.rgba.size(); k += 4) ASSERT_EQ(texture.colour.rgba[k], 255);
  }
}

TEST(LeafTexture, OutsideItsMaskHasColoursOfItsMargin) {
  // Pixels that filters mix with inner pixels must have a similar colour.
  for (const LeafRecipe::Veins veins : kVeins) {
    const Texture texture = make_leaf_texture({.veins = veins}, kLozenge, kGreen, kPixels);
    for (int y = 10; y < kPixels - 10; ++y) {
      for (int x = 1; x < kPixels; ++x) {
        if (texture.colour.pixel(x - 1, y)[3] != 0 || texture.colour.pixel(x, y)[3] == 0) continue;
        EXPECT_GT(light_at(texture, x - 1, y), 0.5F * light_at(texture, x, y)) << x << " " << y;
        EXPECT_LT(light_at(texture, x - 1, y), 2 * light_at(texture, x, y)) << x << " " << y;
      }
    }
  }
}

TEST(LeafTexture, HasTheMeanItIsAskedForWithinItsOutline) {
  for (const LeafRecipe::Veins veins : kVeins) {
    const Texture texture =
        make_leaf_texture({.veins = veins, .edge_colour = Vec3(0.7F, 0.2F, 0.1F)}, kLozenge, kGreen, kPixels);
    EXPECT_LT(glm::distance(texture.mean, linear_from_srgb(kGreen)), 0.01F);
    EXPECT_EQ(texture.mean, mean_light(texture.colour, true));
  }
}

TEST(LeafTexture, HasAMidribInItsOwnColour) {
  for (const LeafRecipe::Veins veins : {LeafRecipe::Veins::pinnate, LeafRecipe::Veins::parallel}) {
    const Texture texture = make_leaf_texture({.veins = veins, .vein_colour = Vec3(1)}, kLozenge, kGreen, kPixels);
    for (const int y : {40, 64, 90}) {
      const float midrib = std::max(light_at(texture, kPixels / 2 - 1, y), light_at(texture, kPixels / 2, y));
      double row = 0;
      for (int x = 40; x < 88; ++x) row += light_at(texture, x, y) / 48;
      EXPECT_GT(midrib, 1.2 * row) << y;
    }
  }
}

TEST(LeafTexture, OfALobedLeafHasVeinsToTheLobes) {
  // Three long lobes from a base low down in the middle.
  const TextureShape shape{{{0.5F, 0.1F}, {0.98F, 0.5F}, {0.6F, 0.45F}, {0.5F, 0.98F}, {0.4F, 0.45F}, {0.02F, 0.5F}},
                           true};
  const Texture texture = make_leaf_texture({.veins = LeafRecipe::Veins::palmate, .pairs = 1, .vein_colour = Vec3(1)},
                                            shape, kGreen, kPixels);
  const auto brightest_near = [&](Vec2 position) {
    float brightest = 0;
    for (int d = -1; d <= 1; ++d) {
      const auto x = static_cast<int>(position.x * kPixels);
      const auto y = kPixels - 1 - static_cast<int>(position.y * kPixels);
      brightest = std::max({brightest, light_at(texture, x, y + d), light_at(texture, x + d, y)});
    }
    return brightest;
  };
  const Vec2 base(0.5F, 0.1F);
  for (const Vec2 tip : {Vec2(0.98F, 0.5F), Vec2(0.5F, 0.98F), Vec2(0.02F, 0.5F)}) {
    const Vec2 on_vein = glm::mix(base, tip, 0.5F);
    const Vec2 beside = on_vein + 0.06F * Vec2(tip.y - base.y, base.x - tip.x);
    EXPECT_GT(brightest_near(on_vein), 1.3F * brightest_near(beside)) << tip.x;
  }
}

TEST(LeafTexture, AutumnComesFromTheMargin) {
  const TextureShape square;
  const Texture texture = make_leaf_texture({.contrast = 0, .edge_colour = Vec3(0.8F, 0.1F, 0.1F)}, square,
                                            Vec3(0.6F, 0.6F, 0.1F), kPixels);
  const auto redness = [&](int x, int y) { return texture.colour.pixel(x, y)[0] - texture.colour.pixel(x, y)[1]; };
  EXPECT_GT(redness(2, 64), redness(50, 64) + 30);
  EXPECT_GT(redness(64, 2), redness(64, 64) + 30);
}

TEST(PetalTexture, HasItsThroatAtTheBase) {
  const Texture texture = make_petal_texture({.throat = Vec3(0.9F, 0.8F, 0.1F)}, {}, Vec3(0.8F, 0.6F, 0.8F), kPixels);
  EXPECT_LT(texture.colour.pixel(64, kPixels - 2)[2], 120);
  EXPECT_GT(texture.colour.pixel(64, 20)[2], 180);
  EXPECT_LT(glm::distance(texture.mean, linear_from_srgb({0.8F, 0.6F, 0.8F})), 0.01F);
}

TEST(PetalTexture, IsMaskedByItsOutline) {
  const Texture texture = make_petal_texture({}, kLozenge, kGreen, kPixels);
  EXPECT_TRUE(texture.masked);
  EXPECT_EQ(texture.colour.pixel(0, 0)[3], 0);
}

TEST(LeafTexture, IsTheSameOnAnyNumberOfThreads) {
  for (const LeafRecipe::Veins veins : kVeins) {
    Texture first;
    for (const int threads : {1, 2, 3, 8}) {
      const ThreadLimit limit(threads);
      const Texture texture = make_leaf_texture({.veins = veins}, kLozenge, kGreen, 64);
      if (threads == 1) first = texture;
      EXPECT_EQ(texture.colour.rgba, first.colour.rgba) << threads;
      EXPECT_EQ(texture.normals.rgba, first.normals.rgba) << threads;
    }
  }
}

TEST(LeafTexture, VeinsEndForEveryAspectAndWhereFannedOnesLieOutside) {
  // The base of this shape lies above its corners, and below all veins that fan out to the sides.
  const TextureShape tent{{{0, 0}, {0.5F, 0.4F}, {1, 0}, {0.5F, 1}}, true};
  for (const LeafRecipe::Veins veins : kVeins) {
    for (const double aspect : {1e-6, 1.0, 1e3, 1e6}) {
      TextureShape shape = tent;
      shape.aspect = aspect;
      const Texture texture = make_leaf_texture({.veins = veins}, shape, kGreen, kPixels);
      EXPECT_LT(glm::distance(texture.mean, linear_from_srgb(kGreen)), 0.01F) << aspect;
    }
  }
}

}  // namespace meristem::leaf_texture_test
