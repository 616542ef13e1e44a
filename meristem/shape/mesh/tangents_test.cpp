// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/mesh/tangents.h"

#include <gtest/gtest.h>

#include "meristem/base/frame.h"
#include "meristem/base/parallel.h"
#include "meristem/shape/leaf/leaf_blade.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem::tangents_test {

/// Returns a unit square in the plane of x and y, seen from z.
Mesh square() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.normals.assign(4, Vec3(0, 0, 1));
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

void expect_tangents(const Mesh& mesh, Vec4 expected) {
  ASSERT_EQ(mesh.tangents.size(), mesh.vertex_count());
  for (const Vec4 tangent : mesh.tangents) EXPECT_LT(glm::length(tangent - expected), 1e-6F);
}

TEST(Tangents, LieWhereURises) {
  Mesh mesh = square();
  add_tangents(mesh);
  expect_tangents(mesh, {1, 0, 0, 1});
}

TEST(Tangents, TurnWithTheUvs) {
  Mesh mesh = square();
  for (Vec2& uv : mesh.uvs) uv = {uv.y, 1 - uv.x};
  add_tangents(mesh);
  expect_tangents(mesh, {0, 1, 0, 1});
}

TEST(Tangents, TellOfMirroredUvs) {
  Mesh mesh = square();
  for (Vec2& uv : mesh.uvs) uv.x = -uv.x;
  add_tangents(mesh);
  expect_tangents(mesh, {-1, 0, 0, -1});
}

TEST(Tangents, DoNotDependOnTheSizeOfThePicture) {
  Mesh mesh = square();
  for (Vec2& uv : mesh.uvs) uv *= Vec2(1e-4F, 40);
  add_tangents(mesh);
  expect_tangents(mesh, {1, 0, 0, 1});
}

TEST(Tangents, AreAtRightAnglesToTheNormal) {
  Mesh mesh = square();
  for (Vec3& normal : mesh.normals) normal = glm::normalize(Vec3(1, 0, 1));
  add_tangents(mesh);
  const Vec3 expected = glm::normalize(Vec3(1, 0, -1));
  expect_tangents(mesh, Vec4(expected, 1));
}

TEST(Tangents, LargerTrianglesCountForMore) {
  // Two triangles share an edge. u runs along x in the first, which is nine times as large, and along y in the second.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {9, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
  mesh.normals.assign(4, Vec3(0, 0, 1));
  mesh.uvs = {{0, 0}, {9, 0}, {0, 1}, {1, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  add_tangents(mesh);
  EXPECT_GT(mesh.tangents[0].x, 0.98F);
  EXPECT_LT(mesh.tangents[3].x, 0.0F);
}

TEST(Tangents, AreUnitAndAcrossOnShapesOfOurs) {
  LeafBlade blade;
  blade.curl = 0.7;
  for (Mesh mesh : {make_cylinder(0.1, 2, 12), make_leaf_blade(blade)}) {
    add_tangents(mesh);
    ASSERT_EQ(mesh.tangents.size(), mesh.vertex_count());
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_NEAR(glm::length(Vec3(mesh.tangents[v])), 1, 1e-5) << v;
      EXPECT_NEAR(glm::dot(Vec3(mesh.tangents[v]), mesh.normals[v]), 0, 1e-5) << v;
      EXPECT_EQ(std::abs(mesh.tangents[v].w), 1) << v;
    }
  }
}

TEST(Tangents, WithoutAreaOnThePictureAreStillUnit) {
  Mesh mesh = square();
  mesh.uvs.assign(4, Vec2(0.5F));
  mesh.positions.emplace_back(5, 5, 5);
  mesh.normals.emplace_back(0, 1, 0);
  mesh.uvs.emplace_back(0, 0);
  add_tangents(mesh);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_NEAR(glm::length(Vec3(mesh.tangents[v])), 1, 1e-6);
    EXPECT_NEAR(glm::dot(Vec3(mesh.tangents[v]), mesh.normals[v]), 0, 1e-6);
  }
}

TEST(Tangents, NeedNormalsAndUvs) {
  Mesh bare = square();
  bare.normals.clear();
  add_tangents(bare);
  EXPECT_TRUE(bare.tangents.empty());
  bare = square();
  bare.uvs.clear();
  add_tangents(bare);
  EXPECT_TRUE(bare.tangents.empty());
}

TEST(Tangents, AreAddedOnlyForTexturesWithNormals) {
  const auto mesh = std::make_shared<const Mesh>(square());
  Material material;
  EXPECT_EQ(with_needed_tangents(mesh, material), mesh);
  auto texture = std::make_shared<Texture>();
  material.texture = texture;
  EXPECT_EQ(with_needed_tangents(mesh, material), mesh);
  texture->normals = {1, 1, {128, 128, 255, 255}};
  const auto changed = with_needed_tangents(mesh, material);
  EXPECT_EQ(changed->tangents.size(), 4U);
  EXPECT_TRUE(mesh->tangents.empty());
  EXPECT_EQ(with_needed_tangents(changed, material), changed);
}

TEST(Tangents, AreTheSameOnAnyNumberOfThreads) {
  const auto tangents = [](int threads) {
    const ThreadLimit limit(threads);
    Mesh mesh = make_cylinder(0.1, 2, 20000);
    add_tangents(mesh);
    return mesh.tangents;
  };
  const std::vector<Vec4> expected = tangents(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(tangents(threads), expected) << threads << " threads";
}

}  // namespace meristem::tangents_test
