// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/stem/body_meshes.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/plant/texture.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "tests/support/body_plants.h"
#include "tests/support/check_mesh.h"

namespace meristem::body_meshes_test {

CacheRun uncached(nullptr, {});

/// Returns one fork of component "tree" with that surface.
Plant fork_in(const SurfaceOptions& surface) {
  Plant plant;
  plant.materials.resize(1);
  plant.materials[0].name = "bark";
  Stem& stem = plant.stems.emplace_back();
  stem.parts[0].component = "tree";
  stem.parts[0].surface = surface;
  stem.skeleton = forked();
  return plant;
}

MeshScene scene_of(const Plant& plant, const SizeLimits& limits = {}) {
  Progress progress;
  return make_mesh_scene(plant, limits, progress);
}

SurfaceOptions blended(int resolution = 40) {
  return {.style = SurfaceOptions::Style::blend, .resolution = resolution};
}

std::string error_path(const Plant& plant, const SizeLimits& limits) {
  try {
    scene_of(plant, limits);
  } catch (const InputError& error) {
    return error.diagnostics().front().path;
  }
  return "no error";
}

TEST(BodyMeshes, ABlendedStemIsOneClosedMeshAndNoTubes) {
  const MeshScene scene = scene_of(fork_in(blended()));
  ASSERT_EQ(scene.meshes.size(), 1U);
  EXPECT_EQ(scene.meshes[0].component, "tree");
  EXPECT_EQ(scene.meshes[0].frames.size(), 1U);
  EXPECT_TRUE(check_mesh(*scene.meshes[0].mesh));
  EXPECT_EQ(component_count(*scene.meshes[0].mesh), 1U);
  EXPECT_EQ(scene.materials.size(), 1U);
}

TEST(BodyMeshes, TubesHaveNone) {
  Progress progress;
  std::vector<Material> materials(1);
  EXPECT_TRUE(make_body_meshes(fork_in({}), {}, {}, materials, progress, uncached).empty());
  EXPECT_EQ(materials.size(), 1U);
}

TEST(BodyMeshes, CrownsHaveTheirOwnColour) {
  for (const SurfaceOptions::Style style : {SurfaceOptions::Style::tubes, SurfaceOptions::Style::blend}) {
    SurfaceOptions surface = blended();
    surface.style = style;
    surface.crown = CrownBody{.diameter = 0.4F, .colour = {0.1F, 0.7F, 0.2F}};
    const MeshScene scene = scene_of(fork_in(surface));
    ASSERT_EQ(scene.meshes.size(), 2U);
    ASSERT_EQ(scene.materials.size(), 2U);
    const MeshInstances& crown = scene.meshes[1];
    EXPECT_EQ(crown.component, "tree");
    EXPECT_EQ(scene.materials[crown.material].name, "bark_crown");
    EXPECT_EQ(scene.materials[crown.material].colour, Vec3(0.1F, 0.7F, 0.2F));
    EXPECT_EQ(scene.materials[scene.meshes[0].material].name, "bark");
    EXPECT_TRUE(check_mesh(*crown.mesh));
    surface.crown->hidden = true;
    EXPECT_EQ(scene_of(fork_in(surface)).meshes.size(), 1U);
    EXPECT_EQ(scene_of(fork_in(surface)).materials.size(), 1U);
  }
}

TEST(BodyMeshes, HaveNoTextures) {
  Plant plant = fork_in(blended());
  plant.materials[0].texture = std::make_shared<const Texture>();
  const MeshScene scene = scene_of(plant);
  ASSERT_EQ(scene.meshes.size(), 1U);
  EXPECT_EQ(scene.materials[scene.meshes[0].material].texture, nullptr);
  EXPECT_TRUE(scene.meshes[0].mesh->uvs.empty());
  EXPECT_NE(scene.materials[0].texture, nullptr);
}

TEST(BodyMeshes, HaveAtMostSoManyTriangles) {
  SurfaceOptions surface = blended(60);
  surface.crown = CrownBody{.diameter = 0.4F, .fuse = 0.4F};
  surface.triangles = 300;
  surface.crown->triangles = 100;
  for (const SurfaceOptions::Shading shading : {SurfaceOptions::Shading::smooth, SurfaceOptions::Shading::flat}) {
    surface.shading = shading;
    const MeshScene scene = scene_of(fork_in(surface));
    ASSERT_EQ(scene.meshes.size(), 2U);
    EXPECT_LE(scene.meshes[0].mesh->triangle_count(), 300U);
    EXPECT_GE(scene.meshes[0].mesh->triangle_count(), 298U);
    EXPECT_LE(scene.meshes[1].mesh->triangle_count(), 100U);
    for (const MeshInstances& body : scene.meshes) EXPECT_TRUE(check_mesh(*body.mesh));
  }
}

TEST(BodyMeshes, FlatShadedShareNoVertices) {
  SurfaceOptions surface = blended();
  surface.shading = SurfaceOptions::Shading::flat;
  const MeshScene scene = scene_of(fork_in(surface));
  const Mesh& mesh = *scene.meshes.at(0).mesh;
  EXPECT_EQ(mesh.vertex_count(), 3 * mesh.triangle_count());
  EXPECT_TRUE(check_mesh(mesh));
  for (const auto& [a, b, c] : mesh.triangles) {
    ASSERT_EQ(mesh.normals[a], mesh.normals[b]);
    ASSERT_EQ(mesh.normals[a], mesh.normals[c]);
  }
}

TEST(BodyMeshes, HaveTheirStemsTint) {
  Plant plant = fork_in(blended());
  plant.stems[0].parts[0].tint = {0.5F, 1, 1};
  EXPECT_EQ(scene_of(plant).meshes.at(0).tint(0), Vec3(0.5F, 1, 1));
}

TEST(BodyMeshes, HaveTheSameBytesOnAnyNumberOfThreads) {
  Plant plant = fork_in(blended(60));
  plant.stems[0].parts[0].surface.crown = CrownBody{};
  for (int k = 1; k < 6; ++k) {
    plant.stems.push_back(plant.stems[0]);
    plant.stems.back().parts[0].surface.resolution = 20 + 10 * k;
    for (Vec3& position : plant.stems.back().skeleton.position) position.x += static_cast<float>(k);
  }
  plant.stems[3].parts[0].surface.triangles = 500;
  const MeshScene expected = scene_of(plant);
  EXPECT_EQ(expected.meshes.size(), 12U);
  EXPECT_EQ(expected.materials.size(), 2U);
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    const MeshScene scene = scene_of(plant);
    ASSERT_EQ(scene.meshes.size(), expected.meshes.size());
    for (std::size_t k = 0; k < scene.meshes.size(); ++k) {
      EXPECT_EQ(scene.meshes[k].mesh->positions, expected.meshes[k].mesh->positions) << k;
      EXPECT_EQ(scene.meshes[k].mesh->normals, expected.meshes[k].mesh->normals) << k;
      EXPECT_EQ(scene.meshes[k].mesh->triangles, expected.meshes[k].mesh->triangles) << k;
    }
  }
}

TEST(BodyMeshes, LimitsNameTheResolution) {
  Plant plant = fork_in(blended(200));
  EXPECT_EQ(error_path(plant, {.triangles = 5000}), "components.tree.surface.resolution");
  EXPECT_EQ(error_path(plant, {.mesh_bytes = 500'000}), "components.tree.surface.resolution");
  plant.stems[0].parts[0].surface = {.crown = CrownBody{.resolution = 200}};
  EXPECT_EQ(error_path(plant, {.triangles = 20'000}), "components.tree.surface.crown.resolution");
}

TEST(BodyMeshes, StopWhenAsked) {
  Progress progress;
  progress.cancel();
  std::vector<Material> materials(1);
  EXPECT_THROW(make_body_meshes(fork_in(blended()), {}, {}, materials, progress, uncached), Cancelled);
}

}  // namespace meristem::body_meshes_test
