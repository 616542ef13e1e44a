// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/texture_sampler.h"

#include <gtest/gtest.h>

#include "meristem/base/colour.h"
#include "meristem/base/random.h"

namespace meristem::texture_sampler_test {

/// Returns a picture in which all pixels differ, also in alpha.
Image motley(int width, int height) {
  Image image{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height)};
  const RandomKey key(5);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    image.rgba[i] = static_cast<std::uint8_t>(key.uniform(i) * 256);
  }
  return image;
}

Vec3 light_of(const std::uint8_t* rgba) { return linear_from_srgb(Vec3(rgba[0], rgba[1], rgba[2]) / 255.0F); }

/// Returns the uv of the middle of a pixel.
Vec2 middle(const Image& image, int x, int y) {
  return {(static_cast<float>(x) + 0.5F) / static_cast<float>(image.width),
          1 - (static_cast<float>(y) + 0.5F) / static_cast<float>(image.height)};
}

void expect_near(Vec3 actual, Vec3 expected, float tolerance) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance);
}

TEST(TextureSampler, ThePixelsOfTheFullSizeAreTheTextures) {
  Texture texture;
  texture.colour = motley(7, 4);
  const TextureSampler sampler(texture);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 7; ++x) {
      const Vec3 expected = light_of(texture.colour.pixel(x, y));
      expect_near(sampler.colour(middle(texture.colour, x, y), 0), expected, 2e-5F);
      expect_near(sampler.colour(middle(texture.colour, x, y) + Vec2(-3, 2), 0), expected, 1e-4F);
    }
  }
}

TEST(TextureSampler, BetweenPixelsColoursMixInLight) {
  Texture texture;
  texture.colour = {2, 1, {0, 0, 0, 255, 255, 255, 255, 255}};
  const TextureSampler sampler(texture);
  EXPECT_NEAR(sampler.colour({0.375F, 0.5F}, 0).g, 0.25, 1e-4);
  EXPECT_NEAR(sampler.colour({0.5F, 0.5F}, 0).g, 0.5, 1e-4);
  EXPECT_NEAR(sampler.colour({0.0F, 0.5F}, 0).g, 0.5, 1e-4);  // the picture repeats
}

Vec3 mean_light(const Image& image) {
  DVec3 sum(0);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += DVec3(light_of(image.rgba.data() + i));
  return Vec3(sum / static_cast<double>(image.width * image.height));
}

TEST(PixelPyramid, EveryLevelHasTheMeanOfThePicture) {
  const Image image = motley(16, 16);
  const PixelPyramid pyramid(image, PixelMeaning::colour);
  for (int size = 16; size >= 1; size /= 2) {
    DVec3 sum(0);
    for (int i = 0; i < size * size; ++i) {
      const Vec2 middle = (Vec2(i % size, i / size) + 0.5F) / static_cast<float>(size);
      sum += DVec3(Vec3(pyramid.mean(middle, 1 / static_cast<float>(size))));
    }
    expect_near(Vec3(sum / static_cast<double>(size * size)), mean_light(image), 1e-4F);
  }
}

TEST(PixelPyramid, TheWidestMeanIsThatOfThePictureWhateverItsSize) {
  for (const auto& [width, height] : {std::pair(13, 5), std::pair(1, 9), std::pair(7, 7)}) {
    const Image image = motley(width, height);
    const PixelPyramid pyramid(image, PixelMeaning::colour);
    expect_near(Vec3(pyramid.mean({0.3F, 0.8F}, 100)), mean_light(image), 1e-4F);
  }
}

TEST(TextureSampler, MaskedPixelsDoNotStainMeans) {
  Texture texture;
  texture.masked = true;
  texture.colour = {2, 2, {0, 255, 0, 255, 255, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0, 255}};
  const TextureSampler sampler(texture);
  expect_near(sampler.colour({0.4F, 0.4F}, 2), Vec3(0, 1, 0), 1e-4F);
}

TEST(TextureSampler, NormalsAreUnitAndPointWhereTheMapSays) {
  Texture texture;
  texture.colour = {1, 1, {255, 255, 255, 255}};
  texture.normals = {2, 1, {255, 128, 128, 255, 128, 128, 255, 255}};
  const TextureSampler sampler(texture);
  ASSERT_TRUE(sampler.has_normals());
  expect_near(sampler.normal({0.25F, 0.5F}, 0), Vec3(1, 0, 0), 0.01F);
  expect_near(sampler.normal({0.75F, 0.5F}, 0), Vec3(0, 0, 1), 0.01F);
  EXPECT_NEAR(glm::length(sampler.normal({0.5F, 0.5F}, 0)), 1, 1e-5);
}

}  // namespace meristem::texture_sampler_test
