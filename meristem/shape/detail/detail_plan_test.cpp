// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/detail/detail_plan.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/leaf/leaf_blade.h"
#include "meristem/shape/scene/mesh_scene.h"
#include "meristem/shape/solid/primitives.h"
#include "tests/support/check_mesh.h"

namespace meristem::detail_plan_test {

constexpr int kLevels = 3;

/// Returns a trunk with many gnarled branches, which get thinner upward.
Stem gnarled_tree() {
  const RandomKey key(4);
  Stem stem;
  stem.parts[0].component = "tree";
  Skeleton& tree = stem.skeleton;
  NodeIndex trunk = tree.add_node(kNoNode, Vec3(0), 0);
  tree.radius[trunk] = 0.2F;
  for (AxisIndex branch = 1; branch <= 200; ++branch) {
    const float height = 0.05F * static_cast<float>(branch);
    trunk = tree.add_node(trunk, {0.01F * key.direction(branch).x, height, 0}, 0);
    tree.radius[trunk] = 0.2F - 0.017F * height;
    const double turn = key.uniform(branch, 0, 6.28);
    const Vec3 out(static_cast<float>(std::cos(turn)), 0.3F, static_cast<float>(std::sin(turn)));
    NodeIndex node = trunk;
    for (int k = 1; k <= 12; ++k) {
      const Vec3 gnarl = 0.05F * key.child("gnarl").direction(branch * 20 + static_cast<std::uint64_t>(k));
      node = tree.add_node(node, tree.position[trunk] + 0.15F * static_cast<float>(k) * out + gnarl, 0);
      tree.axis[node] = branch;
      tree.order[node] = 1;
      tree.radius[node] = 0.3F * tree.radius[trunk] / (1 + 0.2F * static_cast<float>(k));
    }
  }
  return stem;
}

Plant leafy_tree(int leaves = 4096) {
  Plant plant;
  plant.materials.resize(2);
  plant.stems = {gnarled_tree()};
  plant.prototypes = {{"leaf", 1, std::make_shared<const Mesh>(make_leaf_blade({.rows = 8, .across = 4}))},
                      {"apple", 0, std::make_shared<const Mesh>(make_sphere(0.04, 10))}};
  for (int k = 0; k < leaves; ++k) {
    plant.organs.push_back({frame_along(RandomKey(2).direction(static_cast<std::uint64_t>(k)), kUp, Vec3(1, 0, 0)), 0});
  }
  for (int k = 0; k < 10; ++k) plant.organs.push_back({frame_along(Vec3(0, k, 0), kUp, Vec3(1, 0, 0)), 1});
  return plant;
}

/// Returns a tree with a closed body instead of tubes.
Plant blended_tree(SurfaceOptions::Shading shading) {
  Plant plant;
  plant.materials.resize(1);
  plant.stems = {gnarled_tree()};
  plant.stems[0].parts[0].surface.style = SurfaceOptions::Style::blend;
  plant.stems[0].parts[0].surface.shading = shading;
  plant.stems[0].parts[0].surface.resolution = 60;
  return plant;
}

MeshScene scene_of(const Plant& plant, const MeshDetail& detail) {
  Progress progress;
  return make_mesh_scene(plant, {}, progress, detail);
}

double triangles_of(const MeshScene& scene, const std::string& component) {
  double count = 0;
  for (const MeshInstances& meshes : scene.meshes) {
    if (meshes.component == component) count += static_cast<double>(meshes.triangle_count());
  }
  return count;
}

double leaf_area(const MeshScene& scene) {
  double area = 0;
  for (const MeshInstances& meshes : scene.meshes) {
    if (meshes.component != "leaf") continue;
    for (const Frame& frame : meshes.frames) {
      const double scale = glm::length(frame.axes[0]);
      area += surface_area(*meshes.mesh) * scale * scale;
    }
  }
  return area;
}

bool are_equal(const MeshScene& a, const MeshScene& b) {
  if (a.meshes.size() != b.meshes.size()) return false;
  for (std::size_t k = 0; k < a.meshes.size(); ++k) {
    const MeshInstances& first = a.meshes[k];
    const MeshInstances& second = b.meshes[k];
    if (first.mesh->positions != second.mesh->positions || first.mesh->uvs != second.mesh->uvs ||
        first.mesh->normals != second.mesh->normals || first.mesh->triangles != second.mesh->triangles ||
        first.frames.size() != second.frames.size()) {
      return false;
    }
    for (std::size_t i = 0; i < first.frames.size(); ++i) {
      if (first.frames[i].axes != second.frames[i].axes || first.frames[i].origin != second.frames[i].origin) {
        return false;
      }
    }
  }
  return true;
}

TEST(Detail, LevelZeroIsThePlantItself) {
  const Plant plant = leafy_tree();
  const OrganDetail organs = plan_organs(plant, {}, DetailBudget(plant, {}));
  EXPECT_TRUE(organs.shown.empty());
  EXPECT_TRUE(organs.scale.empty());
  EXPECT_EQ(organs.meshes[0], plant.prototypes[0].mesh);
  const Stem& stem = plant.stems[0];
  const TubePlan whole(stem.skeleton, {{stem.parts[0].surface}});
  EXPECT_EQ(plan_tubes(stem.skeleton, {{stem.parts[0].surface}}, {}, 1).sizes()[0].triangles,
            whole.sizes()[0].triangles);
}

TEST(Detail, TubesAndOrgansTogetherFallByTheShare) {
  const Plant plant = leafy_tree();
  const auto all = [](const MeshScene& scene) { return static_cast<double>(scene.triangle_count()); };
  for (const double share : {0.25, 0.5}) {
    const MeshScene whole = scene_of(plant, {});
    MeshScene finer = whole;
    for (int level = 1; level <= kLevels; ++level) {
      const MeshDetail detail{level, share};
      MeshScene scene = scene_of(plant, detail);
      const double wanted = detail.kept() * all(whole);
      EXPECT_LE(all(scene), 1.05 * wanted) << level << " " << share;
      EXPECT_GE(all(scene), 0.6 * wanted) << level << " " << share;
      for (const char* component : {"tree", "leaf", "apple"}) {
        EXPECT_LE(triangles_of(scene, component), triangles_of(finer, component)) << component << level;
        EXPECT_GT(triangles_of(scene, component), 0) << component << level;
      }
      finer = std::move(scene);
    }
  }
}

TEST(Detail, BodiesFallByTheShareAndStayClosed) {
  for (const auto shading : {SurfaceOptions::Shading::smooth, SurfaceOptions::Shading::flat}) {
    const Plant plant = blended_tree(shading);
    const double whole = triangles_of(scene_of(plant, {}), "tree");
    for (int level = 1; level <= 2; ++level) {
      const MeshDetail detail{level};
      const MeshScene scene = scene_of(plant, detail);
      EXPECT_NEAR(triangles_of(scene, "tree"), detail.kept() * whole, 0.02 * whole);
      // No single normal fits all triangles at corners as sharp as these.
      Mesh body = *scene.meshes[0].mesh;
      if (shading == SurfaceOptions::Shading::smooth) body.normals.clear();
      EXPECT_TRUE(check_mesh(body));
      const bool is_flat = body.vertex_count() == 3 * body.triangle_count();
      EXPECT_EQ(is_flat, shading == SurfaceOptions::Shading::flat);
    }
  }
}

TEST(Detail, CoarseTubesStayWhole) {
  const Plant plant = leafy_tree(0);
  for (int level = 1; level <= kLevels; ++level) {
    EXPECT_TRUE(check_mesh(*scene_of(plant, {level}).meshes[0].mesh)) << level;
  }
}

TEST(Detail, ThinAxesGoFirst) {
  const Plant plant = leafy_tree(0);
  const Skeleton& tree = plant.stems[0].skeleton;
  const TubePlan plan = plan_tubes(tree, {{plant.stems[0].parts[0].surface}}, {}, MeshDetail{2}.kept());
  EXPECT_GT(plan[0].triangles(), 0U);
  for (std::size_t axis = 2; axis < plan.axis_count(); ++axis) {
    EXPECT_TRUE(plan[axis - 1].triangles() > 0 || plan[axis].triangles() == 0) << axis;
  }
  EXPECT_EQ(plan[200].triangles(), 0U);
}

TEST(Detail, KeepsTheAreaOfLeavesAsLongAsTheyNeedNotBeHuge) {
  const Plant plant = leafy_tree();
  const double whole = leaf_area(scene_of(plant, {}));
  for (int level = 1; level < kLevels; ++level) {
    EXPECT_NEAR(leaf_area(scene_of(plant, {level})), whole, 0.1 * whole) << level;
  }
}

TEST(Detail, WhatALevelShowsTheOneBeforeShowsToo) {
  const Plant plant = leafy_tree();
  std::size_t before = plant.organs.size();
  for (int level = 1; level <= kCoarsestDetail; ++level) {
    const OrganDetail finer = plan_organs(plant, {level - 1}, DetailBudget(plant, {level - 1}));
    const OrganDetail coarser = plan_organs(plant, {level}, DetailBudget(plant, {level}));
    std::size_t count = 0;
    for (std::size_t k = 0; k < plant.organs.size(); ++k) {
      if (!coarser.shows(k)) continue;
      ++count;
      ASSERT_TRUE(finer.shows(k)) << k << " at " << level;
    }
    EXPECT_LE(count, before);
    before = count;
  }
  EXPECT_EQ(before, 16U + 10U) << "the apples, and some leaves";
}

TEST(Detail, HasTheSameBytesOnAnyNumberOfThreads) {
  const Plant plant = leafy_tree();
  const MeshScene expected = scene_of(plant, {2});
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    EXPECT_TRUE(are_equal(scene_of(plant, {2}), expected));
  }
}

TEST(Detail, RejectsLevelsAndSharesOutOfRange) {
  for (const MeshDetail& detail :
       {MeshDetail{-1}, MeshDetail{kCoarsestDetail + 1}, MeshDetail{1, 0}, MeshDetail{1, 1}, MeshDetail{1, -2}}) {
    EXPECT_THROW(scene_of(Plant{}, detail), std::invalid_argument);
  }
}

}  // namespace meristem::detail_plan_test
