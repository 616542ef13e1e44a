// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/foliage.h"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/leaf/leaf_blade.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem::foliage_test {

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

FoliageMeasures measured(const Plant& plant) {
  Progress progress;
  return measure_foliage(plant, {}, progress);
}

TEST(Foliage, CountsTwoSidedOrgansOnly) {
  Plant plant = leaves_and_fruits();
  for (std::uint32_t k = 0; k < 10; ++k) plant.organs.push_back({.prototype = k % 2});
  const FoliageMeasures foliage = measured(plant);
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
  // The mirrored organ has the same area.
  plant.organs[0].frame.axes[0] *= -1.0F;
  EXPECT_NEAR(measured(plant).area, 6, 1e-5);
}

/// Returns a picture that is opaque within a disc about its middle. `radius` is the square of the disc's radius, in
/// shares of the picture's side.
std::shared_ptr<const Texture> disc(int pixels, double radius) {
  Texture texture;
  texture.colour = {pixels, pixels, std::vector<std::uint8_t>(std::size_t{4} * pixels * pixels, 255)};
  for (int row = 0; row < pixels; ++row) {
    for (int column = 0; column < pixels; ++column) {
      const double x = (column + 0.5) / pixels - 0.5;
      const double y = (row + 0.5) / pixels - 0.5;
      texture.colour.pixel(column, row)[3] = x * x + y * y < radius * radius ? 255 : 0;
    }
  }
  texture.masked = true;
  return std::make_shared<const Texture>(std::move(texture));
}

