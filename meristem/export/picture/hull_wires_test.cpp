// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/picture/hull_wires.h"

#include <gtest/gtest.h>

#include "meristem/base/random.h"
#include "meristem/measure/convex_hull.h"
#include "tests/support/sample_scenes.h"

namespace meristem::hull_wires_test {

/// Returns the corners of a box of 4 x 2 x 1 m, and points on its faces.
std::vector<Vec3> box_points(Vec3 low) {
  const RandomKey key(1);
  std::vector<Vec3> points;
  for (unsigned k = 0; k < 8; ++k) points.push_back(low + Vec3(4.0F * (k & 1), 2.0F * (k >> 1 & 1), 1.0F * (k >> 2)));
  for (unsigned k = 0; k < 30; ++k) {
    const auto across = static_cast<float>(key.uniform(2 * k));
    points.push_back(low + Vec3(4 * across, 2.0F * (k & 1), static_cast<float>(key.uniform(2 * k + 1))));
  }
  return points;
}

/// Returns a trunk of 1 m that forks into twigs to all of `tips`.
Skeleton broom(Vec3 root, const std::vector<Vec3>& tips) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, root, 0);
  skeleton.add_node(0, root + kUp, 1);
  for (const Vec3 tip : tips) {
    const NodeIndex node = skeleton.add_node(1, tip, 2);
    skeleton.axis[node] = node - 1;
    skeleton.order[node] = node == 2 ? 0 : 1;
  }
  return skeleton;
}

Plant plant_of(const std::vector<Skeleton>& skeletons) {
  Plant plant;
  for (const Skeleton& skeleton : skeletons) {
    plant.stems.emplace_back();
    plant.stems.back().skeleton = skeleton;
  }
  return plant;
}

TEST(HullWires, FollowTheTwelveEdgesOfABoxAndNoneWithinItsFaces) {
  const std::vector<Frame> wires = hull_wires(convex_hull(box_points({-2, 1, 3})));
  ASSERT_EQ(wires.size(), 12U);
  double length = 0;
  for (const Frame& wire : wires) {
    length += glm::length(wire.heading());
    EXPECT_NEAR(glm::length(wire.right()), 4.0 / 400 / 2, 1e-6);
    EXPECT_NEAR(glm::length(wire.upper()), 4.0 / 400 / 2, 1e-6);
    EXPECT_NEAR(glm::dot(wire.right(), wire.heading()), 0, 1e-6);
  }
  EXPECT_NEAR(length, 4 * (4 + 2 + 1), 1e-4);
}

TEST(HullWires, RunFromCornerToCorner) {
  const Mesh hull = convex_hull(box_points({100, 0, -50}));
  Box box;
  for (const Frame& wire : hull_wires(hull)) {
    box.add(wire.point({0, 0, 0}));
    box.add(wire.point({0, 1, 0}));
  }
  EXPECT_LT(glm::length(box.low - Vec3(100, 0, -50)), 1e-4F);
  EXPECT_LT(glm::length(box.high - Vec3(104, 2, -49)), 1e-4F);
}

TEST(HullWires, OfARoundHullMatchItsEdges) {
  const RandomKey key(2);
  std::vector<Vec3> points;
  for (unsigned k = 0; k < 12; ++k) points.push_back(key.direction(k));
  const Mesh hull = convex_hull(points);
  // Euler: a closed mesh of triangles has three edges per two triangles.
  EXPECT_EQ(hull_wires(hull).size(), 3 * hull.triangle_count() / 2);
  EXPECT_TRUE(hull_wires(Mesh()).empty());
}

TEST(HullWires, SurroundEachTreeOfAPlant) {
  Skeleton pair = broom({-2, 0, 0}, box_points({-4, 2, 0}));
  pair.append(broom({20, 0, 0}, box_points({18, 2, 0})));
  const Plant plant = plant_of({pair, broom({40, 0, 0}, box_points({38, 2, 0}))});
  const MeshScene meshes = scene_of(triangle(), {Frame()});
  Progress progress;
  const MeshScene all = with_crown_hulls(meshes, plant, progress);
  ASSERT_EQ(all.meshes.size(), 2U);
  EXPECT_EQ(all.meshes[0].mesh, meshes.meshes[0].mesh);
  EXPECT_EQ(all.materials[all.meshes[1].material].roughness, 1);
  // Each crown, which is everything beyond the fork, is a box.
  EXPECT_EQ(all.meshes[1].frames.size(), 36U);
}

TEST(HullWires, OfAPlantWhoseLimbsAreStemsOfTheirOwnAreDrawnAsWell) {
  // A trunk of 3 m, and limbs to the corners of a box from 1 to 3 m.
  const auto pole = [](Vec3 from, Vec3 to) {
    Skeleton skeleton;
    skeleton.add_node(kNoNode, from, 0);
    skeleton.add_node(0, to, 1);
    return skeleton;
  };
  std::vector<Skeleton> stems{pole(Vec3(0), Vec3(0, 3, 0))};
  for (const float x : {-1.0F, 1.0F}) {
    for (const float z : {-1.0F, 1.0F}) {
      for (const float y : {1.0F, 3.0F}) stems.push_back(pole(Vec3(0, y, 0), Vec3(x, y, z)));
    }
  }
  Progress progress;
  const MeshScene all = with_crown_hulls(scene_of(triangle(), {Frame()}), plant_of(stems), progress);
  ASSERT_EQ(all.meshes.size(), 2U);
  EXPECT_EQ(all.meshes[1].frames.size(), 12U);
}

TEST(HullWires, OfTreesWithoutACrownAddNothing) {
  const Plant plant = plant_of({broom({0, 0, 0}, {}), broom({1, 0, 0}, {{1, 2, 0}})});
  Progress progress;
  const MeshScene all = with_crown_hulls(scene_of(triangle(), {Frame()}), plant, progress);
  EXPECT_EQ(all.meshes.size(), 1U);
  EXPECT_EQ(all.materials.size(), 1U);
}

}  // namespace meristem::hull_wires_test
