// SPDX-License-Identifier: Apache-2.0
// Tests that the checker finds and names each kind of error.
#include "tests/support/check_mesh.h"

#include <functional>
#include <limits>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "meristem/shape/solid/primitives.h"

namespace meristem {
namespace {

void expect_complaint(const std::string& text, const std::function<void(Mesh&)>& spoil) {
  Mesh mesh = make_box({1, 1, 1});
  spoil(mesh);
  const testing::AssertionResult result = check_mesh(mesh);
  EXPECT_FALSE(result) << text;
  EXPECT_NE(std::string(result.message()).find(text), std::string::npos) << result.message();
}

TEST(CheckMesh, NamesEachKindOfFault) {
  expect_complaint("23 normals for 24 vertices", [](Mesh& mesh) { mesh.normals.pop_back(); });
  expect_complaint("23 uvs for 24 vertices", [](Mesh& mesh) { mesh.uvs.pop_back(); });
  expect_complaint("position 3 is not finite",
                   [](Mesh& mesh) { mesh.positions[3].y = std::numeric_limits<float>::quiet_NaN(); });
  expect_complaint("uv 3 is not finite", [](Mesh& mesh) { mesh.uvs[3].x = std::numeric_limits<float>::infinity(); });
  expect_complaint("normal 5 has length 1.00999", [](Mesh& mesh) { mesh.normals[5] *= 1.01F; });
  expect_complaint("behind the normal of vertex 5", [](Mesh& mesh) { mesh.normals[5] *= -1.0F; });
  expect_complaint("no such vertex", [](Mesh& mesh) { mesh.triangles[2][1] = 24; });
  expect_complaint("degenerate", [](Mesh& mesh) { mesh.triangles[2][1] = mesh.triangles[2][0]; });
  expect_complaint("open edge", [](Mesh& mesh) { mesh.triangles.pop_back(); });
  expect_complaint("3 triangles", [](Mesh& mesh) { mesh.triangles.push_back(mesh.triangles[0]); });
}

TEST(CheckMesh, FindsTurnedTrianglesAndBodiesInsideOut) {
  expect_complaint("is turned against", [](Mesh& mesh) {
    mesh.normals.clear();
    std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  });
  expect_complaint("signed volume is -1", [](Mesh& mesh) {
    mesh.normals.clear();
    for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  });
}

TEST(CheckMesh, AsksOpenMeshesForNoClosedEdges) {
  Mesh box = make_box({1, 1, 1});
  box.triangles.pop_back();
  EXPECT_TRUE(check_mesh(box, {.closed = false}));
}

}  // namespace
}  // namespace meristem
