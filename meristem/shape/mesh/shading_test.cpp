// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/mesh/shading.h"

#include <gtest/gtest.h>

#include "meristem/shape/solid/primitives.h"
#include "tests/support/check_mesh.h"
#include "tests/support/sample_bodies.h"

namespace meristem::shading_test {

TEST(Shading, FlatFacesHaveOneNormalEach) {
  const Mesh mesh = make_sphere(2, 12);
  Progress progress;
  const Mesh flat = flat_shaded(mesh, progress);
  EXPECT_TRUE(check_mesh(flat));
  EXPECT_EQ(flat.triangle_count(), mesh.triangle_count());
  EXPECT_EQ(flat.vertex_count(), 3 * mesh.triangle_count());
  EXPECT_EQ(flat.uvs.size(), flat.vertex_count());
  EXPECT_TRUE(flat.tangents.empty());
  EXPECT_DOUBLE_EQ(surface_area(flat), surface_area(mesh));
  for (const auto& [a, b, c] : flat.triangles) {
    EXPECT_EQ(flat.normals[a], flat.normals[b]);
    EXPECT_EQ(flat.normals[b], flat.normals[c]);
    EXPECT_NEAR(glm::dot(flat.normals[a], flat.positions[b] - flat.positions[a]), 0, 1e-6);
  }
}

TEST(Shading, SmoothNormalsOfASphereAreItsRadii) {
  const TriangleMesh body = sphere_mesh(3);
  Mesh mesh;
  for (const DVec3 position : body.positions) mesh.positions.emplace_back(position);
  mesh.triangles = body.triangles;
  const Mesh smooth = smooth_shaded(mesh);
  EXPECT_TRUE(check_mesh(smooth));
  EXPECT_EQ(smooth.triangles, mesh.triangles);
  for (std::size_t v = 0; v < smooth.vertex_count(); ++v) {
    EXPECT_LT(glm::distance(smooth.normals[v], smooth.positions[v]), 1e-5F);
  }
}

TEST(Shading, GivesVerticesWithoutAreaSomeNormal) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}};
  mesh.triangles = {{0, 1, 2}, {0, 0, 1}};
  Progress progress;
  for (const Mesh& shaded : {flat_shaded(mesh, progress), smooth_shaded(mesh)}) {
    for (const Vec3 normal : shaded.normals) EXPECT_EQ(normal, kUp);
  }
}

}  // namespace meristem::shading_test
