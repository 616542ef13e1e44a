// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/moving/moving_tube.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/shape/stem/stem_tubes.h"

namespace meristem::moving_tube_test {

/// Returns a stem along a bent line, with one node per 0.1 m.
Skeleton bent_stem(int nodes, float radius) {
  Skeleton skeleton;
  for (int k = 0; k < nodes; ++k) {
    const float way = 0.1F * static_cast<float>(k);
    skeleton.add_node(k == 0 ? kNoNode : static_cast<NodeIndex>(k - 1), {0.1F * way * way, way, 0}, 0);
    skeleton.radius.back() = radius;
  }
  return skeleton;
}

TubeShape tube_of(const Skeleton& skeleton, int sides = 8) {
  const TubePlan plan(skeleton, {{.surface = {.sides = sides, .flare = 0}}});
  Progress progress;
  return *tube_shape(plan, 0, make_tubes(plan, progress));
}

Mesh as_model_has_it(const TubeShape& tube, const TubeShape& model) {
  Mesh mesh;
  add_tube_vertices(tube, model, mesh);
  return mesh;
}

Box box_of(const std::vector<Vec3>& points) {
  Box box;
  for (const Vec3 point : points) box.add(point);
  return box;
}

TEST(MovingTube, TheModelsOwnShapeIsItself) {
  const TubeShape tube = tube_of(bent_stem(12, 0.02F));
  const Mesh mesh = as_model_has_it(tube, tube);
  EXPECT_EQ(mesh.positions, tube.positions);
  EXPECT_EQ(mesh.normals, tube.normals);
}

TEST(MovingTube, TrianglesAreThoseOfTheMesher) {
  const Skeleton skeleton = bent_stem(9, 0.02F);
  const TubePlan plan(skeleton, {{.surface = {.sides = 7}}});
  Progress progress;
  const std::vector<Mesh> meshes = make_tubes(plan, progress);
  Mesh mine;
  add_tube_triangles(*tube_shape(plan, 0, meshes), 0, mine);
  const auto sorted = [](Mesh mesh) {
    for (auto& [a, b, c] : mesh.triangles) {
      while (a > b || a > c) {
        const std::uint32_t first = a;
        a = b;
        b = c;
        c = first;
      }
    }
    std::ranges::sort(mesh.triangles);
    return mesh.triangles;
  };
  EXPECT_EQ(sorted(mine), sorted(meshes[0]));
}

TEST(MovingTube, WhatHasNotGrownLiesAtTheTip) {
  const TubeShape last = tube_of(bent_stem(12, 0.02F));
  const TubeShape young = tube_of(bent_stem(6, 0.012F));
  const Mesh mesh = as_model_has_it(young, last);
  ASSERT_EQ(mesh.positions.size(), last.positions.size());
  ASSERT_EQ(mesh.normals.size(), last.normals.size());
  const Box mine = box_of(mesh.positions), own = box_of(young.positions);
  EXPECT_LT(glm::distance(mine.low, own.low), 0.004F);
  EXPECT_LT(glm::distance(mine.high, own.high), 0.004F);
  // Rings that exist at this time are at their final positions.
  for (std::uint32_t ring = 1; ring < last.rings; ++ring) {
    const Vec3 there = last.positions[last.ring_vertex(ring, 0)];
    const Vec3 then = mesh.positions[last.ring_vertex(ring, 0)];
    if (there.y < 0.45F) {
      EXPECT_LT(glm::distance(there, then), 0.012F) << "ring " << ring;
    }
    if (there.y > 0.6F) {
      EXPECT_NEAR(then.y, 0.5F, 0.02F) << "ring " << ring;
    }
  }
}

TEST(MovingTube, ALongerOneOfTheSameFormKeepsItsShares) {
  Skeleton small = bent_stem(8, 0.02F);
  for (Vec3& position : small.position) position *= 0.5F;
  small.position[7].x += 0.2F;  // changes the line, so that it is not the beginning of the other
  const TubeShape model = tube_of(bent_stem(8, 0.02F));
  const Mesh mesh = as_model_has_it(tube_of(small), model);
  const Box mine = box_of(mesh.positions), own = box_of(tube_of(small).positions);
  EXPECT_LT(glm::distance(mine.high, own.high), 0.01F);
  // No two rings coincide.
  for (std::uint32_t ring = 1; ring < model.rings; ++ring) {
    const std::uint32_t vertex = model.ring_vertex(ring, 2);
    EXPECT_GT(glm::distance(mesh.positions[vertex], mesh.positions[vertex - model.sides - 1]), 1e-3F);
  }
}

TEST(MovingTube, OtherSidesLieOnTheTube) {
  const TubeShape model = tube_of(bent_stem(8, 0.02F), 12);
  const Mesh mesh = as_model_has_it(tube_of(bent_stem(8, 0.02F), 5), model);
  for (std::uint32_t side = 0; side < model.sides; ++side) {
    const Vec3 vertex = mesh.positions[model.ring_vertex(0, side)];
    const float radius = std::hypot(vertex.x, vertex.z);
    EXPECT_LE(radius, 0.0205F);
    EXPECT_GE(radius, 0.02F * std::cos(3.1416F / 5) - 0.0005F);
  }
}

TEST(MovingTube, WhatIsNotThereLiesAtItsBase) {
  const TubeShape tube = tube_of(bent_stem(8, 0.02F));
  Mesh mesh;
  add_collapsed_vertices(tube, tube, mesh);
  ASSERT_EQ(mesh.positions.size(), tube.positions.size());
  for (const Vec3 position : mesh.positions) EXPECT_LT(glm::length(position), 0.01F);
  EXPECT_EQ(mesh.normals, tube.normals);
}

}  // namespace meristem::moving_tube_test
