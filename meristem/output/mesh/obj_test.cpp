// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/mesh/obj.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "meristem/base/colour.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/base/read_image.h"
#include "meristem/shape/solid/primitives.h"
#include "tests/support/check_mesh.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/sample_scenes.h"
#include "tests/support/temporary_folder.h"

namespace meristem::obj_test {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

std::vector<std::uint8_t> pixels_of(const fs::path& path) { return read_image(path.string(), SizeLimits()).rgba; }

/// One corner of a face, as indices from 0, or -1 for missing attributes.
struct Corner {
  long position = -1, uv = -1, normal = -1;
};

/// An OBJ as an independent reader sees it.
struct Obj {
  std::vector<Vec3> positions, normals;
  std::vector<Vec2> uvs;
  std::vector<Corner> corners;               // three per face
  std::vector<std::string> objects, groups;  // in the order of the file
  std::vector<std::string> face_materials;   // for each face
  std::vector<std::string> libraries;
  std::vector<Vec3> colours;  // of the positions that have a colour

  /// Returns the faces as a mesh with one vertex per position.
  Mesh mesh() const {
    Mesh result{.positions = positions, .normals = {}, .uvs = {}, .triangles = {}};
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      const auto index = [&](std::size_t corner) { return static_cast<std::uint32_t>(corners[k + corner].position); };
      result.triangles.push_back({index(0), index(1), index(2)});
    }
    return result;
  }
};

std::vector<float> floats_of(std::istringstream& line) {
  std::vector<float> numbers;
  for (std::string word; line >> word;) numbers.push_back(std::strtof(word.c_str(), nullptr));
  return numbers;
}

Corner corner_of(const std::string& word) {
  Corner corner;
  std::istringstream parts(word);
  std::string part;
  long* const indices[] = {&corner.position, &corner.uv, &corner.normal};
  for (int k = 0; std::getline(parts, part, '/'); ++k) {
    if (!part.empty()) *indices[k] = std::stol(part) - 1;
  }
  return corner;
}

Obj parse(const std::string& text) {
  Obj obj;
  std::string material;
  std::istringstream lines(text);
  for (std::string text_line; std::getline(lines, text_line);) {
    std::istringstream line(text_line);
    std::string key;
    std::string rest;
    line >> key;
    if (key == "v" || key == "vn") {
      const std::vector<float> numbers = floats_of(line);
      EXPECT_TRUE(numbers.size() == 3U || (key == "v" && numbers.size() == 6U)) << text_line;
      if (numbers.size() == 6) obj.colours.emplace_back(numbers[3], numbers[4], numbers[5]);
      (key == "v" ? obj.positions : obj.normals).emplace_back(numbers.at(0), numbers.at(1), numbers.at(2));
    } else if (key == "vt") {
      const std::vector<float> numbers = floats_of(line);
      EXPECT_EQ(numbers.size(), 2U);
      obj.uvs.emplace_back(numbers.at(0), numbers.at(1));
    } else if (key == "f") {
      for (std::string word; line >> word;) obj.corners.push_back(corner_of(word));
      obj.face_materials.push_back(material);
    } else if (!key.empty() && key[0] != '#') {
      std::getline(line >> std::ws, rest);
      if (key == "usemtl") material = rest;
      if (key == "o") obj.objects.push_back(rest);
      if (key == "g") obj.groups.push_back(rest);
      if (key == "mtllib") obj.libraries.push_back(rest);
    }
  }
  EXPECT_EQ(obj.corners.size(), 3 * obj.face_materials.size());
  return obj;
}

/// Returns the values of each material in an MTL, by key.
std::map<std::string, std::map<std::string, std::vector<float>>> parse_materials(const std::string& text) {
  std::map<std::string, std::map<std::string, std::vector<float>>> materials;
  std::string name;
  std::istringstream lines(text);
  for (std::string text_line; std::getline(lines, text_line);) {
    std::istringstream line(text_line);
    std::string key;
    line >> key;
    if (key.empty() || key[0] == '#') continue;
    if (key == "newmtl") {
      std::getline(line >> std::ws, name);
      EXPECT_TRUE(materials.try_emplace(name).second) << name << " twice";
    } else {
      materials[name][key] = floats_of(line);
    }
  }
  return materials;
}

class ObjTest : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  void write(const MeshScene& scene, const std::string& name = "plant.obj") const {
    Progress progress;
    write_obj(scene, at(name), {}, progress);
  }
  Obj written(const MeshScene& scene) const {
    write(scene);
    return parse(content_of(at("plant.obj")));
  }

  const TemporaryFolder temporary_;
  const fs::path& folder_ = temporary_.path();
};

