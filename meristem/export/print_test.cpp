// SPDX-License-Identifier: Apache-2.0
// Flat shaded meshes in files, as programs for 3D printing read them: faces share vertices and leave no open edge.
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "meristem/output/mesh/chosen_objects.h"
#include "meristem/output/mesh/obj.h"
#include "meristem/output/mesh/ply.h"
#include "meristem/output/mesh/shared_vertices.h"
#include "meristem/shape/mesh/shading.h"
#include "meristem/shape/solid/primitives.h"
#include "tests/support/check_mesh.h"
#include "tests/support/check_printable.h"
#include "tests/support/sample_scenes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace meristem::print_test {

MeshScene low_poly_oak() {
  Progress progress;
  const std::string file = project_file("models/low-poly-oak.json");
  std::ifstream in(file);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  const Document document = read_document(text, file, builtin_components());
  return grow_document(document, progress, {.up_to = GrownPart::meshes}).meshes;
}

/// An object of an OBJ, with its own numbers of vertices.
struct ObjObject {
  std::string name;
  Mesh mesh;
  std::vector<std::array<long, 3>> normals;  // for each face, from 1 in the file
};

std::vector<ObjObject> read_obj(const std::string& path) {
  std::vector<ObjObject> objects;
  std::ifstream file(path);
  std::size_t vertices = 0;  // of earlier objects
  for (std::string text; std::getline(file, text);) {
    std::istringstream line(text);
    std::string key;
    line >> key;
    if (key == "o") {
      if (!objects.empty()) vertices += objects.back().mesh.vertex_count();
      line >> objects.emplace_back().name;
    } else if (key == "v") {
      Vec3& at = objects.back().mesh.positions.emplace_back();
      line >> at.x >> at.y >> at.z;
    } else if (key == "f") {
      auto& triangle = objects.back().mesh.triangles.emplace_back();
      auto& normals = objects.back().normals.emplace_back();
      for (int k = 0; k < 3; ++k) {
        std::string corner;
        line >> corner;
        triangle[k] = static_cast<std::uint32_t>(std::stoul(corner) - 1 - vertices);
        normals[k] = std::stol(corner.substr(corner.rfind('/') + 1));
      }
    }
  }
  return objects;
}

std::vector<ObjObject> written(const MeshScene& scene) {
  const TemporaryFolder folder;
  Progress progress;
  const std::string path = (folder.path() / "plant.obj").string();
  write_obj(scene, path, {}, progress);
  return read_obj(path);
}

Mesh flat_cylinder() {
  Progress progress;
  Mesh cylinder = make_cylinder(0.1, 2, 12);
  cylinder.uvs.clear();
  return flat_shaded(cylinder, progress);
}

TEST(SharedVertices, FlatMeshesShareOneVertexPerPosition) {
  const Mesh mesh = flat_cylinder();
  ASSERT_TRUE(is_flat_shaded(mesh));
  EXPECT_FALSE(is_flat_shaded(make_cylinder(0.1, 2, 12)));
  EXPECT_FALSE(is_flat_shaded(*triangle()));
  const SharedVertices shared = share_vertices(mesh, false);
  EXPECT_EQ(static_cast<long>(shared.first.size()), euler_number(mesh) + static_cast<long>(mesh.triangle_count()) / 2);
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    ASSERT_EQ(mesh.positions[shared.first[shared.number[v]]], mesh.positions[v]);
  }
}

TEST(SharedVertices, TextureCoordinatesKeepThemApart) {
  Mesh mesh = *strip(2);
  mesh.positions.push_back(mesh.positions[0]);
  mesh.uvs.assign(mesh.positions.size(), Vec2(0));
  mesh.uvs.back().x = 1;
  EXPECT_EQ(share_vertices(mesh, true).first.size(), 5U);
  EXPECT_EQ(share_vertices(mesh, false).first.size(), 4U);
}

