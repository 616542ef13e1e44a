// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/stem/cached_meshes.h"

#include <gtest/gtest.h>

#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/scene/mesh_scene.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem::cached_meshes_test {

/// Returns a pole with a branch of another component.
Stem forked(float height, SurfaceOptions surface = {}) {
  Stem stem;
  stem.parts.resize(2);
  stem.parts[0].component = "pole";
  stem.parts[1].component = "branch";
  for (StemPart& part : stem.parts) part.surface = surface;
  stem.part_of_axis = {0, 1};
  Skeleton& skeleton = stem.skeleton;
  const NodeIndex base = skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  const NodeIndex middle = skeleton.add_node(base, {0, 0.5F * height, 0}, 0);
  skeleton.add_node(middle, {0, height, 0}, 0);
  skeleton.add_node(middle, {1, height, 0}, 0);
  skeleton.radius = {0.2F, 0.15F, 0.1F, 0.05F};
  skeleton.axis = {0, 0, 0, 1};
  skeleton.order = {0, 0, 0, 1};
  return stem;
}

SurfaceOptions blended() {
  SurfaceOptions surface;
  surface.style = SurfaceOptions::Style::blend;
  surface.resolution = 20;
  return surface;
}

/// Returns two stems with tubes and one blended stem, with a sphere as organ.
Plant small_plant() {
  Plant plant;
  plant.materials.resize(1);
  plant.stems = {forked(2), forked(3), forked(4, blended())};
  plant.prototypes = {{"ball", 0, std::make_shared<const Mesh>(make_sphere(0.1, 6))}};
  plant.organs.resize(5);
  return plant;
}

MeshScene scene_of(const Plant& plant, Cache& cache, const MeshDetail& detail = {}) {
  Progress progress;
  return make_mesh_scene(plant, SizeLimits(), progress, detail, &cache);
}

/// Expects a scene that equals the scene made without a cache, mesh for mesh.
void expect_as_without(const MeshScene& scene, const Plant& plant, const MeshDetail& detail = {}) {
  Progress progress;
  const MeshScene plain = make_mesh_scene(plant, SizeLimits(), progress, detail);
  ASSERT_EQ(scene.meshes.size(), plain.meshes.size());
  for (std::size_t k = 0; k < plain.meshes.size(); ++k) {
    EXPECT_EQ(scene.meshes[k].component, plain.meshes[k].component);
    EXPECT_EQ(scene.meshes[k].material, plain.meshes[k].material);
    EXPECT_EQ(scene.meshes[k].mesh->positions, plain.meshes[k].mesh->positions);
    EXPECT_EQ(scene.meshes[k].mesh->normals, plain.meshes[k].mesh->normals);
    EXPECT_EQ(scene.meshes[k].mesh->uvs, plain.meshes[k].mesh->uvs);
    EXPECT_EQ(scene.meshes[k].mesh->tangents, plain.meshes[k].mesh->tangents);
    EXPECT_EQ(scene.meshes[k].mesh->triangles, plain.meshes[k].mesh->triangles);
    EXPECT_EQ(scene.meshes[k].tints, plain.meshes[k].tints);
  }
}

TEST(CachedMeshes, StemsThatHaveNotChangedKeepTheirMeshes) {
  Cache cache;
  Plant plant = small_plant();
  const MeshScene first = scene_of(plant, cache);
  EXPECT_EQ(cache.reuse<StemTubes>().made, 3U);
  EXPECT_EQ(cache.reuse<BodyMesh>().made, 2U);  // the pole's and the branch's
  plant.organs.resize(9);
  plant.stems[1].skeleton.radius[3] = 0.06F;
  const MeshScene second = scene_of(plant, cache);
  EXPECT_EQ(cache.reuse<StemTubes>().made, 1U);
  EXPECT_EQ(cache.reuse<StemTubes>().reused, 2U);
  EXPECT_EQ(cache.reuse<BodyMesh>().reused, 2U);
  EXPECT_EQ(second.meshes[0].mesh, first.meshes[0].mesh);
  EXPECT_NE(second.meshes[1].mesh, first.meshes[1].mesh);
  expect_as_without(second, plant);
}

TEST(CachedMeshes, WhatClothesAStemTellsItApart) {
  const Plant plain = small_plant();
  const auto made_after = [&](const Plant& changed, const MeshDetail& detail = {}) {
    Cache cache;
    scene_of(plain, cache);
    expect_as_without(scene_of(changed, cache, detail), changed, detail);
    return cache.reuse<StemTubes>().made;
  };
  EXPECT_EQ(made_after(plain), 0U);
  EXPECT_EQ(made_after(plain, {.level = 1}), 0U);  // levels of a small plant are made from its whole meshes
  Plant changed = plain;
  changed.stems[0].parts[1].surface.sides = 5;
  EXPECT_EQ(made_after(changed), 1U);
  changed = plain;
  changed.stems[0].parts[1].component = "pole";  // one mesh for both axes
  EXPECT_EQ(made_after(changed), 1U);
  changed = plain;
  changed.stems[0].part_of_axis = {1, 0};
  EXPECT_EQ(made_after(changed), 1U);
  changed = plain;
  auto texture = std::make_shared<Texture>();
  texture->normals = {1, 1, {0, 0, 255, 255}};
  changed.materials[0].texture = texture;
  EXPECT_EQ(made_after(changed), 3U);
  changed = plain;
  changed.stems[0].parts[0].tint = Vec3(0.5F);  // does not change the shape
  EXPECT_EQ(made_after(changed), 0U);
}

TEST(CachedMeshes, OrgansKeepTheirTangents) {
  Plant plant = small_plant();
  auto texture = std::make_shared<Texture>();
  texture->normals = {1, 1, {0, 0, 255, 255}};
  plant.materials[0].texture = texture;
  Cache cache;
  const MeshScene first = scene_of(plant, cache);
  const MeshScene second = scene_of(plant, cache);
  EXPECT_EQ(first.meshes.back().component, "ball");
  EXPECT_FALSE(first.meshes.back().mesh->tangents.empty());
  EXPECT_EQ(first.meshes.back().mesh, second.meshes.back().mesh);
  expect_as_without(second, plant);
}

TEST(CachedMeshes, HoldsWhatTheLastSceneUsed) {
  Cache cache;
  Plant plant = small_plant();
  scene_of(plant, cache);
  const std::uint64_t bytes = cache.bytes();
  for (int k = 0; k < 5; ++k) {
    plant.stems[0].skeleton.position[2].x = 0.01F * static_cast<float>(k);
    scene_of(plant, cache);
  }
  EXPECT_EQ(cache.bytes(), bytes);
  plant.stems.clear();
  scene_of(plant, cache);
  EXPECT_EQ(cache.bytes(), 0U);
}

TEST(CachedMeshes, StaysInOrderWhenCancelledOrTooLarge) {
  Cache cache;
  Plant plant = small_plant();
  scene_of(plant, cache);
  plant.stems[0].skeleton.radius[3] = 0.06F;
  Progress stopped;
  stopped.cancel();
  EXPECT_THROW(make_mesh_scene(plant, SizeLimits(), stopped, {}, &cache), Cancelled);
  SizeLimits few;
  few.triangles = 10;
  Progress progress;
  EXPECT_THROW(make_mesh_scene(plant, few, progress, {}, &cache), InputError);
  expect_as_without(scene_of(plant, cache), plant);
  EXPECT_EQ(cache.reuse<StemTubes>().made, 1U);
}

}  // namespace meristem::cached_meshes_test
