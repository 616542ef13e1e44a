// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/detail/small_detail.h"

#include <map>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/shape/mesh/shading.h"
#include "meristem/shape/outline/outline.h"
#include "meristem/shape/solid/primitives.h"
#include "tests/support/check_mesh.h"

namespace meristem::small_detail_test {

/// Returns a trunk with a crown of flat faces and a few fruits.
MeshScene low_poly_tree() {
  Progress progress;
  MeshScene scene;
  scene.materials.resize(3);
  const auto add = [&](const char* component, std::uint32_t material, Mesh mesh, std::vector<Frame> frames) {
    scene.meshes.push_back({component, std::make_shared<const Mesh>(std::move(mesh)), material, std::move(frames), {}});
  };
  add("trunk", 0, make_cone(0.15, 2, 12), {Frame{}});
  add("crown", 1, flat_shaded(make_sphere(1, 20), progress), {Frame{.origin = {0, 2, 0}}});
  std::vector<Frame> fruits;
  for (std::uint64_t k = 0; k < 6; ++k) fruits.push_back({.origin = Vec3(0, 2, 0) + RandomKey(3).direction(k)});
  add("fruit", 2, flat_shaded(make_sphere(0.05, 6), progress), fruits);
  return scene;
}

MeshScene level_of(const MeshScene& scene, int level) {
  Progress progress;
  return small_detail(scene, {level}, progress);
}

/// Returns a level of that tree. Each level is made once.
const MeshScene& level_of_tree(int level) {
  static std::map<int, MeshScene> made;
  const auto [found, is_new] = made.try_emplace(level);
  if (is_new) found->second = level_of(low_poly_tree(), level);
  return found->second;
}

TEST(SmallDetail, EachLevelHasAQuarterOfTheTrianglesAndTheFirstTheOutline) {
  const MeshScene whole = low_poly_tree();
  Progress progress;
  auto before = static_cast<double>(whole.triangle_count());
  for (int level = 1; level <= 2; ++level) {
    const MeshScene& scene = level_of_tree(level);
    EXPECT_LE(static_cast<double>(scene.triangle_count()), 0.26 * before);
    if (level == 1) {
      EXPECT_GE(outline_overlap(whole, scene, {.size = 128}, progress).min(), 0.9);
    }
    before = static_cast<double>(scene.triangle_count());
  }
}

TEST(SmallDetail, NothingReachesOutOfTheWhole) {
  const MeshScene whole = low_poly_tree();
  const Box box = whole.bounds();
  for (int level = 1; level <= 3; ++level) {
    const Box coarse = level_of_tree(level).bounds();
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(coarse.low[k], box.low[k] - 1e-5F);
      EXPECT_LE(coarse.high[k], box.high[k] + 1e-5F);
    }
  }
}

TEST(SmallDetail, FlatFacesStayFlat) {
  for (const MeshInstances& part : level_of_tree(1).meshes) {
    if (part.component != "crown") continue;
    EXPECT_EQ(part.mesh->vertex_count(), 3 * part.mesh->triangle_count());
    for (const auto& triangle : part.mesh->triangles) {
      EXPECT_EQ(part.mesh->normals[triangle[0]], part.mesh->normals[triangle[1]]);
      EXPECT_EQ(part.mesh->normals[triangle[0]], part.mesh->normals[triangle[2]]);
    }
  }
}

TEST(SmallDetail, MirroredInstancesKeepTheirFrontsOutside) {
  MeshScene scene = low_poly_tree();
  scene.meshes[1].frames[0].axes[0] = Vec3(-1, 0, 0);
  for (const MeshInstances& part : level_of(scene, 1).meshes) {
    if (part.component != "crown") continue;
    for (std::size_t v = 0; v < part.mesh->vertex_count(); ++v) {
      EXPECT_GT(glm::dot(part.mesh->normals[v], part.mesh->positions[v] - Vec3(0, 2, 0)), 0);
    }
  }
}

TEST(SmallDetail, HasTheSameBytesOnAnyNumberOfThreads) {
  const MeshScene whole = low_poly_tree();
  const MeshScene& expected = level_of_tree(2);
  const ThreadLimit limit(3);
  const MeshScene scene = level_of(whole, 2);
  ASSERT_EQ(scene.meshes.size(), expected.meshes.size());
  for (std::size_t k = 0; k < scene.meshes.size(); ++k) {
    EXPECT_EQ(scene.meshes[k].mesh->positions, expected.meshes[k].mesh->positions);
    EXPECT_EQ(scene.meshes[k].mesh->triangles, expected.meshes[k].mesh->triangles);
  }
}

}  // namespace meristem::small_detail_test
