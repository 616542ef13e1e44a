// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/plant_variant.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/plant/deform_plant.h"
#include "meristem/plant/plant.h"
#include "tests/support/space_maps.h"

namespace meristem::plant_variant_test {

/// A stem of two nodes with one organ at its tip.
std::shared_ptr<const PlantVariant> twig() {
  auto plant = std::make_shared<Plant>();
  plant->materials = {{.name = "stem"}, {.name = "leaf"}};
  Stem& stem = plant->stems.emplace_back();
  stem.parts[0].component = "stem";
  stem.skeleton.add_node(kNoNode, Vec3(0), 0);
  stem.skeleton.add_node(0, Vec3(0, 1, 0), 1);
  stem.skeleton.radius = {0.1F, 0.05F};
  plant->prototypes.push_back({.component = "leaf", .material = 1, .mesh = std::make_shared<const Mesh>()});
  plant->organs.push_back({.frame = {.origin = {0, 1, 0}}, .birth = 1});
  auto variant = std::make_shared<PlantVariant>();
  variant->plant = std::move(plant);
  return variant;
}

Frame at(Vec3 origin, float scale = 1) { return {Mat3(scale), origin}; }

TEST(Planting, ExpansionCopiesStemsAndOrgansToEachPlace) {
  Plant plant;
  plant.plantings.push_back({"oak", twig(), {{at({2, 0, 0}), 0, 5}, {at({0, 0, 4}, 2), 1, 0}}});
  const Plant all = expanded(plant, {}, Progress());
  EXPECT_TRUE(all.plantings.empty());
  ASSERT_EQ(all.stems.size(), 2U);
  EXPECT_EQ(all.stems[0].skeleton.position[1], Vec3(2, 1, 0));
  EXPECT_EQ(all.stems[1].skeleton.position[1], Vec3(0, 2, 4));
  EXPECT_FLOAT_EQ(all.stems[0].skeleton.radius[0], 0.1F);
  EXPECT_FLOAT_EQ(all.stems[1].skeleton.radius[0], 0.2F) << "a stem grows thicker as it is scaled";
  EXPECT_FLOAT_EQ(all.stems[0].skeleton.birth[1], 6) << "a plant's steps begin when it is placed";
  EXPECT_EQ(all.stems[0].parts[0].component, "oak.stem");
  EXPECT_EQ(all.stems[0].parts[0].instance, 0U);
  EXPECT_EQ(all.stems[1].parts[0].instance, 1U) << "instances are numbered on";
  ASSERT_EQ(all.organs.size(), 2U);
  EXPECT_EQ(all.organs[1].frame.origin, Vec3(0, 2, 4));
  ASSERT_EQ(all.prototypes.size(), 1U) << "both places share the prototype";
  EXPECT_EQ(all.materials[all.prototypes[0].material].name, "oak.leaf");
}

TEST(Planting, PlantingsWithinPlantingsMultiply) {
  auto clump = std::make_shared<Plant>();
  clump->plantings.push_back({"twig", twig(), {{at({1, 0, 0}), 0, 0}, {at({-1, 0, 0}), 1, 0}}});
  auto variant = std::make_shared<PlantVariant>();
  variant->plant = clump;
  Plant plant;
  plant.plantings.push_back({"clump", variant, {{at({0, 0, 5}), 0, 0}, {at({0, 0, 9}), 1, 0}, {at({0, 0, 13}), 2, 0}}});
  const Plant all = expanded(plant, {}, Progress());
  ASSERT_EQ(all.stems.size(), 6U);
  EXPECT_EQ(all.stems[5].skeleton.position[0], Vec3(-1, 0, 13));
  EXPECT_EQ(all.stems[5].parts[0].component, "clump.twig.stem");
  EXPECT_EQ(all.stems[5].parts[0].instance, 5U);
  const PlantTotals totals = totals_of(plant);
  EXPECT_EQ(totals.stems, 6U);
  EXPECT_EQ(totals.nodes, 12U);
  EXPECT_EQ(totals.organs, 6U);
}

TEST(Planting, EachPlaceIsAnIndividualOfItsRow) {
  auto clump = std::make_shared<Plant>();
  clump->plantings.push_back({"twig", twig(), {{at({1, 0, 0}), 0, 0, 8}, {at({-1, 0, 0}), 1, 0}}});
  auto variant = std::make_shared<PlantVariant>();
  variant->plant = clump;
  Plant plant;
  plant.plantings.push_back({"clump", variant, {{at({0, 0, 5}), 0, 0, 2}, {at({0, 0, 9}), 1, 0}}});
  const Plant all = expanded(plant, {}, Progress());
  std::vector<std::uint32_t> rows;
  for (const Stem& stem : all.stems) rows.push_back(all.individuals[stem.individual()].row);
  EXPECT_EQ(rows, (std::vector<std::uint32_t>{2, 2, 8, kNoRow})) << "the outermost table counts";
}

TEST(Planting, APlantWithoutPlantingsIsItsOwnExpansion) {
  const std::shared_ptr<const PlantVariant> variant = twig();
  const Plant& plant = *variant->plant;
  const ExpandedPlant same(plant, {}, Progress());
  EXPECT_EQ(&*same, &plant);
}

TEST(Planting, ExpansionStopsAtTheLimitsBeforeItCopies) {
  Plant plant;
  plant.plantings.push_back({"oak", twig(), std::vector<Planting::Place>(1000)});
  SizeLimits limits;
  limits.nodes = 1999;
  try {
    expanded(plant, limits, Progress());
    FAIL() << "2000 nodes passed a limit of 1999";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().front().path, "components.oak");
  }
  limits.nodes = 2000;
  EXPECT_EQ(expanded(plant, limits, Progress()).stems.size(), 1000U);
}