TEST_F(ObjTest, HoldsEveryInstanceToTheLastBit) {
  const MeshScene scene = leafy_scene(1000);
  const Obj obj = written(scene);
  const Mesh expected = flattened(scene);
  EXPECT_EQ(obj.positions, expected.positions);
  // The stem comes last and has neither normals nor uvs.
  EXPECT_EQ(obj.normals, std::vector<Vec3>(expected.normals.begin(), expected.normals.begin() + 3000));
  EXPECT_EQ(obj.uvs, std::vector<Vec2>(expected.uvs.begin(), expected.uvs.begin() + 3000));
  EXPECT_EQ(obj.mesh().triangles, expected.triangles);
  for (std::size_t k = 0; k < obj.corners.size(); ++k) {
    const Corner& corner = obj.corners[k];
    ASSERT_EQ(corner.uv, k < 3000 ? corner.position : -1);
    ASSERT_EQ(corner.normal, k < 3000 ? corner.position : -1);
  }
}

TEST_F(ObjTest, EveryFaceHasWhatItsMeshHas) {
  Mesh bare = *triangle();
  bare.normals.clear();
  bare.uvs.clear();
  Mesh with_uvs = *triangle();
  with_uvs.normals.clear();
  Mesh with_normals = *triangle();
  with_normals.uvs.clear();
  MeshScene scene = scene_of(triangle(), {Frame()});
  for (const Mesh& mesh : {bare, with_uvs, with_normals, *triangle()}) {
    scene.meshes.push_back({"leaf", std::make_shared<const Mesh>(mesh), 0, {Frame(), Frame()}});
  }
  const Obj obj = written(scene);
  ASSERT_EQ(obj.corners.size(), 27U);
  const auto expect_corner = [&](std::size_t face, long position, long uv, long normal) {
    EXPECT_EQ(obj.corners[3 * face].position, position) << face;
    EXPECT_EQ(obj.corners[3 * face].uv, uv) << face;
    EXPECT_EQ(obj.corners[3 * face].normal, normal) << face;
  };
  expect_corner(0, 0, 0, 0);
  expect_corner(2, 6, -1, -1);
  expect_corner(4, 12, 6, -1);
  expect_corner(6, 18, -1, 6);
  expect_corner(8, 24, 12, 12);
  EXPECT_EQ(obj.uvs.size(), 15U);
  EXPECT_EQ(obj.normals.size(), 15U);
}

TEST_F(ObjTest, ClosedBodiesKeepAreaAndVolumeHoweverTheyAreMirrored) {
  Frame frame = mirror();
  frame.axes[1] *= 2.0F;
  frame.origin = {1, 2, 3};
  const MeshScene scene = scene_of(std::make_shared<const Mesh>(make_cylinder(0.1, 2, 12)), {frame});
  const Mesh mesh = written(scene).mesh();
  EXPECT_TRUE(check_mesh(mesh));
  const Mesh expected = flattened(scene);
  EXPECT_NEAR(signed_volume(mesh), 2 * signed_volume(*scene.meshes[0].mesh), 1e-6);
  EXPECT_EQ(signed_volume(mesh), signed_volume(expected));
  EXPECT_EQ(surface_area(mesh), surface_area(expected));
}

TEST_F(ObjTest, VRisesAsOurs) { EXPECT_EQ(written(scene_of(triangle(), {Frame()})).uvs, triangle()->uvs); }

TEST_F(ObjTest, HasAnObjectAndAGroupAComponentAndTheMaterialOfEveryFace) {
  MeshScene scene = leafy_scene(2);
  scene.meshes.push_back({"stem", triangle(), 0, {Frame()}});
  const Obj obj = written(scene);
  EXPECT_EQ(obj.objects, (std::vector<std::string>{"leaf", "stem"}));
  EXPECT_EQ(obj.groups, obj.objects);
  ASSERT_EQ(obj.face_materials.size(), 5003U);
  EXPECT_EQ(obj.face_materials[1], "leaf");
  EXPECT_EQ(obj.face_materials[2], "stem");
  EXPECT_EQ(obj.face_materials[5002], "leaf");
}

TEST_F(ObjTest, NamesItsMaterialsByAFileBesideIt) {
  MeshScene scene = scene_of(triangle(), {Frame()});
  scene.materials[0].colour = {1, 0.5F, 0};
  scene.materials[0].roughness = 0.8F;
  scene.materials.emplace_back().name = "unused";
  EXPECT_EQ(written(scene).libraries, std::vector<std::string>{"plant.mtl"});
  auto materials = parse_materials(content_of(at("plant.mtl")));
  ASSERT_EQ(materials.size(), 1U);
  auto& leaf = materials.at("leaf");
  EXPECT_EQ(leaf["Kd"], (std::vector<float>{1, linear_from_srgb(Vec3(0.5F)).g, 0}));
  EXPECT_EQ(leaf["Pr"], std::vector<float>{0.8F});
  EXPECT_NEAR(leaf["Ns"].at(0), 40, 1e-3);
}

