// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/rays/ray_scene.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/embree.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/shape/scene/scene_size.h"
#include "tests/support/sample_scenes.h"

namespace meristem::ray_scene_test {

/// Returns a level field of `side` by `side` squares of a metre, with its corner at the origin.
MeshScene field(std::uint32_t side) {
  Mesh mesh;
  for (std::uint32_t z = 0; z <= side; ++z)
    for (std::uint32_t x = 0; x <= side; ++x)
      mesh.positions.emplace_back(static_cast<float>(x), 0, static_cast<float>(z));
  for (std::uint32_t z = 0; z < side; ++z) {
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t corner = z * (side + 1) + x;
      mesh.triangles.push_back({corner, corner + side + 1, corner + 1});
      mesh.triangles.push_back({corner + 1, corner + side + 1, corner + side + 2});
    }
  }
  MeshScene scene;
  scene.materials.resize(1);
  scene.meshes = {{"field", std::make_shared<const Mesh>(std::move(mesh)), 0, {Frame()}}};
  return scene;
}

// When a build is cancelled, TBB reads the contexts in which all existing objects were built. Once, such a context
// belonged to a finished loop.
TEST(RayScene, MayOutliveTheLoopThatItWasBuiltIn) {
  const MeshScene scene = field(200);
  std::vector<std::unique_ptr<RayScene>> kept(8);
  parallel_for(kept.size(), 1, [&](std::size_t k, std::size_t) {
    Progress progress;
    kept[k] = std::make_unique<RayScene>(scene, progress);
  });
  for (int milliseconds = 0; milliseconds < 12; ++milliseconds) {
    Progress progress;
    const std::jthread cancels([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      progress.cancel();
    });
    try {
      const RayScene built(scene, progress);
    } catch (const Cancelled&) {
      continue;
    }
  }
  for (const std::unique_ptr<RayScene>& one : kept)
    EXPECT_TRUE(one->is_blocked({Vec3(100.3F, 1, 100.2F), Vec3(0, -1, 0)}));
}

constexpr std::uint64_t kMany = std::numeric_limits<std::uint64_t>::max();
constexpr RaySceneOptions kCopied{.copied_triangles = kMany, .large_from = kMany};
constexpr RaySceneOptions kInstanced{.copied_triangles = 0, .large_from = kMany};
constexpr RaySceneOptions kLarge{.copied_triangles = kMany, .large_from = 0};

/// Returns a stem and leaves with holes, turned, scaled and mirrored in all ways, at these places (null: once in the
/// world).
MeshScene tree(std::size_t leaves, std::shared_ptr<const std::vector<Frame>> places) {
  MeshScene scene = leafy_scene(leaves);
  scene.materials[0].texture = plain_texture();
  for (MeshInstances& part : scene.meshes) part.places = places;
  return scene;
}

std::shared_ptr<const std::vector<Frame>> places_in_rows(int count) {
  std::vector<Frame> places;
  for (int k = 0; k < count; ++k) {
    places.push_back(frame_along({10.0F * static_cast<float>(k % 100), 0, 10.0F * static_cast<float>(k / 100)},
                                 RandomKey(9).direction(static_cast<std::uint64_t>(k)), kUp));
  }
  return std::make_shared<const std::vector<Frame>>(std::move(places));
}

/// Returns rays from all sides to points around the first two places.
std::vector<Ray> rays_to(std::uint64_t count) {
  const RandomKey key(4);
  std::vector<Ray> rays;
  for (std::uint64_t k = 0; k < count; ++k) {
    const Vec3 middle(k % 2 == 0 ? 0 : 10, 0, 0);
    const Vec3 from = middle + 20.0F * key.direction(2 * k);
    const Vec3 to = middle + static_cast<float>(key.uniform(k, 0.0, 4.0)) * key.direction(2 * k + 1);
    rays.push_back({from, glm::normalize(to - from)});
  }
  return rays;
}

