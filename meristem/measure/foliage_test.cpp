// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/foliage.h"

#include <memory>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/shape/leaf/leaf_blade.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem {
namespace {

/// A square of one metre in the plane of x and y.
Mesh square() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Plant leaves_and_fruits() {
  Plant plant;
  plant.materials.resize(2);
  plant.materials[0].two_sided = true;
  plant.prototypes = {{"leaf", 0, std::make_shared<const Mesh>(square())},
                      {"fruit", 1, std::make_shared<const Mesh>(make_box({1, 1, 1}))}};
  return plant;
}

Foliage measured(const Plant& plant) {
  Progress progress;
  return measure_foliage(plant, progress);
}

TEST(Foliage, CountsTwoSidedOrgansOnly) {
  Plant plant = leaves_and_fruits();
  for (std::uint32_t k = 0; k < 10; ++k) plant.organs.push_back({.prototype = k % 2});
  const Foliage foliage = measured(plant);
  EXPECT_EQ(foliage.leaves, 5U);
  EXPECT_DOUBLE_EQ(foliage.area, 5);
}

TEST(Foliage, FramesTurnAndScaleAreas) {
  Plant plant = leaves_and_fruits();
  Organ organ;
  organ.frame.axes = rotation(glm::normalize(Vec3(1, 2, 3)), 1.1);
  organ.frame.axes[0] *= 2.0F;
  organ.frame.axes[1] *= 3.0F;
  organ.frame.axes[2] *= 100.0F;
  organ.frame.origin = {5, 6, 7};
  plant.organs = {organ};
  EXPECT_NEAR(measured(plant).area, 6, 1e-5);
  // Mirrored, it has the same area.
  plant.organs[0].frame.axes[0] *= -1.0F;
  EXPECT_NEAR(measured(plant).area, 6, 1e-5);
}

TEST(Foliage, TheSameSumOnAnyNumberOfThreads) {
  Plant plant = leaves_and_fruits();
  for (int k = 0; k < 30'000; ++k) {
    Organ organ;
    organ.frame.axes *= 0.01F * static_cast<float>(1 + k % 97);
    plant.organs.push_back(organ);
  }
  const double one = [&] {
    const ThreadLimit limit(1);
    return measured(plant).area;
  }();
  for (const int threads : {2, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(measured(plant).area, one);
  }
}

TEST(Foliage, CanBeStopped) {
  Plant plant = leaves_and_fruits();
  plant.organs.resize(1);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(measure_foliage(plant, progress), Cancelled);
}

}  // namespace
}  // namespace meristem
