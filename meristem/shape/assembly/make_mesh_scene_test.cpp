// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/assembly/make_mesh_scene.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string_view>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/leaf/leaf_blade.h"
#include "meristem/shape/solid/primitives.h"
#include "meristem/shape/tube/tube_plan.h"

namespace meristem::make_mesh_scene_test {

Stem stem(const std::string& component, float height) {
  Stem result;
  result.parts[0].component = component;
  NodeIndex node = result.skeleton.add_node(kNoNode, Vec3(0), 0);
  for (int i = 1; i <= 4; ++i) node = result.skeleton.add_node(node, {0, 0.25F * height * static_cast<float>(i), 0}, 0);
  std::fill(result.skeleton.radius.begin(), result.skeleton.radius.end(), 0.1F);
  return result;
}

/// Returns a plant with two components of stems and two of organs, one of them common to both. The organs are mixed.
Plant plant_of_all_sorts() {
  Plant plant;
  plant.materials.resize(3);
  plant.stems = {stem("trunk", 2), stem("vine", 3), stem("trunk", 4)};
  plant.stems[1].parts[0].material = 1;
  plant.prototypes = {{"leaf", 2, std::make_shared<const Mesh>(make_leaf_blade({}))},
                      {"vine", 1, std::make_shared<const Mesh>(make_sphere(0.1, 6))},
                      {"leaf", 2, std::make_shared<const Mesh>(make_box({1, 1, 1}))},
                      {"unused", 0, std::make_shared<const Mesh>(make_box({1, 1, 1}))}};
  for (int i = 0; i < 10; ++i) {
    Organ organ;
    organ.frame.origin = {0, i, 0};
    organ.prototype = static_cast<std::uint32_t>(i % 3);
    plant.organs.push_back(organ);
  }
  return plant;
}

MeshScene scene_of(const Plant& plant, const SizeLimits& limits = {}) {
  Progress progress;
  return make_mesh_scene(plant, limits, progress);
}

std::string limit_path(const Plant& plant, const SizeLimits& limits) {
  try {
    scene_of(plant, limits);
  } catch (const InputError& error) {
    return error.diagnostics().front().path;
  }
  return "no error";
}

TEST(MeshScene, GroupsByComponentInOrderOfFirstAppearance) {
  const MeshScene scene = scene_of(plant_of_all_sorts());
  std::vector<std::string> names;
  for (const MeshInstances& instances : scene.meshes) names.push_back(instances.component);
  EXPECT_EQ(names, (std::vector<std::string>{"trunk", "trunk", "vine", "vine", "leaf", "leaf"}));
  EXPECT_EQ(scene.meshes[2].material, 1U);
  EXPECT_EQ(scene.meshes[5].material, 2U);
}

TEST(MeshScene, KeepsTheOrderOfOrgansWithinTheirPrototype) {
  const MeshScene scene = scene_of(plant_of_all_sorts());
  const std::vector<Frame>& frames = scene.meshes[4].frames;
  ASSERT_EQ(frames.size(), 4U);
  for (std::size_t i = 0; i < frames.size(); ++i) EXPECT_EQ(frames[i].origin.y, 3.0F * static_cast<float>(i));
}

TEST(MeshScene, CountsTrianglesAfterInstancing) {
  const Plant plant = plant_of_all_sorts();
  const MeshScene scene = scene_of(plant);
  EXPECT_EQ(scene.instance_count(), 3U + 10U);
  std::uint64_t expected = 0;
  for (const Stem& each : plant.stems) {
    expected += TubePlan(each.skeleton, {{each.parts[0].surface}}).sizes()[0].triangles;
  }
  for (const Organ& organ : plant.organs) expected += plant.prototypes[organ.prototype].mesh->triangle_count();
  EXPECT_EQ(scene.triangle_count(), expected);
}

TEST(MeshScene, BoundsAreThoseOfAllPlacedVertices) {
  Plant plant;
  plant.materials.resize(1);
  plant.prototypes = {{"leaf", 0, std::make_shared<const Mesh>(make_leaf_blade({.curl = 1}))}};
  const RandomKey key(11);
  for (std::uint64_t i = 0; i < 500; ++i) {
    Organ organ;
    organ.frame = frame_along(key.child("at").direction(i), key.child("heading").direction(i), kUp);
    organ.frame.axes[0] *= -3.0F;
    plant.organs.push_back(organ);
  }
  Box expected;
  for (const Organ& organ : plant.organs) {
    for (const Vec3 position : plant.prototypes[0].mesh->positions) expected.add(organ.frame.point(position));
  }
  const Box box = scene_of(plant).bounds();
  EXPECT_EQ(box.low, expected.low);
  EXPECT_EQ(box.high, expected.high);
  EXPECT_TRUE(MeshScene{}.bounds().is_empty());
}

TEST(MeshScene, LeavesOutWhatHasNoTriangles) {
  Plant plant;
  plant.materials.resize(1);
  plant.stems = {stem("trunk", 1)};
  plant.stems[0].skeleton = Skeleton{};
  plant.prototypes = {{"leaf", 0, std::make_shared<const Mesh>()}};
  plant.organs.resize(5);
  EXPECT_TRUE(scene_of(plant).meshes.empty());
}

TEST(MeshScene, LimitsNameTheComponentThatHasMost) {
  const Plant plant = plant_of_all_sorts();
  EXPECT_EQ(limit_path(plant, {.triangles = 100}), "components.trunk");
  Plant leafy = plant;
  for (int i = 0; i < 1000; ++i) leafy.organs.push_back(plant.organs[0]);
  EXPECT_EQ(limit_path(leafy, {.triangles = 20000}), "components.leaf");
  EXPECT_EQ(limit_path(leafy, {.mesh_bytes = 20000}), "components.leaf");
  EXPECT_EQ(limit_path(leafy, {}), "no error");
}

TEST(MeshScene, HasTheSameBytesOnAnyNumberOfThreads) {
  Plant plant = plant_of_all_sorts();
  for (int i = 0; i < 50; ++i) plant.stems.push_back(stem("trunk", 1 + 0.1F * static_cast<float>(i)));
  const MeshScene expected = scene_of(plant);
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    const MeshScene scene = scene_of(plant);
    ASSERT_EQ(scene.meshes.size(), expected.meshes.size());
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
      EXPECT_EQ(scene.meshes[i].mesh->positions, expected.meshes[i].mesh->positions);
      EXPECT_EQ(scene.meshes[i].mesh->triangles, expected.meshes[i].mesh->triangles);
    }
  }
}

