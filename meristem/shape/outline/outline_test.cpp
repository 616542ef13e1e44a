// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/outline/outline.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/shape/outline/outline_raster.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem::outline_test {

MeshScene ball(double radius, Vec3 centre = Vec3(0)) {
  MeshScene scene;
  scene.materials.resize(1);
  MeshInstances& instances = scene.meshes.emplace_back();
  instances.mesh = std::make_shared<const Mesh>(make_sphere(radius, 64));
  instances.frames = {Frame{.origin = centre}};
  return scene;
}

double overlap(const MeshScene& whole, const MeshScene& level) {
  Progress progress;
  return outline_overlap(whole, level, {.directions = 10}, progress).mean();
}

TEST(Outline, OfAPlantAndItselfIsShared) { EXPECT_EQ(overlap(ball(1), ball(1)), 1); }

TEST(Outline, OfBallsIsSharedByTheirDiscs) {
  EXPECT_NEAR(overlap(ball(1), ball(0.9)), 0.81, 0.005);
  EXPECT_NEAR(overlap(ball(0.9), ball(1)), 0.81, 0.005);
  EXPECT_EQ(overlap(ball(1), ball(1, Vec3(20, 20, 20))), 0) << "what lies beyond the picture covers nothing of it";
}

TEST(Outline, OfNothingIsSharedByAll) { EXPECT_EQ(overlap({}, ball(1)), 1); }

TEST(Outline, DirectionsAreUnitAndOnTheUpperHalf) {
  for (const Vec3 direction : outline_directions(50)) {
    EXPECT_NEAR(glm::length(direction), 1, 1e-6);
    EXPECT_GT(direction.y, 0);
  }
}

TEST(Outline, IsTheSameOnAnyNumberOfThreads) {
  Progress progress;
  const auto expected = outline_overlap(ball(1), ball(0.8), {}, progress).of_direction;
  const ThreadLimit limit(3);
  EXPECT_EQ(outline_overlap(ball(1), ball(0.8), {}, progress).of_direction, expected);
}

TEST(Outline, RejectsOptionsBelowOne) {
  Progress progress;
  EXPECT_THROW(outline_overlap({}, {}, {.directions = 0}, progress), std::invalid_argument);
}

TEST(OutlineRaster, CoversEachPixelOfTwoTrianglesOfASquareOnce) {
  std::vector<int> count(100);
  const auto visit = [&](int row, int first, int end) {
    for (int x = first; x < end; ++x) ++count[static_cast<std::size_t>(10 * row + x)];
  };
  cover_triangle({-5, -5}, {15, -5}, {15, 15}, 10, visit);
  cover_triangle({-5, -5}, {-5, 15}, {15, 15}, 10, visit);
  for (const int covered : count) EXPECT_EQ(covered, 1);
}

}  // namespace meristem::outline_test
