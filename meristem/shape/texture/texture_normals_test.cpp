// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/texture/texture_normals.h"

#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/vec.h"

namespace meristem::texture_normals_test {

constexpr int kPixels = 16;

/// Returns heights of a plane that rises by the given amounts over the whole width (to the right) and height (upward).
std::vector<float> plane(float along_u, float along_v) {
  std::vector<float> heights;
  for (int y = 0; y < kPixels; ++y) {
    for (int x = 0; x < kPixels; ++x) {
      heights.push_back((along_u * static_cast<float>(x) - along_v * static_cast<float>(y)) / kPixels);
    }
  }
  return heights;
}

Vec3 normal_at(const Image& image, int x, int y) {
  const std::uint8_t* pixel = image.pixel(x, y);
  EXPECT_EQ(pixel[3], 255);
  return Vec3(pixel[0], pixel[1], pixel[2]) / 127.5F - 1.0F;
}

TEST(TextureNormals, OfAPlaneLeanAgainstItsRise) {
  for (const Vec2 rise : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(-0.5F, 2)}) {
    const Image image = normals_of_heights(plane(rise.x, rise.y), kPixels, {});
    const Vec3 expected = glm::normalize(Vec3(-rise.x, -rise.y, 1));
    EXPECT_LT(glm::distance(normal_at(image, 7, 8), expected), 0.01F) << rise.x << " " << rise.y;
  }
}

TEST(TextureNormals, ReliefIsAFactorOnHeights) {
  EXPECT_EQ(normals_of_heights(plane(1, 0.5F), kPixels, {.relief = 2}).rgba,
            normals_of_heights(plane(2, 1), kPixels, {}).rgba);
}

TEST(TextureNormals, OnAWiderSurfaceLeanLessAcross) {
  EXPECT_EQ(normals_of_heights(plane(1, 1), kPixels, {.aspect = 2}).rgba,
            normals_of_heights(plane(0.5F, 1), kPixels, {}).rgba);
}

TEST(TextureNormals, OfATileSeeTheOppositeEdge) {
  // As a tile, a plane that rises to the right has a cliff at its edge.
  const Image tile = normals_of_heights(plane(1, 0), kPixels, {.wraps = true});
  EXPECT_GT(normal_at(tile, 0, 8).x, 0.9F);
  EXPECT_GT(normal_at(tile, kPixels - 1, 8).x, 0.9F);
  const Image sheet = normals_of_heights(plane(1, 0), kPixels, {});
  EXPECT_LT(normal_at(sheet, 0, 8).x, -0.3F);
}

}  // namespace meristem::texture_normals_test
