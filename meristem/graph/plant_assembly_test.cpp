// SPDX-License-Identifier: Apache-2.0
// The order of organs, prototypes and materials in a plant, and the indices between these lists.
#include "meristem/graph/plant_assembly.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/build_graph.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/test_components.h"

namespace meristem::plant_assembly_test {

using testing::ElementsAre;

/// Two kinds of sticks in the order "early", "late". The sticks "late" hang on the camera, so they are expanded first.
GraphBuilder two_kinds() {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("star", "star", {{"number", 3}});
  builder.component("early", "stick").component("late", "stick", {{"length", 2}});
  return builder.link("view", "late").link("view", "star").link("star", "early");
}

std::vector<std::string> components_of(const Plant& plant) {
  std::vector<std::string> components;
  for (const Organ& organ : plant.organs) components.push_back(plant.prototypes[organ.prototype].component);
  return components;
}

TEST(PlantAssembly, OrgansStandInTheOrderOfTheComponentsOfTheDocument) {
  const Plant plant = two_kinds().grow();
  EXPECT_THAT(components_of(plant), ElementsAre("early", "early", "early", "late"));
  ASSERT_EQ(plant.prototypes.size(), 2U);
  EXPECT_EQ(plant.prototypes[0].component, "early");
  EXPECT_EQ(plant.prototypes[1].component, "late");
}

TEST(PlantAssembly, EachPrototypeHasTheMaterialOfItsComponent) {
  const Plant plant = two_kinds().grow();
  for (const OrganPrototype& prototype : plant.prototypes) {
    ASSERT_LT(prototype.material, plant.materials.size());
    EXPECT_EQ(plant.materials[prototype.material].name, prototype.component);
    EXPECT_NE(prototype.mesh, nullptr);
  }
}

TEST(PlantAssembly, ComponentsWithoutInstancesHaveNoMaterial) {
  auto builder = two_kinds();
  const std::size_t materials = builder.grow().materials.size();
  builder.component("star", "star", {{"number", 0}});
  const Plant plant = builder.grow();
  EXPECT_EQ(plant.materials.size(), materials - 1);
  EXPECT_THAT(components_of(plant), ElementsAre("late"));
}

TEST(PlantAssembly, OrgansAndStemsBelongToPlantsOfThePlant) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("pole", "pole").component("stick", "stick").component("other", "pole");
  builder.link("view", "pole").link("pole", "stick", LinkKind::branch, {{"count", 5}}).link("view", "other");
  const Plant plant = builder.grow();
  ASSERT_EQ(plant.stems.size(), 2U);
  ASSERT_EQ(plant.organs.size(), 5U);
  for (const Organ& organ : plant.organs) {
    EXPECT_TRUE(organ.individual == kNoIndividual || organ.individual < plant.individuals.size());
    EXPECT_EQ(organ.individual, plant.organs[0].individual) << "all stand on one pole";
  }
  for (const Stem& stem : plant.stems) EXPECT_TRUE(check_skeleton(stem.skeleton));
}

TEST(PlantAssembly, AnEmptyGraphGivesAnEmptyPlant) {
  GraphBuilder builder(test_components());
  const Plant plant = builder.component("view", "camera").grow();
  EXPECT_TRUE(plant.organs.empty());
  EXPECT_TRUE(plant.stems.empty());
  EXPECT_TRUE(plant.plantings.empty());
}

}  // namespace meristem::plant_assembly_test
