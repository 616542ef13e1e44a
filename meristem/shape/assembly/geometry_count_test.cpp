// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/assembly/geometry_count.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/plant/deform_plant.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/solid/primitives.h"
#include "tests/support/sample_plants.h"
#include "tests/support/space_maps.h"

namespace meristem::geometry_count_test {

/// Returns a fork and a rod with leaves. The materials of the leaves and of the fork have a normal map.
Plant leafy_stems() {
  Plant plant = two_stems();
  plant.materials.resize(2);
  auto texture = std::make_shared<Texture>();
  texture->normals = {1, 1, {128, 128, 255, 255}};
  plant.materials[1].texture = texture;
  plant.stems[0].parts[0].material = 1;
  Mesh leaf = make_box({0.1F, 0.1F, 0.01F});
  leaf.normals.assign(leaf.vertex_count(), kUp);
  leaf.uvs.assign(leaf.vertex_count(), Vec2(0));
  plant.prototypes.push_back({"leaf", 1, std::make_shared<const Mesh>(leaf)});
  plant.prototypes.push_back({"unused", 0, std::make_shared<const Mesh>(leaf)});
  plant.organs.resize(3);
  return plant;
}

std::shared_ptr<const PlantVariant> variant_of(Plant plant) {
  auto variant = std::make_shared<PlantVariant>();
  variant->plant = std::make_shared<const Plant>(std::move(plant));
  return variant;
}

std::vector<Planting::Place> places(int count) {
  std::vector<Planting::Place> made(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) made[static_cast<std::size_t>(k)].frame.origin = {k, 0, 0};
  return made;
}

void expect_count_of_meshes(const Plant& plant) {
  Progress progress;
  const MeshScene scene = make_mesh_scene(plant, {}, progress);
  const GeometryCount wanted = count_geometry(scene);
  const GeometryCount counted = count_geometry(plant, {}, progress);
  EXPECT_EQ(counted.triangles, wanted.triangles);
  EXPECT_EQ(counted.triangles, scene.triangle_count());
  EXPECT_EQ(counted.instances, wanted.instances);
  EXPECT_EQ(counted.bytes, wanted.bytes);
}

TEST(GeometryCount, IsThatOfTheMeshesOfAPlant) { expect_count_of_meshes(leafy_stems()); }

TEST(GeometryCount, IsThatOfTheMeshesOfBodies) {
  Plant plant = leafy_stems();
  plant.stems[0].parts[0].surface.style = SurfaceOptions::Style::blend;
  plant.stems[1].parts[0].surface.crown = CrownBody{.resolution = 10};
  expect_count_of_meshes(plant);
}

TEST(GeometryCount, IsThatOfTheMeshesOfPlantsWithinPlants) {
  const auto tree = variant_of(leafy_stems());
  Plant group = leafy_stems();
  group.plantings.push_back({"inner", tree, places(3)});
  group.plantings.push_back({"nowhere", tree, {}});
  Plant plant = leafy_stems();
  plant.plantings.push_back({"group", variant_of(group), places(2)});
  plant.plantings.push_back({"tree", tree, places(5)});
  expect_count_of_meshes(plant);
}

TEST(GeometryCount, IsThatOfTheMeshesOfDeformedPlants) {
  auto map = std::make_shared<const FunctionMap>(functions("x + y/2", "", ""));
  const auto lean = std::make_shared<const Deformation>(
      std::vector<Deformation::Level>{{std::move(map), {}, DeformedPart::geometry, "components.wind"}});
  Plant plant = leafy_stems();
  plant.plantings.push_back({"leaning", variant_of(leafy_stems()), places(2), lean});
  plant.plantings.push_back({"tree", variant_of(leafy_stems()), places(2)});
  expect_count_of_meshes(plant);
}

TEST(GeometryCount, NeedsNoRoomForMeshes) {
  SizeLimits limits;
  limits.triangles = limits.mesh_bytes = 1;
  Progress progress;
  EXPECT_THROW(make_mesh_scene(leafy_stems(), limits, progress), InputError);
  EXPECT_GT(count_geometry(leafy_stems(), limits, progress).triangles, 1U);
}

}  // namespace meristem::geometry_count_test