/// Returns the lines of an MTL that name pictures, from key to file.
std::map<std::string, std::string> maps_of(const std::string& text) {
  std::map<std::string, std::string> maps;
  std::istringstream lines(text);
  for (std::string key, rest; lines >> key && std::getline(lines >> std::ws, rest);) {
    if (key.starts_with("map_") || key == "norm") maps[key] = rest;
  }
  return maps;
}

MeshScene textured_scene() {
  MeshScene scene = scene_of(triangle(), {Frame()});
  scene.materials[0].texture = plain_texture();
  return scene;
}

TEST_F(ObjTest, WritesPicturesBesideItAndNamesThem) {
  MeshScene scene = textured_scene();
  scene.materials[0].name = "my/leaf";
  write(scene, "my oak.obj");
  const std::map<std::string, std::string> expected{{"map_Kd", "my_oak_my_leaf_colour.png"},
                                                    {"map_d", "my_oak_my_leaf_mask.png"},
                                                    {"map_Bump", "my_oak_my_leaf_normals.png"},
                                                    {"norm", "my_oak_my_leaf_normals.png"}};
  EXPECT_EQ(maps_of(content_of(at("my_oak.mtl"))), expected);
  const Texture& texture = *scene.materials[0].texture;
  EXPECT_EQ(pixels_of(at("my_oak_my_leaf_colour.png")), texture.colour.rgba);
  EXPECT_EQ(pixels_of(at("my_oak_my_leaf_normals.png")), texture.normals.rgba);
  const auto paths = picture_paths(at("my oak.obj"), "my/leaf");
  for (const std::string& path : paths) EXPECT_TRUE(fs::exists(path)) << path;
}

TEST_F(ObjTest, TheMaskHasTheAlphaInEveryChannel) {
  const MeshScene scene = textured_scene();
  write(scene);
  Image mask = scene.materials[0].texture->colour;
  for (std::size_t i = 0; i < mask.rgba.size(); ++i) mask.rgba[i] = mask.rgba[i / 4 * 4 + 3];
  EXPECT_EQ(pixels_of(at("plant_leaf_mask.png")), mask.rgba);
}

TEST_F(ObjTest, MaterialsOfOneTextureShareItsPictures) {
  MeshScene scene = textured_scene();
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].name = "other";
  scene.meshes.push_back(scene.meshes[0]);
  scene.meshes[1].material = 1;
  write(scene);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 5);
  EXPECT_FALSE(fs::exists(at("plant_other_colour.png")));
}

TEST_F(ObjTest, ComponentsWithTintsHaveVertexColours) {
  MeshScene scene = leafy_scene(2);
  EXPECT_TRUE(written(scene).colours.empty());
  scene.meshes[0].tints = {{1, 0.5F, 0.25F}, {0.5F, 1, 1}};
  const Obj obj = written(scene);
  ASSERT_EQ(obj.colours.size(), 6U);
  auto materials = parse_materials(content_of(at("plant.mtl")));
  const std::vector<float> base = materials.at("leaf")["Kd"];
  for (std::size_t v = 0; v < 6; ++v) {
    const Vec3 light = Vec3(base[0], base[1], base[2]) * linear_from_srgb(obj.colours[v]);
    EXPECT_LT(glm::length(light - scene.materials[0].tint() * scene.meshes[0].tints[v / 3]), 1e-3F) << v;
  }
}

