// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/assembly/view_meshes.h"

#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/leaf/leaf_blade.h"
#include "meristem/shape/scene/scene_keys.h"
#include "meristem/shape/solid/primitives.h"
#include "meristem/shape/stem/cached_meshes.h"

namespace meristem::view_meshes_test {

constexpr double kBudget = 20'000;

/// Returns a trunk with crooked branches and leaves: about 100,000 triangles for each unit of `size`, spread over
/// proportionally more branches and leaves.
Plant tree(int size) {
  const RandomKey key(7);
  Plant plant;
  plant.materials.resize(2);
  Stem& stem = plant.stems.emplace_back();
  stem.parts[0].component = "trunk";
  Skeleton& skeleton = stem.skeleton;
  NodeIndex trunk = skeleton.add_node(kNoNode, Vec3(0), 0);
  skeleton.radius[trunk] = 0.2F;
  for (AxisIndex branch = 1; branch <= static_cast<AxisIndex>(200 * size); ++branch) {
    trunk = skeleton.add_node(trunk, Vec3(0, 0.01F * static_cast<float>(branch), 0), 0);
    skeleton.radius[trunk] = 0.2F;
    NodeIndex node = trunk;
    for (std::uint64_t k = 1; k <= 12; ++k) {
      const Vec3 step = 0.1F * key.direction(branch) + 0.05F * key.child("bend").direction(20 * branch + k);
      node = skeleton.add_node(node, skeleton.position[node] + step, 0);
      skeleton.axis[node] = branch;
      skeleton.order[node] = 1;
      skeleton.radius[node] = 0.02F / static_cast<float>(k);
    }
  }
  plant.prototypes = {{"leaf", 1, std::make_shared<const Mesh>(make_leaf_blade({.rows = 8, .across = 4}))}};
  for (int k = 0; k < 1000 * size; ++k) {
    const Vec3 along = key.child("leaf").direction(static_cast<std::uint64_t>(k));
    plant.organs.push_back({frame_along(along, kUp, along), 0});
  }
  return plant;
}

/// Returns variants of a plant, each in several places.
Plant forest(const Plant& of, int variants, int places) {
  Plant plant;
  plant.materials.resize(1);
  for (int v = 0; v < variants; ++v) {
    auto variant = std::make_shared<PlantVariant>();
    variant->plant = std::make_shared<const Plant>(of);
    variant->key = static_cast<std::uint64_t>(v) + 1;
    Planting& planting = plant.plantings.emplace_back();
    planting.component = "tree";
    planting.variant = std::move(variant);
    for (int k = 0; k < places; ++k) {
      planting.places.push_back({.frame = {Mat3(1), Vec3(2.0F * static_cast<float>(k), 0, static_cast<float>(v))}});
    }
  }
  return plant;
}

/// Adds a separate board beside the plants that stand in it.
void add_own_parts(Plant& plant, int count) {
  plant.prototypes = {{"board", 0, std::make_shared<const Mesh>(make_sphere(0.1, 10))}};
  for (int k = 0; k < count; ++k) plant.organs.push_back({Frame{.origin = Vec3(static_cast<float>(k), 0, 0)}, 0});
}

ViewMeshes view_of(const Plant& plant, double triangles, MeshWork* work = nullptr, Cache* cache = nullptr) {
  Progress progress;
  return make_view_meshes(plant, {}, {static_cast<std::uint64_t>(triangles), work}, progress, cache);
}

double shown(const ViewMeshes& view) { return static_cast<double>(view.scene.triangle_count()); }

double triangles_of(const MeshScene& scene, const std::string& component) {
  double count = 0;
  for (const MeshInstances& meshes : scene.meshes) {
    if (meshes.component == component) count += static_cast<double>(meshes.triangle_count());
  }
  return count;
}

SceneKeys keys_of(const MeshScene& scene) { return SceneKeyMaker().keys_of(scene); }

TEST(ViewMeshes, APlantThatFitsIsWhole) {
  Progress progress;
  const Plant plant = tree(1);
  const MeshScene whole = make_mesh_scene(plant, {}, progress);
  const ViewMeshes view = view_of(plant, static_cast<double>(whole.triangle_count()));
  EXPECT_TRUE(view.is_whole);
  EXPECT_EQ(view.triangles, whole.triangle_count());
  EXPECT_EQ(keys_of(view.scene).batches, keys_of(whole).batches);
}

TEST(ViewMeshes, ALargePlantHasAboutTheTrianglesOfTheView) {
  for (const int size : {1, 4}) {
    const ViewMeshes view = view_of(tree(size), kBudget);
    EXPECT_FALSE(view.is_whole);
    EXPECT_LE(shown(view), 1.2 * kBudget);
    EXPECT_GE(shown(view), 0.4 * kBudget);
    EXPECT_GT(view.triangles, 50'000U * static_cast<unsigned>(size));
  }
}

TEST(ViewMeshes, WorkGrowsWithTheViewAndNotWithThePlant) {
  MeshWork small;
  MeshWork large;
  view_of(tree(2), kBudget, &small);
  view_of(tree(20), kBudget, &large);
  const auto made = [](const MeshWork& work) { return static_cast<double>(work.triangles); };
  EXPECT_LE(made(small), 3 * kBudget);
  EXPECT_LE(made(large), 3 * kBudget);
  EXPECT_LE(made(large), 1.5 * made(small));
}

TEST(ViewMeshes, WorkOnAForestGrowsWithTheViewAndNotWithItsPlants) {
  MeshWork work;
  const ViewMeshes view = view_of(forest(tree(10), 5, 40), kBudget, &work);
  EXPECT_GT(view.triangles, 50'000'000U);
  EXPECT_LE(shown(view), 1.5 * kBudget) << "of 100 triangles, the trunk takes most";
  EXPECT_LE(static_cast<double>(work.triangles), 3 * kBudget);
}

TEST(ViewMeshes, APlantInManyPlacesIsMeshedOnce) {
  MeshWork work;
  const ViewMeshes view = view_of(forest(tree(1), 3, 500), kBudget, &work);
  EXPECT_LE(work.plants, 1U + 3U * 3U) << "the plant itself, and at most three tries for each variant";
  EXPECT_LE(shown(view), 1.2 * kBudget);
}

TEST(ViewMeshes, OfVeryManyPlantsAnEvenChoiceIsShown) {
  const ViewMeshes view = view_of(forest(tree(1), 2, 3000), kBudget);
  EXPECT_LE(shown(view), 1.2 * kBudget);
  float farthest = 0;
  std::size_t places = 0;
  for (const MeshInstances& meshes : view.scene.meshes) {
    if (meshes.component != "tree.trunk") continue;
    places += meshes.place_count();
    for (const Frame& frame : *meshes.places) farthest = std::max(farthest, frame.origin.x);
  }
  EXPECT_GT(places, 100U);
  EXPECT_LT(places, 6000U);
  EXPECT_GT(farthest, 5000) << "of 6000 m";
}

TEST(ViewMeshes, APlantThatStandsOnceKeepsMoreThanThoseOfAForest) {
  Plant plant = forest(tree(1), 1, 1000);
  plant.plantings.push_back(forest(tree(1), 1, 1).plantings[0]);
  plant.plantings[1].component = "single";
  const MeshScene scene = view_of(plant, 10 * kBudget).scene;
  const double single = triangles_of(scene, "single.trunk") + triangles_of(scene, "single.leaf");
  const double each = (triangles_of(scene, "tree.trunk") + triangles_of(scene, "tree.leaf")) / 1000;
  EXPECT_GT(single, 3 * each);
}

TEST(ViewMeshes, WhatIsNotPlacedKeepsAQuarter) {
  Plant plant = forest(tree(1), 1, 1000);
  add_own_parts(plant, 20);
  const MeshScene scene = view_of(plant, kBudget).scene;
  EXPECT_EQ(triangles_of(scene, "board"), 20.0 * static_cast<double>(plant.prototypes[0].mesh->triangle_count()));
}

TEST(ViewMeshes, OfVeryManyStemsAnEvenChoiceIsShown) {
  Plant plant;
  plant.materials.resize(1);
  for (int k = 0; k < 5000; ++k) {
    Stem& stem = plant.stems.emplace_back();
    stem.parts[0].component = "shoot";
    NodeIndex node = stem.skeleton.add_node(kNoNode, Vec3(static_cast<float>(k), 0, 0), 0);
    for (int i = 1; i < 6; ++i)
      node = stem.skeleton.add_node(
          node, Vec3(static_cast<float>(k), static_cast<float>(i), 0.1F * static_cast<float>(i % 2)), 0);
    stem.skeleton.radius.assign(6, k == 7 ? 0.2F : 0.1F);
  }
  const ViewMeshes view = view_of(plant, kBudget);
  EXPECT_LE(shown(view), 1.2 * kBudget);
  EXPECT_GE(shown(view), 0.4 * kBudget);
  EXPECT_LT(view.scene.bounds().low.x, 200);
  EXPECT_GT(view.scene.bounds().high.x, 4800);
}

TEST(ViewMeshes, PlantsWithinPlacedPlantsCount) {
  const Plant plant = forest(forest(tree(1), 2, 30), 2, 30);
  const ViewMeshes view = view_of(plant, kBudget);
  EXPECT_GT(view.triangles, 50'000'000U);
  EXPECT_LE(shown(view), 1.3 * kBudget);
  EXPECT_GE(shown(view), 0.3 * kBudget);
}

TEST(ViewMeshes, ACancelledCallLeavesThePlantsThatItHasMade) {
  const Plant plant = forest(tree(1), 8, 20);
  Cache cache;
  MeshWork begun;
  const ThreadLimit one_thread(1);
  {
    Progress* running = nullptr;
    Progress progress([&](std::string_view stage, double share) {
      if (stage == "meshing plants" && share > 0.4) running->cancel();
    });
    running = &progress;
    const ViewMeshOptions options{static_cast<std::uint64_t>(kBudget), &begun};
    EXPECT_THROW(make_view_meshes(plant, {}, options, progress, &cache), Cancelled);
  }
  MeshWork rest;
  MeshWork all;
  const ViewMeshes resumed = view_of(plant, kBudget, &rest, &cache);
  const ViewMeshes anew = view_of(plant, kBudget, &all);
  EXPECT_EQ(keys_of(resumed.scene).batches, keys_of(anew.scene).batches);
  EXPECT_GT(begun.plants, 0U);
  EXPECT_LT(rest.plants, all.plants);
}

TEST(ViewMeshes, TheLimitsAreThoseOfTheWholePlant) {
  const Plant plant = tree(4);
  SizeLimits limits;
  limits.triangles = 50'000;
  Progress progress;
  EXPECT_THROW(make_view_meshes(plant, limits, {static_cast<std::uint64_t>(kBudget)}, progress), InputError);
  EXPECT_THROW(make_view_meshes(forest(plant, 2, 2), limits, {static_cast<std::uint64_t>(kBudget)}, progress),
               InputError);
}

TEST(ViewMeshes, AreTheSameOnAnyNumberOfThreads) {
  const Plant plant = forest(tree(1), 3, 20);
  SceneKeys one;
  for (const int threads : {1, 3, 8}) {
    const ThreadLimit limit(threads);
    const SceneKeys keys = keys_of(view_of(plant, kBudget).scene);
    if (threads == 1) one = keys;
    EXPECT_EQ(keys.batches, one.batches) << threads;
  }
}

}  // namespace meristem::view_meshes_test