/// Expects that instances and copies have equal hits, apart from rounding: rays that pass within micrometres of an edge
/// may differ.
void expect_equal_hits(const MeshScene& scene, const RaySceneOptions& options) {
  Progress progress;
  const RayScene instanced(scene, progress, options), copied(scene, progress, kCopied);
  int hits = 0;
  int differ = 0;
  for (const Ray& ray : rays_to(20'000)) {
    const auto a = instanced.first_hit(ray), b = copied.first_hit(ray);
    EXPECT_EQ(a.has_value(), instanced.is_blocked(ray));
    const bool is_equal = a.has_value() == b.has_value() &&
                          (!a || (a->part == b->part && a->instance == b->instance && a->triangle == b->triangle));
    if (!is_equal) ++differ;
    if (!a || !is_equal) continue;
    ++hits;
    // Rounding moves the ray sideways by micrometres, which shifts the hit far along a surface at a low angle.
    const float cosine = std::abs(glm::dot(copied.face_normal(*b), ray.direction));
    ASSERT_NEAR(cosine * a->distance, cosine * b->distance, 2e-5);
    ASSERT_NEAR(a->barycentric.x, b->barycentric.x, 2e-3);
    ASSERT_NEAR(a->barycentric.y, b->barycentric.y, 2e-3);
    EXPECT_FALSE(a->distance > 0.1F && instanced.is_blocked(ray, a->distance - 0.01F));
  }
  EXPECT_GT(hits, 5000);
  EXPECT_LE(differ, 4);
}

TEST(RayScene, InstancesOfLeavesHaveTheHitsOfTheirCopies) {
  expect_equal_hits(tree(500, nullptr), kInstanced);
  expect_equal_hits(tree(500, nullptr), kLarge);
}

TEST(RayScene, InstancesInPlacedPlantsHaveTheHitsOfTheirCopies) {
  expect_equal_hits(tree(500, places_in_rows(5)), kInstanced);
  expect_equal_hits(tree(500, places_in_rows(5)), kLarge);
}

TEST(RayScene, ALevelFieldIsHitWhereItLiesAlsoAsAnInstance) {
  MeshScene scene = field(20);
  const Frame low = shifted({0, -3, 0});
  scene.meshes[0].frames = {shifted({0, -1, 0}), low};
  Progress progress;
  const RayScene rays(scene, progress, kInstanced);
  const auto hit = rays.first_hit({Vec3(2.25F, 4, 3.5F), Vec3(0, -1, 0)});
  ASSERT_TRUE(hit);
  // Embree divides by an approximate reciprocal, whose last digit depends on the maker of the processor.
  EXPECT_FLOAT_EQ(hit->distance, 5);
  EXPECT_EQ(hit->instance, 0U);
  EXPECT_EQ(hit->triangle, 2 * (3 * 20 + 2U));
  EXPECT_FLOAT_EQ(hit->barycentric.x, 0.5F);
  EXPECT_FLOAT_EQ(hit->barycentric.y, 0.25F);
  EXPECT_EQ(rays.first_hit({Vec3(2.25F, -2, 3.5F), Vec3(0, -1, 0)})->instance, 1U);
  EXPECT_FALSE(rays.first_hit({Vec3(2.25F, -4, 3.5F), Vec3(0, -1, 0)}));
}

TEST(RayScene, FlatInstancesShowNoSurface) {
  MeshScene scene = field(20);
  Frame flat;
  flat.axes[1] = Vec3(0);
  scene.meshes[0].frames = {flat, shifted({0, -1, 0})};
  Progress progress;
  const RayScene rays(scene, progress, kInstanced);
  EXPECT_EQ(rays.first_hit({Vec3(2.25F, 4, 3.5F), Vec3(0, -1, 0)})->instance, 1U);
}

std::uint64_t bytes_of(const MeshScene& scene, const RaySceneOptions& options = kInstanced) {
  Progress progress;
  return RayScene(scene, progress, options).bytes();
}

TEST(RayScene, AnotherLeafCostsAnInstanceWhateverItsMesh) {
  const auto stand = [](std::shared_ptr<const Mesh> leaf, std::size_t leaves) {
    MeshScene scene = leafy_scene(leaves);
    scene.meshes[0].mesh = std::move(leaf);
    return bytes_of(scene);
  };
  const auto fine = strip(2000);
  EXPECT_LE(stand(fine, 40'000) - stand(fine, 20'000), 20'000 * 120U);
  EXPECT_LE(stand(fine, 40'000), stand(triangle(), 40'000) + 2000 * 150U);
}

TEST(RayScene, LargeScenesTakeAFewBytesForATriangleAndALeaf) {
  MeshScene trunk = leafy_scene(4);
  trunk.meshes[1].mesh = strip(1'000'000);
  EXPECT_LE(bytes_of(trunk, kLarge), 1'000'000 * 15U);
  EXPECT_LE(bytes_of(leafy_scene(400'000), kLarge), 400'000 * 35U);
}

/// Returns a level field whose u rises along x, and whose tangents point elsewhere.
MeshScene field_with_tangents() {
  MeshScene scene = field(4);
  Mesh mesh = *scene.meshes[0].mesh;
  for (const Vec3 position : mesh.positions) mesh.uvs.emplace_back(position.x, -position.z);
  mesh.normals.assign(mesh.vertex_count(), kUp);
  mesh.tangents.assign(mesh.vertex_count(), Vec4(0, 0, 1, 1));
  scene.meshes[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
  return scene;
}

TEST(RayScene, LargeScenesTakeTheDirectionsOfTexturesFromUvs) {
  MeshScene scene = field_with_tangents();
  const auto along_u = [&](const RaySceneOptions& options) {
    Progress progress;
    const RayScene rays(scene, progress, options);
    return rays.texture_mapping(*rays.first_hit({Vec3(1.3F, 4, 2.2F), Vec3(0, -1, 0)})).along_u;
  };
  EXPECT_LT(glm::distance(along_u(kCopied), Vec3(0, 0, 1)), 1e-6F);
  EXPECT_LT(glm::distance(along_u(kLarge), Vec3(1, 0, 0)), 1e-6F);
  free_tangents(scene);
  EXPECT_LT(glm::distance(along_u(kLarge), Vec3(1, 0, 0)), 1e-6F);
}

TEST(SceneSize, FreedTangentsLeaveAllElseAndSharedMeshesShared) {
  MeshScene scene = field_with_tangents();
  scene.meshes.push_back(scene.meshes[0]);
  scene.meshes[1].frames.resize(3);
  scene.meshes.push_back(field_with_tangents().meshes[0]);
  EXPECT_EQ(distinct_size(scene), 3 * 32 + 1 + 3 + 1U);
  const Mesh before = *scene.meshes[0].mesh;
  const std::shared_ptr<const Mesh> of_others = scene.meshes[2].mesh;
  free_tangents(scene);
  const Mesh& after = *scene.meshes[0].mesh;
  EXPECT_EQ(&after, scene.meshes[1].mesh.get());
  EXPECT_NE(&after, scene.meshes[2].mesh.get());
  EXPECT_TRUE(after.tangents.empty());
  EXPECT_FALSE(of_others->tangents.empty()) << "the mesh of others keeps its tangents";
  EXPECT_EQ(after.positions, before.positions);
  EXPECT_EQ(after.normals, before.normals);
  EXPECT_EQ(after.uvs, before.uvs);
  EXPECT_EQ(after.triangles, before.triangles);
}

TEST(SceneSize, PartsThatAloneShareAMeshStillShareItWithoutTangents) {
  MeshScene scene = field_with_tangents();
  scene.meshes.push_back(scene.meshes[0]);
  scene.meshes.push_back(scene.meshes[0]);
  free_tangents(scene);
  EXPECT_TRUE(scene.meshes[0].mesh->tangents.empty());
  EXPECT_EQ(scene.meshes[0].mesh, scene.meshes[1].mesh);
  EXPECT_EQ(scene.meshes[0].mesh, scene.meshes[2].mesh);
}

TEST(RayScene, AnotherPlaceOfAPlantCostsAnInstance) {
  const std::uint64_t few = bytes_of(tree(2000, places_in_rows(100)));
  const std::uint64_t many = bytes_of(tree(2000, places_in_rows(10'100)));
  EXPECT_LE(many - few, 10'000 * (120 + kCountedInstanceBytes));
  EXPECT_LE(few, 5000 * 150U + 2000 * 120U + 100'000);  // the triangles of the stem and of the leaves once
}

TEST(RayScene, PlantingsThatShareAMeshShareItsTree) {
  MeshScene scene = leafy_scene(4);
  scene.meshes[0].mesh = strip(100'000);
  const std::uint64_t once = bytes_of(scene);
  MeshInstances again = scene.meshes[0];
  again.places = places_in_rows(3);
  scene.meshes.push_back(again);
  EXPECT_LE(bytes_of(scene), once + 100'000);
}

}  // namespace meristem::ray_scene_test
