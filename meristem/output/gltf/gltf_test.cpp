// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/gltf/gltf.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "tests/support/read_glb.h"
#include "tests/support/sample_scenes.h"

namespace meristem::gltf_test {

using Json = nlohmann::json;

Glb written(const MeshScene& scene, const GltfOptions& options = {}) { return written_glb(scene, options); }

std::string temporary_path(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return testing::TempDir() + "gltf_" + test->name() + "_" + name + ".glb";
}

TEST(Gltf, SaysWhereThePlantCameFrom) {
  GltfOptions options;
  options.provenance = {"Oak", "A. Author", "CC-BY-4.0", 18446744073709551615U, "1.2.3"};
  const Json json = written(scene_of(triangle(), {Frame()}), options).json;
  EXPECT_EQ(json["asset"]["version"], "2.0");
  EXPECT_EQ(json["asset"]["generator"], "Meristem 1.2.3");
  EXPECT_EQ(json["asset"]["copyright"], "A. Author, CC-BY-4.0");
  const Json extras{{"name", "Oak"},
                    {"seed", 18446744073709551615U},
                    {"version", "1.2.3"},
                    {"author", "A. Author"},
                    {"licence", "CC-BY-4.0"}};
  EXPECT_EQ(json["asset"]["extras"], extras);
  EXPECT_EQ(json["scenes"][0]["extras"], extras);
}

TEST(Gltf, SaysWhichValuesWereSetForThePlant) {
  GltfOptions options;
  options.provenance.sets = {"age=20", "leaf.length=[0.1,0.2]"};
  const Json json = written(scene_of(triangle(), {Frame()}), options).json;
  EXPECT_EQ(json["asset"]["extras"]["set"], Json({"age=20", "leaf.length=[0.1,0.2]"}));
}

TEST(Gltf, AnEmptySceneHasNeitherNodesNorBuffers) {
  const Glb glb = written(scene_of(triangle(), {}));
  EXPECT_EQ(glb.json["scenes"].size(), 1U);
  EXPECT_FALSE(glb.json.contains("nodes"));
  EXPECT_FALSE(glb.json.contains("buffers"));
  EXPECT_TRUE(glb.binary.empty());
}

TEST(Gltf, WritesVerticesNormalsAndUvsWithVDownward) {
  const Glb glb = written(scene_of(triangle(), {Frame()}));
  const Json& primitive = glb.json["meshes"][0]["primitives"][0];
  EXPECT_EQ(glb.values<Vec3>(glb.accessor(primitive, "POSITION")), triangle()->positions);
  EXPECT_EQ(glb.values<Vec3>(glb.accessor(primitive, "NORMAL")), triangle()->normals);
  EXPECT_EQ(glb.values<Vec2>(glb.accessor(primitive, "TEXCOORD_0")), (std::vector<Vec2>{{0, 1}, {1, 1}, {0.25F, 0}}));
  EXPECT_EQ(glb.values<std::uint16_t>(glb.indices(primitive)), (std::vector<std::uint16_t>{0, 1, 2}));
}

TEST(Gltf, WritesLinearColours) {
  MeshScene scene = scene_of(triangle(), {Frame()});
  scene.materials[0].colour = {1, 0.5F, 0};
  scene.materials[0].roughness = 0.8F;
  scene.materials[0].two_sided = true;
  const Json material = written(scene).json["materials"][0];
  const Json& factor = material["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_EQ(factor[0], 1.0);
  EXPECT_NEAR(factor[1].get<double>(), std::pow((0.5 + 0.055) / 1.055, 2.4), 1e-7);
  EXPECT_EQ(factor[2], 0.0);
  EXPECT_EQ(factor[3], 1);
  EXPECT_EQ(material["pbrMetallicRoughness"]["metallicFactor"], 0);
  EXPECT_EQ(material["pbrMetallicRoughness"]["roughnessFactor"], 0.8);
  EXPECT_EQ(material["doubleSided"], true);
}

TEST(Gltf, BoundsEqualTheExtremesOfWhatIsWritten) {
  const Glb glb = written(leafy_scene(1000));
  ASSERT_EQ(glb.json["meshes"].size(), 2U);
  for (const Json& mesh : glb.json["meshes"]) {
    const Json& accessor = glb.accessor(mesh["primitives"][0], "POSITION");
    Box box;
    for (const Vec3 position : glb.values<Vec3>(accessor)) box.add(position);
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(accessor["min"][c].get<double>(), box.low[c]);
      EXPECT_EQ(accessor["max"][c].get<double>(), box.high[c]);
    }
  }
}

TEST(Gltf, ArraysAreAlignedAndFillTheBuffer) {
  const Glb glb = written(leafy_scene(7));  // 21 vertices, 7 triangles: 42 bytes of indices
  std::uint64_t end = 0;
  for (const Json& view : glb.json["bufferViews"]) {
    const auto offset = view["byteOffset"].get<std::uint64_t>();
    EXPECT_EQ(offset, (end + 3) / 4 * 4);
    end = offset + view["byteLength"].get<std::uint64_t>();
  }
  EXPECT_EQ(glb.binary.size(), (end + 3) / 4 * 4);
}

TEST(Gltf, OneNodeAComponentWithItsNameAndAPrimitiveAMaterial) {
  MeshScene scene = leafy_scene(10);
  scene.meshes.push_back({"leaf", triangle(), 1, {shifted({1, 2, 3})}});
  const Json json = written(scene).json;
  ASSERT_EQ(json["nodes"].size(), 2U);
  EXPECT_EQ(json["nodes"][0]["name"], "leaf");
  EXPECT_EQ(json["nodes"][1]["name"], "stem");
  EXPECT_EQ(json["scenes"][0]["nodes"], Json({0, 1}));
  EXPECT_EQ(json["meshes"][0]["primitives"].size(), 2U);
  EXPECT_EQ(json["materials"].size(), 2U);
}

TEST(Gltf, LeavesOutMaterialsThatNothingUses) {
  MeshScene scene = scene_of(triangle(), {Frame()});
  Material other;
  other.name = "other";
  scene.materials.insert(scene.materials.begin(), other);
  scene.meshes[0].material = 1;
  const Json json = written(scene).json;
  ASSERT_EQ(json["materials"].size(), 1U);
  EXPECT_EQ(json["materials"][0]["name"], "leaf");
  EXPECT_EQ(json["meshes"][0]["primitives"][0]["material"], 0);
}

TEST(Gltf, BakedMirrorsKeepTheirFrontOutside) {
  const Glb glb = written(scene_of(triangle(), {Frame(), mirror(), sheared()}));
  const Json& primitive = glb.json["meshes"][0]["primitives"][0];
  const auto positions = glb.values<Vec3>(glb.accessor(primitive, "POSITION"));
  const auto normals = glb.values<Vec3>(glb.accessor(primitive, "NORMAL"));
  const auto indices = glb.values<std::uint16_t>(glb.indices(primitive));
  ASSERT_EQ(indices.size(), 9U);
  for (std::size_t t = 0; t < 9; t += 3) {
    const Vec3 a = positions[indices[t]];
    const Vec3 face = glm::cross(positions[indices[t + 1]] - a, positions[indices[t + 2]] - a);
    EXPECT_GT(glm::dot(face, normals[indices[t]]), 0) << t;
  }
}

TEST(Gltf, IndicesWidenPast65535Vertices) {
  const auto component_type = [](std::uint32_t triangles) {
    const Glb glb = written(scene_of(strip(triangles), {Frame()}));
    return glb.indices(glb.json["meshes"][0]["primitives"][0])["componentType"].get<int>();
  };
  EXPECT_EQ(component_type(65533), 5123);
  EXPECT_EQ(component_type(65534), 5125);
}

TEST(Gltf, WideIndicesReachEveryInstance) {
  const Glb glb = written(scene_of(triangle(), std::vector<Frame>(30000)));
  const auto indices = glb.values<std::uint32_t>(glb.indices(glb.json["meshes"][0]["primitives"][0]));
  ASSERT_EQ(indices.size(), 90000U);
  for (std::uint32_t i = 0; i < indices.size(); ++i) ASSERT_EQ(indices[i], i);
}

TEST(Gltf, PastTheFlatteningLimitInstancesAreRows) {
  GltfOptions options;
  options.flatten_triangles = 5999;
  const MeshScene scene = leafy_scene(1000);
  const Glb glb = written(scene, options);
  ASSERT_EQ(glb.json["nodes"].size(), 4U);  // leaf and stem, and the leaves both plain and mirrored
  int rows = 0;
  for (const int node : {2, 3}) {
    const Json& attributes = glb.json["nodes"][node]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    rows += glb.accessor(attributes["TRANSLATION"])["count"].get<int>();
  }
  EXPECT_EQ(rows, 1000);
  options.flatten_triangles = 6000;
  EXPECT_EQ(written(scene, options).json["nodes"].size(), 2U);
}

TEST(Gltf, PastTheFlatteningLimitNodesShareMeshesWhereAskedFor) {
  GltfOptions options{.instances = GltfInstances::nodes};
  options.flatten_triangles = 5999;
  const MeshScene scene = leafy_scene(1000);
  const Glb glb = written(scene, options);
  ASSERT_EQ(glb.json["nodes"].size(), 1002U);
  const Json& leaf = glb.json["nodes"][0];
  EXPECT_EQ(leaf["name"], "leaf");
  EXPECT_FALSE(leaf.contains("mesh"));
  ASSERT_EQ(leaf["children"].size(), 1000U);
  for (std::size_t i = 0; i < 1000; ++i) {
    const Json& node = glb.json["nodes"][leaf["children"][i].get<std::size_t>()];
    const Frame& frame = scene.meshes[0].frames[i];
    EXPECT_EQ(node["mesh"], 0);
    EXPECT_EQ(node["matrix"][4].get<float>(), frame.axes[1].x);
    EXPECT_EQ(node["matrix"][13].get<float>(), frame.origin.y);
  }
  EXPECT_EQ(glb.accessor(glb.json["meshes"][0]["primitives"][0], "POSITION")["count"], 3);
  EXPECT_TRUE(glb.json["nodes"][1].contains("mesh"));
  EXPECT_FALSE(glb.json["nodes"][1].contains("matrix"));

  options.flatten_triangles = 6000;
  EXPECT_EQ(written(scene, options).json["nodes"].size(), 2U);
}

TEST(Gltf, BakesWhatNoNodeCanExpress) {
  GltfOptions options{.instances = GltfInstances::nodes};
  options.flatten_triangles = 0;
  Frame flat;
  flat.axes[2] = Vec3(0);
  const Glb glb = written(scene_of(triangle(), {shifted({1, 0, 0}), sheared(), flat, mirror()}), options);
  const Json& parent = glb.json["nodes"][0];
  EXPECT_EQ(parent["children"].size(), 2U);
  const Json& baked = glb.json["meshes"][parent["mesh"].get<int>()]["primitives"][0];
  EXPECT_EQ(glb.accessor(baked, "POSITION")["count"], 6);
}

TEST(Gltf, HasTheSameBytesOnAnyNumberOfThreads) {
  for (const std::uint64_t flatten : {0, 5'000'000}) {
    GltfOptions options{.instances = GltfInstances::nodes};
    options.flatten_triangles = flatten;
    const MeshScene scene = leafy_scene(40000);
    const std::string expected = [&] {
      const ThreadLimit limit(1);
      return glb_bytes(scene, options);
    }();
    for (const int threads : {2, 3, 8}) {
      const ThreadLimit limit(threads);
      EXPECT_TRUE(glb_bytes(scene, options) == expected) << threads << " threads";
    }
  }
}

TEST(Gltf, RefusesWhatDoesNotFitTheFormat) {
  const std::string path = temporary_path("huge");
  Progress progress;
  GltfOptions options;
  options.flatten_triangles = UINT64_MAX;
  try {
    write_glb(scene_of(strip(20000), std::vector<Frame>(20000)), path, options, progress);
    FAIL() << "9.6 GB were not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("9.6 GB"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Gltf, ReportsAFullDisk) {
  Progress progress;
  EXPECT_THROW(write_glb(leafy_scene(1000), "/dev/full", {}, progress), MachineError);
}

TEST(Gltf, ReportsARefusedPath) {
  Progress progress;
  EXPECT_THROW(write_glb(leafy_scene(10), "/nonexistent/plant.glb", {}, progress), MachineError);
}

TEST(Gltf, LeavesNothingWhenCancelled) {
  const std::string directory = testing::TempDir() + "gltf_cancelled/";
  std::filesystem::create_directory(directory);
  // The observer stops the writer in the middle, after a part of the file was written to disk.
  Progress* self = nullptr;
  Progress progress([&](std::string_view, double fraction) {
    if (fraction > 0.5) self->cancel();
  });
  self = &progress;
  EXPECT_THROW(write_glb(leafy_scene(400'000), directory + "plant.glb", {}, progress), Cancelled);
  EXPECT_TRUE(std::filesystem::is_empty(directory));
  std::filesystem::remove(directory);
}

}  // namespace meristem::gltf_test