TEST(Print, FacesOfAFlatMeshShareVerticesAndHaveOneNormalInObj) {
  Frame moved = mirror();
  moved.origin = {1, 2, 3};
  const auto mesh = std::make_shared<const Mesh>(flat_cylinder());
  const std::vector<ObjObject> objects = written(scene_of(mesh, {moved}));
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_TRUE(check_printable(objects[0].mesh));
  EXPECT_NEAR(signed_volume(objects[0].mesh), signed_volume(*mesh), 1e-6);
  for (std::size_t t = 0; t < objects[0].normals.size(); ++t) {
    const long number = static_cast<long>(t) + 1;
    ASSERT_EQ(objects[0].normals[t], (std::array{number, number, number}));
  }
}

TEST(Print, TheLowPolyOakIsTwoClosedObjectsOf388Vertices) {
  const MeshScene scene = low_poly_oak();
  const std::vector<ObjObject> objects = written(scene);
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].name, "tree");
  EXPECT_EQ(objects[1].name, "tree_crown");
  EXPECT_EQ(objects[0].mesh.vertex_count() + objects[1].mesh.vertex_count(), 388U);
  for (const ObjObject& object : objects) EXPECT_TRUE(check_printable(object.mesh)) << object.name;
  EXPECT_EQ(count_crossings(objects[1].mesh), 0U);
  // Simplification may let thin twigs cross each other in a few places.
  EXPECT_LT(count_crossings(objects[0].mesh), objects[0].mesh.triangle_count() / 20);
}

/// Returns the number of vertices in the header of a PLY.
std::size_t ply_vertices(const MeshScene& scene, bool shared, std::string& header) {
  const TemporaryFolder folder;
  Progress progress;
  const std::string path = (folder.path() / "plant.ply").string();
  write_mesh_ply(scene, path, {.shared_vertices = shared}, progress);
  std::ifstream file(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  header = bytes.substr(0, bytes.find("end_header"));
  return std::stoul(header.substr(header.find("element vertex ") + 15));
}

TEST(Print, PlyWithSharedVerticesHasNoNormals) {
  const MeshScene scene = low_poly_oak();
  std::string header;
  EXPECT_EQ(ply_vertices(scene, false, header), 3 * scene.triangle_count());
  EXPECT_NE(header.find("property float nx"), std::string::npos);
  EXPECT_EQ(ply_vertices(scene, true, header), 388U);
  EXPECT_EQ(header.find("property float nx"), std::string::npos);
}

TEST(Print, CrossingTrianglesAreCounted) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2F, 0.2F, -1}, {0.2F, 0.2F, 1}, {2, 2, 0.5F}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_EQ(count_crossings(mesh), 1U);
  mesh.positions[4].z = -0.5F;
  mesh.positions[5].z = -0.5F;
  EXPECT_EQ(count_crossings(mesh), 0U);
  EXPECT_FALSE(check_printable(mesh));
}

TEST(ChosenObjects, ATrunkStandsWithoutItsCrown) {
  const MeshScene scene = low_poly_oak();
  const std::vector<std::string> trunk{"tree"}, crown{"tree_crown"}, wrong{"tree_corwn"};
  EXPECT_EQ(
      chosen_objects(scene, trunk, "--only").triangle_count() + chosen_objects(scene, crown, "--only").triangle_count(),
      scene.triangle_count());
  EXPECT_EQ(written(chosen_objects(scene, crown, "--only"))[0].name, "tree_crown");
  EXPECT_EQ(chosen_objects(scene, {}, "--only").triangle_count(), scene.triangle_count());
  try {
    chosen_objects(scene, wrong, "--only");
    FAIL() << "an unknown object is accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().front().message, "--only names 'tree_corwn', which is not among the plant's objects");
    EXPECT_EQ(error.diagnostics().front().expected, "tree, tree_crown");
    EXPECT_EQ(error.diagnostics().front().nearest, "tree_crown");
  }
}

}  // namespace meristem::print_test
