// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/plant_bounds.h"

#include <memory>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "meristem/plant/plant_variant.h"

namespace meristem::plant_bounds_test {

/// A stem of length 1 m and radius 0.1 m, and a leaf that reaches from its tip to x = 0.5.
Plant stem_with_leaf() {
  Plant plant;
  Stem& stem = plant.stems.emplace_back();
  stem.skeleton.add_node(kNoNode, Vec3(0), 0);
  stem.skeleton.add_node(0, Vec3(0, 1, 0), 0);
  stem.skeleton.radius = {0.1F, 0.1F};
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {Vec3(0), Vec3(0.5F, 0, 0), Vec3(0.5F, 0.25F, 0)};
  plant.prototypes.push_back({.component = "leaf", .mesh = mesh});
  plant.organs.push_back({.frame = {Mat3(1), Vec3(0, 1, 0)}});
  return plant;
}

TEST(PlantBounds, HoldRadiiAndTheMeshesOfOrgans) {
  const Box box = bounds(stem_with_leaf());
  EXPECT_LT(glm::distance(box.low, Vec3(-0.1F, -0.1F, -0.1F)), 1e-6F);
  EXPECT_LT(glm::distance(box.high, Vec3(0.5F, 1.25F, 0.1F)), 1e-6F);
  EXPECT_TRUE(bounds(Plant()).is_empty());
}

TEST(PlantBounds, HoldPlantsThatStandInSeveralPlaces) {
  const auto variant = std::make_shared<PlantVariant>(
      PlantVariant{.plant = std::make_shared<const Plant>(stem_with_leaf()), .key = 1, .paint = {}});
  Plant field;
  Planting& planting = field.plantings.emplace_back();
  planting.variant = variant;
  planting.places.push_back({.frame = {Mat3(1), Vec3(3, 0, 0)}});
  planting.places.push_back({.frame = {Mat3(2), Vec3(-5, 0, 0)}});
  const Box box = bounds(field);
  EXPECT_LT(glm::distance(box.low, Vec3(-5.2F, -0.2F, -0.2F)), 1e-5F);
  EXPECT_LT(glm::distance(box.high, Vec3(3.5F, 2.5F, 0.2F)), 1e-5F);
}

}  // namespace meristem::plant_bounds_test