/// A plant with its own stem, a clump of twigs at two places, and a twig.
Plant nested_plant() {
  auto clump = std::make_shared<Plant>(*twig()->plant);
  clump->plantings.push_back({"twig", twig(), {{at({1, 0, 0}), 0, 0, 8}, {at({-1, 0, 0}), 1, 0}}});
  auto variant = std::make_shared<PlantVariant>();
  variant->plant = clump;
  Plant plant = *twig()->plant;
  plant.plantings.push_back({"clump", variant, {{at({0, 0, 5}), 0, 0, 2}, {at({0, 0, 9}), 1, 0}}});
  plant.plantings.push_back({"oak", twig(), {{at({3, 0, 0}, 2), 0, 0}}});
  return plant;
}

TEST(Planting, BlocksAreTheExpansionInItsOrder) {
  const Plant plant = nested_plant();
  const Plant all = expanded(plant, {}, Progress());
  for (const std::size_t block_size : {std::size_t{1}, std::size_t{7}, kExpandedBlock}) {
    std::vector<std::size_t> sizes;
    std::size_t stems = 0, organs = 0;
    const auto compare = [&](const Plant& block) {
      sizes.push_back(block.stems.size());
      EXPECT_EQ(&block == &plant, sizes.size() == 1) << "the plant itself is not copied";
      for (const Stem& stem : block.stems) {
        const Stem& wanted = all.stems.at(stems++);
        EXPECT_EQ(stem.skeleton.position, wanted.skeleton.position);
        EXPECT_EQ(stem.skeleton.radius, wanted.skeleton.radius);
        EXPECT_EQ(stem.parts[0].component, wanted.parts[0].component);
        EXPECT_EQ(stem.parts[0].instance, wanted.parts[0].instance);
        EXPECT_EQ(stem.individual(), wanted.individual());
      }
      for (const Organ& organ : block.organs) {
        const Organ& wanted = all.organs.at(organs++);
        EXPECT_EQ(organ.frame.origin, wanted.frame.origin);
        EXPECT_EQ(organ.prototype, wanted.prototype);
        EXPECT_EQ(organ.individual, wanted.individual);
        EXPECT_EQ(block.prototypes.at(organ.prototype).component, all.prototypes[organ.prototype].component);
        EXPECT_LT(block.prototypes[organ.prototype].material, block.materials.size());
      }
    };
    const std::vector<Individual> individuals = expand_in_blocks(plant, {}, Progress(), compare, block_size);
    EXPECT_EQ(stems, all.stems.size());
    EXPECT_EQ(organs, all.organs.size());
    ASSERT_EQ(individuals.size(), all.individuals.size());
    for (std::size_t k = 0; k < individuals.size(); ++k) EXPECT_EQ(individuals[k].row, all.individuals[k].row);
    const std::vector<std::size_t> in_small_blocks{1, 2, 1, 2, 1, 1};
    const std::vector<std::size_t> in_large_blocks{1, 7};
    if (block_size == 1) {
      EXPECT_EQ(sizes, in_small_blocks);
    }
    if (block_size == kExpandedBlock) {
      EXPECT_EQ(sizes, in_large_blocks);
    }
  }
}