TEST_F(ObjTest, AFullDiskLeavesNoPictures) {
  const FileSizeLimit limit(60);
  EXPECT_THROW(write(textured_scene()), MachineError);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(ObjTest, NamesWithSpacesAndLineEndsStayWords) {
  MeshScene scene = leafy_scene(1);
  scene.materials[0].name = scene.meshes[0].component = "my\nleaf # 1";
  scene.materials[1].name = scene.meshes[1].component = "my leaf_# 1";
  write(scene, "my oak.obj");
  const Obj obj = parse(content_of(at("my oak.obj")));
  EXPECT_EQ(obj.libraries, std::vector<std::string>{"my_oak.mtl"});
  EXPECT_EQ(obj.groups, (std::vector<std::string>{"my_leaf___1", "my_leaf___1_2"}));
  EXPECT_EQ(obj.face_materials[0], "my_leaf___1");
  EXPECT_EQ(obj.face_materials[1], "my_leaf___1_2");
  EXPECT_EQ(parse_materials(content_of(at("my_oak.mtl"))).count("my_leaf___1_2"), 1U);
}

TEST(Obj, MaterialPathEndsInMtl) {
  EXPECT_EQ(material_path("a.b/oak.obj"), "a.b/oak.mtl");
  EXPECT_EQ(material_path("oak.OBJ"), "oak.mtl");
  EXPECT_EQ(material_path("my folder/my oak.obj"), "my folder/my_oak.mtl");
  EXPECT_EQ(material_path("oak.mtl"), "oak.mtl.mtl");
  EXPECT_EQ(material_path("oak"), "oak.mtl");
  EXPECT_EQ(material_path(".obj"), ".obj.mtl");
}

TEST_F(ObjTest, SaysWhereThePlantCameFromAndItsUnits) {
  Progress progress;
  write_obj(leafy_scene(1), at("plant.obj"), {{"Oak\nv 1 2 3", "A. Author", "CC0-1.0", 7, "1.2.3"}}, progress);
  for (const char* name : {"plant.obj", "plant.mtl"}) {
    EXPECT_EQ(content_of(at(name)).rfind("# Meristem 1.2.3\n# name: Oak v 1 2 3\n# author: A. Author\n"
                                         "# licence: CC0-1.0\n# seed: 7\n",
                                         0),
              0U);
    EXPECT_NE(content_of(at(name)).find("# units: metres, y up\n"), std::string::npos);
  }
}

TEST_F(ObjTest, AnEmptySceneIsAFileWithoutFaces) {
  const Obj obj = written({});
  EXPECT_TRUE(obj.positions.empty());
  EXPECT_TRUE(obj.corners.empty());
  EXPECT_TRUE(fs::exists(at("plant.mtl")));
}

TEST_F(ObjTest, StandardOutputHasNoMaterialFile) {
  Progress progress;
  testing::internal::CaptureStdout();
  write_obj(leafy_scene(2), "-", {}, progress);
  const Obj obj = parse(testing::internal::GetCapturedStdout());
  EXPECT_EQ(obj.face_materials.size(), 5002U);
  EXPECT_EQ(obj.face_materials[0], "leaf");
  EXPECT_TRUE(obj.libraries.empty());
  EXPECT_FALSE(fs::exists("-.mtl"));
}

TEST_F(ObjTest, HasTheSameBytesOnAnyNumberOfThreads) {
  const MeshScene scene = leafy_scene(40'000);
  const auto bytes = [&](int threads) {
    const ThreadLimit limit(threads);
    write(scene);
    return content_of(at("plant.obj"));
  };
  const std::string expected = bytes(1);
  for (const int threads : {2, 3, 8}) EXPECT_TRUE(bytes(threads) == expected) << threads << " threads";
}

TEST_F(ObjTest, AFullDiskLeavesNeitherFile) {
  // Tests sizes that fit into the buffers until the file is closed, and sizes that do not.
  for (const std::size_t leaves : {1, 20'000}) {
    const FileSizeLimit limit(1000);
    EXPECT_THROW(write(leafy_scene(leaves)), MachineError);
    EXPECT_TRUE(fs::is_empty(folder_));
  }
  Progress progress;
  EXPECT_THROW(write_obj(leafy_scene(1), "/dev/full", {}, progress), MachineError);
}

TEST_F(ObjTest, ARefusedPathLeavesNeitherFile) {
  EXPECT_THROW(write(leafy_scene(1), "none/plant.obj"), MachineError);
  fs::create_directory(at("plant.mtl"));
  EXPECT_THROW(write(leafy_scene(1)), MachineError);
  EXPECT_FALSE(fs::exists(at("plant.obj")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(ObjTest, OnlyARefusedLastRenameLeavesTheMaterials) {
  // While the file is being written, a folder with the name of the file appears.
  Progress progress([&](std::string_view, double fraction) {
    if (fraction > 0.5) fs::create_directory(at("plant.obj"));
  });
  EXPECT_THROW(write_obj(leafy_scene(10), at("plant.obj"), {}, progress), MachineError);
  EXPECT_TRUE(fs::is_directory(at("plant.obj")));
  EXPECT_TRUE(fs::exists(at("plant.mtl")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);
}

TEST_F(ObjTest, LeavesNothingWhenCancelled) {
  Progress* self = nullptr;
  Progress progress([&](std::string_view, double fraction) {
    if (fraction > 0.5) self->cancel();
  });
  self = &progress;
  EXPECT_THROW(write_obj(leafy_scene(100'000), at("plant.obj"), {}, progress), Cancelled);
  EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace meristem::obj_test