Plant masked_leaf(std::shared_ptr<const Texture> texture) {
  Mesh mesh = square();
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Plant plant = leaves_and_fruits();
  plant.materials[0].texture = std::move(texture);
  plant.prototypes[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
  plant.organs.resize(1);
  return plant;
}

TEST(Foliage, HolesOfAPictureAreNoLeaf) {
  const Plant plant = masked_leaf(disc(256, 0.4));
  EXPECT_TRUE(has_holes(plant));
  EXPECT_NEAR(measured(plant).area, kPi * 0.16, 0.003);
  EXPECT_FALSE(has_holes(leaves_and_fruits()));
}

TEST(Foliage, PlacedPlantsMayHaveHoles) {
  const auto garden_of = [](Plant plant) {
    auto variant = std::make_shared<PlantVariant>();
    variant->plant = std::make_shared<const Plant>(std::move(plant));
    Plant garden;
    garden.plantings.push_back({"plant", std::move(variant), {{}, {}}});
    return garden;
  };
  EXPECT_TRUE(has_holes(garden_of(masked_leaf(disc(16, 0.4)))));
  EXPECT_TRUE(has_holes(garden_of(garden_of(masked_leaf(disc(16, 0.4))))));
  EXPECT_FALSE(has_holes(garden_of(leaves_and_fruits())));
}

TEST(Foliage, ASketchOfAPictureIsNotMeasured) {
  Texture sketch = *disc(16, 0.4);
  sketch.colour.rgba.clear();
  EXPECT_THROW(measured(masked_leaf(std::make_shared<const Texture>(std::move(sketch)))), std::invalid_argument);
}

TEST(Foliage, PetiolesAreApart) {
  LeafBlade blade{.length = 0.1, .width = 0.05, .rows = 8};
  Plant plant = leaves_and_fruits();
  plant.prototypes[0].mesh = std::make_shared<const Mesh>(make_leaf_blade(blade));
  plant.organs.resize(1);
  const FoliageMeasures plain = measured(plant);
  EXPECT_EQ(plain.petiole_area, 0);
  blade.petiole = 0.08;
  blade.petiole_radius = 0.001;
  plant.prototypes[0].mesh = std::make_shared<const Mesh>(make_leaf_blade(blade));
  const FoliageMeasures stalked = measured(plant);
  EXPECT_NEAR(stalked.area, plain.area, 1e-9);
  // Three sides of a prism in a circle of 1 mm, and a little that extends into the midrib.
  const double prism = 3 * std::sqrt(3.0) * 0.001 * 0.08;
  EXPECT_GT(stalked.petiole_area, prism);
  EXPECT_LT(stalked.petiole_area, 1.2 * prism);
}

LeafLayers layers_of(const Plant& plant, double height) {
  Progress progress;
  return measure_leaf_layers(plant, {}, height, progress);
}

TEST(Foliage, LayersCutLeavesAtTheirBorders) {
  Plant plant = leaves_and_fruits();
  plant.organs.resize(2);
  plant.organs[0].frame.origin = {0, 0.75F, 0};  // an upright square from 0.75 to 1.75 m
  plant.organs[1].prototype = 1;                 // a fruit
  const LeafLayers layers = layers_of(plant, 0.5);
  EXPECT_EQ(layers.first, 1);
  ASSERT_EQ(layers.area.size(), 3U);
  EXPECT_NEAR(layers.area[0], 0.25, 1e-12);
  EXPECT_NEAR(layers.area[1], 0.5, 1e-12);
  EXPECT_NEAR(layers.area[2], 0.25, 1e-12);
  EXPECT_DOUBLE_EQ(layers.low(0), 0.5);
  EXPECT_DOUBLE_EQ(layers.high(2), 2);
}

TEST(Foliage, LayersBelowTheGroundAndWithoutLeaves) {
  Plant plant = leaves_and_fruits();
  EXPECT_TRUE(layers_of(plant, 1).area.empty());
  plant.organs.resize(1);
  plant.organs[0].frame.origin.y = -2;
  EXPECT_EQ(layers_of(plant, 1).first, -2);
  EXPECT_EQ(layers_of(plant, 1).area, std::vector<double>{1});
  EXPECT_THROW(layers_of(plant, 1e-9), InputError);
}

TEST(Foliage, LayersSumUpToTheLeafAreaOnAnyNumberOfThreads) {
  Plant plant = masked_leaf(disc(64, 0.45));
  plant.organs.clear();
  for (int k = 0; k < 5000; ++k) {
    Organ organ;
    organ.frame.axes = rotation(glm::normalize(Vec3(1, k % 7, 3)), 0.1 * k);
    organ.frame.axes *= 0.3F;
    organ.frame.origin = {0, 0.001F * static_cast<float>(k), 0};
    plant.organs.push_back(organ);
  }
  const LeafLayers layers = layers_of(plant, 0.7);
  double sum = 0;
  for (const double area : layers.area) sum += area;
  EXPECT_NEAR(sum, measured(plant).area, 1e-9 * sum);
  for (const int threads : {1, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(layers_of(plant, 0.7).area, layers.area);
  }
}

TEST(Foliage, PlacedLeavesAreMeasuredAsTheirCopies) {
  const auto leaves = [](int count) {
    Plant plant = leaves_and_fruits();
    plant.organs.resize(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
      plant.organs[k].frame.axes = rotation(glm::normalize(Vec3(1, k % 7, 3)), 0.1 * k);
      plant.organs[k].frame.origin.y = 0.001F * static_cast<float>(k);
    }
    return plant;
  };
  auto variant = std::make_shared<PlantVariant>();
  variant->plant = std::make_shared<const Plant>(leaves(900));
  Plant plant = leaves(700);  // enough that runs of organs begin in one plant and end in the next plant
  plant.plantings.push_back({"tree", variant, std::vector<Planting::Place>(3)});
  const Plant copies = expanded(plant, {}, Progress());
  EXPECT_EQ(layers_of(plant, 0.1).area, layers_of(copies, 0.1).area);
  EXPECT_EQ(measured(plant).leaves, 3400U);
  EXPECT_EQ(measured(plant).area, measured(copies).area);
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
  EXPECT_THROW(measure_foliage(plant, {}, progress), Cancelled);
}

}  // namespace meristem::foliage_test