TEST(MeshScene, CountsNodesAndOrgansAsProgressAndStopsWhenAsked) {
  const Plant plant = plant_of_all_sorts();
  double last = 0;
  Progress progress([&last](std::string_view, double fraction) { last = fraction; });
  make_mesh_scene(plant, {}, progress);
  EXPECT_EQ(last, 1);
  progress.cancel();
  EXPECT_THROW(make_mesh_scene(plant, {}, progress), Cancelled);
}

TEST(MeshScene, RejectsIndicesThatPointNowhere) {
  const auto rejects = [](const std::function<void(Plant&)>& change) {
    Plant plant = plant_of_all_sorts();
    change(plant);
    EXPECT_THROW(scene_of(plant), std::invalid_argument);
  };
  rejects([](Plant& plant) { plant.organs[3].prototype = 4; });
  rejects([](Plant& plant) { plant.stems[0].parts[0].material = 3; });
  rejects([](Plant& plant) { plant.prototypes[0].material = 3; });
  rejects([](Plant& plant) { plant.prototypes[0].mesh = nullptr; });
}

/// Returns a stand of different plants. `alive` shows whether they still exist.
Plant stand_of(std::size_t plants, std::vector<std::weak_ptr<const Plant>>& alive) {
  Plant stand = plant_of_all_sorts();
  for (std::size_t k = 0; k < plants; ++k) {
    auto variant = std::make_shared<PlantVariant>();
    variant->plant = std::make_shared<const Plant>(plant_of_all_sorts());
    alive.push_back(variant->plant);
    std::vector<Planting::Place> places(2);
    places[1].frame.origin.x = static_cast<float>(k);
    stand.plantings.push_back({"tree", std::move(variant), places});
  }
  return stand;
}

TEST(MeshScene, PlantsAreFreedAsTheirMeshesAreMade) {
  constexpr std::size_t kPlants = 10;
  std::vector<std::weak_ptr<const Plant>> alive;
  Plant stand = stand_of(kPlants - 1, alive);
  auto variant = std::make_shared<PlantVariant>();  // a stand of one more plant
  variant->plant = std::make_shared<const Plant>(stand_of(1, alive));
  stand.plantings.push_back({"inner", std::move(variant), std::vector<Planting::Place>(1)});
  const MeshScene wanted = scene_of(stand);

  const ThreadLimit one_thread(1);
  double done = 0;
  const auto count_alive = [&](std::string_view stage, double fraction) {
    if (stage != "meshing plants") return;
    done = std::max(done, fraction);
    const auto left = std::ranges::count_if(alive, [](const auto& plant) { return !plant.expired(); });
    EXPECT_LE(static_cast<double>(left), (1 - fraction) * kPlants + 1e-6);
  };
  Progress progress(count_alive);
  const MeshScene made = make_mesh_scene(std::move(stand), {}, progress);
  EXPECT_EQ(done, 1);
  for (const std::weak_ptr<const Plant>& plant : alive) EXPECT_TRUE(plant.expired());
  ASSERT_EQ(made.meshes.size(), wanted.meshes.size());
  for (std::size_t k = 0; k < made.meshes.size(); ++k) {
    EXPECT_EQ(made.meshes[k].component, wanted.meshes[k].component);
    EXPECT_EQ(made.meshes[k].mesh->positions, wanted.meshes[k].mesh->positions);
    ASSERT_EQ(made.meshes[k].count(), wanted.meshes[k].count());
    for (std::size_t i = 0; i < made.meshes[k].count(); ++i) {
      EXPECT_EQ(made.meshes[k].frame(i).origin, wanted.meshes[k].frame(i).origin);
    }
  }
}

}  // namespace meristem::make_mesh_scene_test