TEST(Planting, BlocksStopAtTheLimitsBeforeTheFirst) {
  SizeLimits limits;
  limits.instances = 7;
  const auto fail = [](const Plant&) { FAIL() << "8 organs passed a limit of 7"; };
  EXPECT_THROW(expand_in_blocks(nested_plant(), limits, Progress(), fail), InputError);
}

/// Moves each point to the side by half its height.
std::shared_ptr<const Deformation> lean(DeformedPart part) {
  auto map = std::make_shared<const FunctionMap>(functions("x + y/2", "", ""));
  return std::make_shared<const Deformation>(
      std::vector<Deformation::Level>{{std::move(map), {}, part, "components.wind"}});
}

TEST(Planting, DeformedOnesAreCopiedOutAndDeformedAtEachPlace) {
  Plant plant;
  plant.plantings.push_back(
      {"oak", twig(), {{at({2, 0, 0}), 0, 5}, {at({0, 2, 4}, 2), 1, 0}}, lean(DeformedPart::geometry)});
  plant.plantings.push_back({"elm", twig(), {{at({0, 0, 9}), 0, 0}}});
  EXPECT_TRUE(has_deformed_plantings(plant));
  const Plant part = with_deformed_copies(plant, {}, Progress());
  ASSERT_EQ(part.plantings.size(), 1U);
  EXPECT_EQ(part.plantings[0].component, "elm");
  const Plant all = expanded(plant, {}, Progress());
  EXPECT_EQ(all.stems.size(), 3U);
  for (const Plant* found : {&part, &all}) {
    ASSERT_GE(found->stems.size(), 2U);
    EXPECT_EQ(found->stems[0].skeleton.position[1], Vec3(2.5F, 1, 0));
    EXPECT_EQ(found->stems[1].skeleton.position[0], Vec3(1, 2, 4));
    EXPECT_EQ(found->stems[1].skeleton.position[1], Vec3(2, 4, 4));
    EXPECT_EQ(found->organs[0].frame.origin, Vec3(2.5F, 1, 0));
    ASSERT_NE(found->stems[1].undeformed, nullptr);
    EXPECT_EQ(found->stems[1].undeformed->position[1], Vec3(0, 4, 4));
    EXPECT_EQ(found->individuals.at(1).foot, Vec3(1, 2, 4));
  }
}

TEST(Planting, ADeformedPlaceIsOneBlock) {
  Plant plant = nested_plant();
  plant.plantings[0].deformation = lean(DeformedPart::geometry);
  const Plant all = expanded(plant, {}, Progress());
  std::vector<std::size_t> sizes;
  std::size_t stems = 0;
  const auto compare = [&](const Plant& block) {
    sizes.push_back(block.stems.size());
    for (const Stem& stem : block.stems) {
      EXPECT_EQ(stem.skeleton.position, all.stems.at(stems++).skeleton.position);
    }
  };
  expand_in_blocks(plant, {}, Progress(), compare, 1);
  EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 3, 3, 1}));
}

TEST(Planting, WhatIsDeformedWithinAPlacedPlantIsDeformedInItsWorld) {
  auto inner = std::make_shared<Plant>();
  inner->plantings.push_back({"twig", twig(), {{at({0, 0, 0}), 0, 0}}, lean(DeformedPart::axes)});
  auto variant = std::make_shared<PlantVariant>();
  variant->plant = inner;
  Plant plant;
  const Frame turned{rotation(kUp, kPi / 2) * 2.0F, {5, 0, 0}};
  plant.plantings.push_back({"clump", variant, {{turned, 0, 0}}});
  const Plant all = expanded(plant, {}, Progress());
  EXPECT_LT(glm::distance(all.stems.at(0).skeleton.position[1], Vec3(5, 2, -1)), 1e-6F);
  EXPECT_LT(glm::distance(all.organs.at(0).frame.origin, Vec3(5, 2, -1)), 1e-6F);
}

}  // namespace meristem::plant_variant_test
