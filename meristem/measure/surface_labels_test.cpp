// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/surface_labels.h"

#include <memory>

#include <gtest/gtest.h>

#include "meristem/plant/plant_variant.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/solid/primitives.h"
#include "tests/support/sample_plants.h"

namespace meristem::surface_labels_test {

/// Returns the two stems with three leaves: on the fork's branch, on the vine, and on the fork's trunk.
Plant leafy_stems() {
  Plant plant = two_stems();
  plant.materials.emplace_back();
  plant.prototypes.push_back({"leaf", 0, std::make_shared<const Mesh>(make_box({0.1F, 0.1F, 0.01F}))});
  for (const Vec3 position : {Vec3(0.4F, 1.45F, 0), Vec3(3.01F, 0.2F, 0), Vec3(-0.1F, 0.4F, 0)}) {
    plant.organs.push_back({.frame = {.origin = position}, .prototype = 0});
  }
  return plant;
}

Vec3 middle_of(const MeshInstances& part, std::uint32_t instance, std::uint32_t triangle) {
  const auto [a, b, c] = part.mesh->triangles[triangle];
  const Mesh& mesh = *part.mesh;
  return part.frame(instance).point((mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0F);
}

TEST(SurfaceLabels, TrianglesOfTubesAreTheirAxes) {
  const Plant plant = leafy_stems();
  Progress progress;
  const MeshScene scene = make_mesh_scene(plant, {}, progress);
  const SurfaceLabels labels(plant, {}, scene, progress);
  EXPECT_EQ(labels.components(), (std::vector<std::string>{"tree", "vine", "leaf", "ground"}));
  EXPECT_EQ(labels.shoot_count(), 3U);
  for (std::uint32_t t = 0; t < scene.meshes[0].triangle_count(); ++t) {
    const Vec3 middle = middle_of(scene.meshes[0], 0, t);
    const SurfaceLabel label = labels.of(0, 0, t, middle);
    EXPECT_EQ(label.kind, SurfaceKind::wood);
    EXPECT_EQ(label.tree, 0U);
    if (middle.x > 0.2F) {
      EXPECT_EQ(label.shoot, 1U);
    }
    if (middle.x > 0.2F) {
      EXPECT_EQ(label.order, 1U);
    }
    if (middle.y < 0.8F || middle.y > 1.8F) {
      EXPECT_EQ(label.shoot, 0U);
    }
  }
  const SurfaceLabel vine = labels.of(1, 0, 0, Vec3(3, 0, 0));
  EXPECT_EQ(vine, (SurfaceLabel{SurfaceKind::wood, 1, 3, 1, 2, 0}));
  EXPECT_EQ(labels.shoot_label(1), "main.1");
  EXPECT_EQ(labels.shoot_label(2), "main");
}

TEST(SurfaceLabels, OrgansAreOfTheShootThatTheyStandOn) {
  const Plant plant = leafy_stems();
  Progress progress;
  const MeshScene scene = make_mesh_scene(plant, {}, progress);
  const SurfaceLabels labels(plant, {}, scene, progress);
  EXPECT_EQ(labels.of(2, 0, 0, Vec3(0)), (SurfaceLabel{SurfaceKind::organ, 2, 0, 0, 1, 1}));
  EXPECT_EQ(labels.of(2, 1, 0, Vec3(0)), (SurfaceLabel{SurfaceKind::organ, 2, 1, 1, 2, 0}));
  EXPECT_EQ(labels.of(2, 2, 0, Vec3(0)), (SurfaceLabel{SurfaceKind::organ, 2, 2, 0, 0, 0}));
}

TEST(SurfaceLabels, TrianglesOfBodiesAreThoseOfTheNearestAxis) {
  Plant plant = leafy_stems();
  for (Stem& stem : plant.stems) stem.parts[0].surface.style = SurfaceOptions::Style::blend;
  Progress progress;
  const MeshScene scene = make_mesh_scene(plant, {}, progress);
  const SurfaceLabels labels(plant, {}, scene, progress);
  for (std::uint32_t t = 0; t < scene.meshes[0].triangle_count(); ++t) {
    const Vec3 middle = middle_of(scene.meshes[0], 0, t);
    if (middle.x > 0.25F) {
      EXPECT_EQ(labels.of(0, 0, t, middle).shoot, 1U);
    }
    if (middle.y < 0.8F) {
      EXPECT_EQ(labels.of(0, 0, t, middle).shoot, 0U);
    }
  }
}

/// Plants within plants, in several places: the numbers equal those of the plant after all copies were made.
TEST(SurfaceLabels, PlacedPlantsAreNumberedAsTheirCopies) {
  const auto tree = std::make_shared<PlantVariant>();
  tree->plant = std::make_shared<const Plant>(leafy_stems());
  Plant group = leafy_stems();
  group.plantings.push_back(
      {.component = "inner", .variant = tree, .places = {{{.origin = {9, 0, 0}}, 0}, {{.origin = {18, 0, 0}}, 1}}});
  const auto variant = std::make_shared<PlantVariant>();
  variant->plant = std::make_shared<const Plant>(group);
  Plant plant = leafy_stems();
  plant.plantings.push_back(
      {.component = "group", .variant = variant, .places = {{{.origin = {0, 0, 9}}, 0}, {{.origin = {0, 0, 18}}, 1}}});

  Progress progress;
  const MeshScene scene = make_mesh_scene(plant, {}, progress);
  const SurfaceLabels labels(plant, {}, scene, progress);
  const Plant copies = expanded(plant, {}, progress);
  const MeshScene copied = make_mesh_scene(copies, {}, progress);
  const SurfaceLabels wanted(copies, {}, copied, progress);
  ASSERT_EQ(labels.shoot_count(), wanted.shoot_count());
  EXPECT_EQ(labels.shoot_count(), 3U * 7);

  // Each triangle of the copies, found by its position.
  struct Known {
    Vec3 middle;
    SurfaceLabel label;
    std::string component;
  };
  std::vector<Known> known;
  for (std::uint32_t p = 0; p < copied.meshes.size(); ++p) {
    for (std::uint32_t i = 0; i < copied.meshes[p].count(); ++i) {
      const Vec3 middle = middle_of(copied.meshes[p], i, 0);
      const SurfaceLabel label = wanted.of(p, i, 0, middle);
      known.push_back({middle, label, wanted.components()[label.component]});
    }
  }
  std::size_t found = 0;
  for (std::uint32_t p = 0; p < scene.meshes.size(); ++p) {
    for (std::uint32_t i = 0; i < scene.meshes[p].count(); ++i) {
      const Vec3 middle = middle_of(scene.meshes[p], i, 0);
      const SurfaceLabel label = labels.of(p, i, 0, middle);
      for (const Known& other : known) {
        if (glm::distance(other.middle, middle) > 1e-4F) continue;
        ++found;
        EXPECT_EQ(labels.components()[label.component], other.component);
        EXPECT_EQ(label.instance, other.label.instance) << other.component;
        EXPECT_EQ(label.tree, other.label.tree) << other.component;
        EXPECT_EQ(label.shoot, other.label.shoot) << other.component;
        EXPECT_EQ(labels.shoot_label(label.shoot), wanted.shoot_label(other.label.shoot));
        const ShootOrigin origin = labels.shoot_origin(label.shoot), of_copy = wanted.shoot_origin(other.label.shoot);
        EXPECT_EQ(origin.component, of_copy.component);
        EXPECT_EQ(origin.order, of_copy.order);
      }
    }
  }
  EXPECT_EQ(found, known.size());
}

}  // namespace meristem::surface_labels_test
