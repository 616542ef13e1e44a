// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/gltf/palette.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::palette_test {

std::vector<Vec3> random_colours(std::size_t count) {
  const RandomKey key(3);
  std::vector<Vec3> colours;
  for (std::size_t i = 0; i < count; ++i) {
    colours.emplace_back(key.child(0).uniform(i, 0.2, 1.4), key.child(1).uniform(i, 0.5, 1.2),
                         key.child(2).uniform(i, 0.8, 1.0));
  }
  return colours;
}

double error_of(std::span<const Vec3> colours, const Palette& palette) {
  double error = 0;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const Vec3 difference = colours[i] - palette.colours[palette.of[i]];
    error += glm::dot(difference, difference);
  }
  return error;
}

TEST(Palette, HoldsFewColoursExactly) {
  std::vector<Vec3> colours;
  const std::vector<Vec3> kinds{{0.1F, 0.7F, 0.2F}, {0.9F, 0.3F, 0.1F}, {0.9F, 0.3F, 0.7F}};
  for (std::size_t i = 0; i < 1000; ++i) colours.push_back(kinds[i < 990 ? 0 : i % 3]);
  const Palette palette = make_palette(colours, 8);
  EXPECT_EQ(palette.colours.size(), 3U);
  for (std::size_t i = 0; i < colours.size(); ++i) EXPECT_EQ(palette.colours[palette.of[i]], colours[i]);
}

TEST(Palette, EachColourIsTheMeanOfThoseItStandsFor) {
  const std::vector<Vec3> colours = random_colours(5000);
  const Palette palette = make_palette(colours, 8);
  ASSERT_EQ(palette.colours.size(), 8U);
  std::vector<DVec3> sums(8, DVec3(0));
  std::vector<double> counts(8, 0);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    sums[palette.of[i]] += DVec3(colours[i]);
    counts[palette.of[i]] += 1;
  }
  for (std::size_t k = 0; k < 8; ++k) {
    ASSERT_GT(counts[k], 0);
    EXPECT_LT(glm::length(sums[k] / counts[k] - DVec3(palette.colours[k])), 1e-6) << k;
  }
}

TEST(Palette, MoreColoursLeaveLessError) {
  const std::vector<Vec3> colours = random_colours(2000);
  double before = error_of(colours, make_palette(colours, 1));
  for (const std::size_t max : {2, 4, 8, 16}) {
    const double error = error_of(colours, make_palette(colours, max));
    EXPECT_LT(error, 0.9 * before) << max;
    before = error;
  }
}

TEST(Palette, NoColoursHaveNone) {
  const Palette palette = make_palette({}, 8);
  EXPECT_TRUE(palette.colours.empty());
  EXPECT_TRUE(palette.of.empty());
}

TEST(Palette, RefusesSizesThatAByteDoesNotCount) {
  EXPECT_THROW(make_palette({}, 0), std::invalid_argument);
  EXPECT_THROW(make_palette({}, 257), std::invalid_argument);
}

}  // namespace meristem::palette_test
