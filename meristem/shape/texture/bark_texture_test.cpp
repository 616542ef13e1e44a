// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "meristem/base/colour.h"
#include "meristem/base/parallel.h"
#include "meristem/shape/texture/mean_light.h"
#include "meristem/shape/texture/texture_recipe.h"

namespace meristem::bark_texture_test {

constexpr int kPixels = 128;
constexpr Vec3 kBrown{0.45F, 0.38F, 0.32F};

constexpr BarkRecipe::Style kStyles[] = {BarkRecipe::Style::smooth, BarkRecipe::Style::furrowed,
                                         BarkRecipe::Style::plated, BarkRecipe::Style::peeling};

int difference(const std::uint8_t* a, const std::uint8_t* b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

/// Returns the mean difference between the columns (or rows) `from` and `to`.
double mean_step(const Image& image, int from, int to, bool rows) {
  double sum = 0;
  for (int k = 0; k < kPixels; ++k) {
    sum += rows ? difference(image.pixel(k, from), image.pixel(k, to))
                : difference(image.pixel(from, k), image.pixel(to, k));
  }
  return sum / kPixels;
}

/// Returns the largest mean difference between neighbours within the picture.
double largest_step(const Image& image, bool rows) {
  double largest = 0;
  for (int k = 1; k < kPixels; ++k) largest = std::max(largest, mean_step(image, k - 1, k, rows));
  return largest;
}

TEST(BarkTexture, HasNoSeamsBetweenTiles) {
  for (const BarkRecipe::Style style : kStyles) {
    const Texture texture = make_bark_texture({.style = style}, kBrown, kPixels);
    for (const Image* image : {&texture.colour, &texture.normals}) {
      for (const bool rows : {false, true}) {
        EXPECT_LE(mean_step(*image, kPixels - 1, 0, rows), largest_step(*image, rows)) << texture.name << " " << rows;
      }
    }
  }
}

TEST(BarkTexture, HasTheMeanItIsAskedFor) {
  for (const BarkRecipe::Style style : kStyles) {
    for (const Vec3 colour : {kBrown, Vec3(0.82F, 0.8F, 0.76F), Vec3(0.1F, 0.1F, 0.1F)}) {
      const Texture texture = make_bark_texture({.style = style}, colour, kPixels);
      EXPECT_LT(glm::distance(texture.mean, linear_from_srgb(colour)), 0.01F) << texture.name;
      EXPECT_EQ(texture.mean, mean_light(texture.colour, false));
    }
  }
}

TEST(BarkTexture, WithoutReliefHasNoNormals) {
  for (const BarkRecipe::Style style : kStyles) {
    EXPECT_FALSE(make_bark_texture({.style = style, .relief = 0}, kBrown, 32).has_normals());
    EXPECT_TRUE(make_bark_texture({.style = style}, kBrown, 32).has_normals());
  }
}

TEST(BarkTexture, VariesMoreWithMoreContrast) {
  for (const BarkRecipe::Style style : kStyles) {
    double last = -1;
    for (const double contrast : {0.0, 0.5, 1.0}) {
      const Texture texture = make_bark_texture({.style = style, .contrast = contrast}, kBrown, kPixels);
      double squares = 0;
      for (std::size_t k = 0; k < texture.colour.rgba.size(); k += 4) {
        const double off = texture.colour.rgba[k] - 255.0 * kBrown.r;
        squares += off * off;
      }
      EXPECT_GT(squares, last) << texture.name << " " << contrast;
      last = squares;
    }
  }
}

TEST(BarkTexture, DiffersWithItsSeedAndIsOtherwiseTheSame) {
  for (const BarkRecipe::Style style : kStyles) {
    const Texture one = make_bark_texture({.style = style}, kBrown, 64);
    EXPECT_EQ(one.colour.rgba, make_bark_texture({.style = style}, kBrown, 64).colour.rgba);
    EXPECT_NE(one.colour.rgba, make_bark_texture({.style = style, .seed = 2}, kBrown, 64).colour.rgba);
  }
}

TEST(BarkTexture, TakesEveryScaleAndSize) {
  for (const BarkRecipe::Style style : kStyles) {
    for (const double scale : {0.1, 10.0}) {
      for (const int pixels : {16, 33}) {
        const Texture texture = make_bark_texture({.style = style, .scale = scale}, kBrown, pixels);
        EXPECT_EQ(texture.colour.rgba.size(), static_cast<std::size_t>(4 * pixels * pixels));
        EXPECT_FALSE(texture.masked);
      }
    }
  }
}

TEST(BarkTexture, IsTheSameOnAnyNumberOfThreads) {
  for (const BarkRecipe::Style style : kStyles) {
    Texture first;
    for (const int threads : {1, 2, 3, 8}) {
      const ThreadLimit limit(threads);
      const Texture texture = make_bark_texture({.style = style}, kBrown, 64);
      if (threads == 1) first = texture;
      EXPECT_EQ(texture.colour.rgba, first.colour.rgba) << texture.name << " " << threads;
      EXPECT_EQ(texture.normals.rgba, first.normals.rgba) << texture.name << " " << threads;
    }
  }
}

}  // namespace meristem::bark_texture_test
