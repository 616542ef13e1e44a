// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/cards.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/colour.h"
#include "meristem/base/parallel.h"
#include "meristem/shape/detail/detail.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem::cards_test {

/// Returns a ball of 1 m that stands on the ground.
MeshScene ball() {
  MeshScene scene;
  scene.materials.resize(1);
  scene.materials[0].colour = Vec3(0.2F, 0.6F, 0.3F);
  scene.meshes.push_back(
      {"ball", std::make_shared<const Mesh>(make_sphere(0.5, 64)), 0, {Frame{.origin = {0, 0.5F, 0}}}, {}});
  return scene;
}

MeshScene cards_of(const MeshScene& scene, int cards = 3) {
  Progress progress;
  return make_cards(scene, {.cards = cards, .size = 64}, progress);
}

TEST(Cards, AreTwoTrianglesEachAndAsLargeAsThePlant) {
  const MeshScene scene = cards_of(ball());
  ASSERT_EQ(scene.meshes.size(), 1U);
  EXPECT_EQ(scene.triangle_count(), 2U * (3 + 1));
  const Box box = scene.bounds();
  EXPECT_NEAR(box.low.y, 0, 1e-3);
  EXPECT_NEAR(box.high.y, 1, 1e-3);
  EXPECT_NEAR(box.high.x, 0.5, 1e-2);
  EXPECT_EQ(scene.meshes[0].mesh->tangents.size(), scene.meshes[0].mesh->vertex_count());
}

TEST(Cards, MaskKeepsTheAreaOfADisc) {
  const MeshScene scene = cards_of(ball(), 1);
  const Image& image = scene.materials[0].texture->colour;
  int seen = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) seen += image.pixel(x, y)[3] >= 128 ? 1 : 0;
  }
  // One upright card and one level card.
  EXPECT_NEAR(seen / (64.0 * 64), 2 * kPi / 4, 0.02);
}

TEST(Cards, HaveTheColourWithoutLightAndNormalsOfTheBall) {
  const MeshScene scene = cards_of(ball(), 1);
  const Texture& texture = *scene.materials[0].texture;
  const int middle = 4 + 32;
  const std::uint8_t* colour = texture.colour.pixel(middle, middle);
  EXPECT_NEAR(colour[0], 0.2 * 255, 2);
  EXPECT_NEAR(colour[1], 0.6 * 255, 2);
  const std::uint8_t* ahead = texture.normals.pixel(middle, middle);
  EXPECT_NEAR(ahead[2], 255, 2);
  // The ball's surface leans right on the right side, and up at the top.
  EXPECT_GT(texture.normals.pixel(middle + 24, middle)[0], 200);
  EXPECT_GT(texture.normals.pixel(middle, middle - 24)[1], 200);
}

TEST(Cards, ColoursGoOnBeyondTheMask) {
  const MeshScene scene = cards_of(ball(), 1);
  const Image& image = scene.materials[0].texture->colour;
  EXPECT_LT(image.pixel(5, 5)[3], 128);
  EXPECT_NEAR(image.pixel(5, 5)[1], 0.6 * 255, 3);
}

TEST(Cards, AreTheSameOnAnyNumberOfThreads) {
  const MeshScene expected = cards_of(ball());
  const ThreadLimit limit(3);
  EXPECT_EQ(cards_of(ball()).materials[0].texture->colour.rgba, expected.materials[0].texture->colour.rgba);
}

TEST(Cards, OfNothingAreNone) { EXPECT_TRUE(cards_of({}).meshes.empty()); }

TEST(Cards, RejectOptionsOutOfRange) {
  EXPECT_THROW(cards_of(ball(), 0), std::invalid_argument);
  EXPECT_THROW(cards_of(ball(), kMaxCards + 1), std::invalid_argument);
}

}  // namespace meristem::cards_test
