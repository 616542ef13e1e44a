// SPDX-License-Identifier: Apache-2.0
// Textures, tints and instances in binary glTF.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/colour.h"
#include "meristem/base/parallel.h"
#include "meristem/output/gltf/gltf.h"
#include "meristem/output/write/png.h"
#include "tests/support/read_glb.h"
#include "tests/support/sample_scenes.h"

namespace meristem::gltf_looks_test {

using Json = nlohmann::json;
using Bytes4 = std::array<std::uint8_t, 4>;

constexpr const char* kTransmission = "KHR_materials_diffuse_transmission";
constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

MeshScene textured_scene(std::vector<Frame> frames = {Frame()}) {
  MeshScene scene = scene_of(triangle_with_tangents(), std::move(frames));
  scene.materials[0].colour = Vec3(0.5F);
  scene.materials[0].texture = plain_texture();
  return scene;
}

/// Returns many leaves, each with its own tint.
MeshScene tinted_scene(std::size_t leaves) {
  const RandomKey key(9);
  MeshScene scene = leafy_scene(leaves);
  for (std::size_t i = 0; i < leaves; ++i) {
    scene.meshes[0].tints.emplace_back(key.child(0).uniform(i, 0.5, 1.5), key.child(1).uniform(i, 0.5, 1.5), 1);
  }
  return scene;
}

Vec3 vec3(const Json& json) { return {json[0].get<float>(), json[1].get<float>(), json[2].get<float>()}; }

Vec3 linear(Bytes4 bytes) { return Vec3(bytes[0], bytes[1], bytes[2]) / 255.0F; }

TEST(GltfLooks, ALowerOpacityIsBlended) {
  MeshScene scene = textured_scene();
  EXPECT_EQ(written_glb(scene).json["materials"][0]["alphaMode"], "MASK");
  scene.materials[0].opacity = 0.4F;
  const Glb glb = written_glb(scene);
  const Json& material = glb.json["materials"][0];
  EXPECT_EQ(material["alphaMode"], "BLEND");
  EXPECT_FALSE(material.contains("alphaCutoff"));
  EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorFactor"][3], 0.4);
}

TEST(GltfLooks, PicturesAreTheFilesThatPngWrites) {
  const MeshScene scene = textured_scene();
  const Glb glb = written_glb(scene);
  ASSERT_EQ(glb.json["images"].size(), 2U);
  for (const Json& image : glb.json["images"]) EXPECT_EQ(image["mimeType"], "image/png");
  const Json& material = glb.json["materials"][0];
  const auto picture = [&](const Json& use) {
    const Json& texture = glb.json["textures"][use["index"].get<int>()];
    EXPECT_EQ(glb.json["samplers"][texture["sampler"].get<int>()]["wrapS"], 10497);
    return glb.bytes_of(glb.view(glb.json["images"][texture["source"].get<int>()]["bufferView"]));
  };
  const Texture& texture = *scene.materials[0].texture;
  EXPECT_EQ(picture(material["pbrMetallicRoughness"]["baseColorTexture"]),
            encode_png(texture.colour, PixelKind::srgb, PngPacking::quick));
  EXPECT_EQ(picture(material["normalTexture"]), encode_png(texture.normals, PixelKind::numbers, PngPacking::quick));
}

TEST(GltfLooks, TheFactorBringsTheTexturesMeanToTheMaterialsColour) {
  const Json material = written_glb(textured_scene()).json["materials"][0];
  const Vec3 factor = vec3(material["pbrMetallicRoughness"]["baseColorFactor"]);
  EXPECT_LT(glm::length(factor * 0.5F - linear_from_srgb(Vec3(0.5F))), 1e-6F);
  EXPECT_EQ(material["alphaMode"], "MASK");
  EXPECT_EQ(material["alphaCutoff"], 0.5);
}

TEST(GltfLooks, TexturesWithoutMaskOrNormalsSayNothingOfThem) {
  MeshScene scene = textured_scene();
  Texture plain = *plain_texture();
  plain.masked = false;
  plain.normals = {};
  scene.materials[0].texture = std::make_shared<const Texture>(plain);
  const Json json = written_glb(scene).json;
  EXPECT_FALSE(json["materials"][0].contains("alphaMode"));
  EXPECT_FALSE(json["materials"][0].contains("normalTexture"));
  EXPECT_FALSE(json["meshes"][0]["primitives"][0]["attributes"].contains("TANGENT"));
  EXPECT_EQ(json["images"].size(), 1U);
}

TEST(GltfLooks, MaterialsOfOneTextureShareItsPictures) {
  MeshScene scene = textured_scene();
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].name = "other";
  scene.materials[1].colour = Vec3(0.3F);
  scene.meshes.push_back(scene.meshes[0]);
  scene.meshes[1].material = 1;
  const Json json = written_glb(scene).json;
  EXPECT_EQ(json["materials"].size(), 2U);
  EXPECT_EQ(json["images"].size(), 2U);
  EXPECT_EQ(json["materials"][0]["normalTexture"], json["materials"][1]["normalTexture"]);
}

TEST(GltfLooks, AMeshWithoutUvsWearsTheTexturesMean) {
  MeshScene scene = textured_scene();
  scene.meshes[0].mesh = strip(3);
  const Json json = written_glb(scene).json;
  EXPECT_FALSE(json.contains("images"));
  const Vec3 factor = vec3(json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"]);
  EXPECT_LT(glm::length(factor - linear_from_srgb(Vec3(0.5F))), 1e-6F);
}

TEST(GltfLooks, TangentsKeepTheirSideAndMirrorsChangeIt) {
  Frame stretched{rotation(Vec3(0, 1, 0), kPi), Vec3(0)};
  stretched.axes[1] *= 3.0F;
  const Glb glb = written_glb(textured_scene({Frame(), mirror(), stretched}));
  const Json& primitive = glb.json["meshes"][0]["primitives"][0];
  const auto tangents = glb.values<Vec4>(glb.accessor(primitive, "TANGENT"));
  ASSERT_EQ(tangents.size(), 9U);
  EXPECT_EQ(tangents[0], Vec4(1, 0, 0, 1));
  EXPECT_EQ(tangents[3], Vec4(-1, 0, 0, -1));
  EXPECT_LT(glm::length(tangents[6] - Vec4(-1, 0, 0, 1)), 1e-6F);
}

TEST(GltfLooks, LightPassesThroughTwoSidedLeavesOnly) {
  MeshScene scene = textured_scene();
  scene.materials[0].translucency = 0.25F;
  EXPECT_FALSE(written_glb(scene).json.contains("extensionsUsed"));
  scene.materials[0].two_sided = true;
  const Json json = written_glb(scene).json;
  EXPECT_EQ(json["extensionsUsed"], Json({kTransmission}));
  EXPECT_FALSE(json.contains("extensionsRequired"));
  const Json& transmission = json["materials"][0]["extensions"][kTransmission];
  EXPECT_EQ(transmission["diffuseTransmissionFactor"], 0.25);
  EXPECT_EQ(transmission["diffuseTransmissionColorTexture"],
            json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]);
}

TEST(GltfLooks, VertexColoursTimesFactorAreTheTintedColour) {
  const MeshScene scene = tinted_scene(100);
  const Glb glb = written_glb(scene);
  const Json& leaf = glb.json["meshes"][0]["primitives"][0];
  const Vec3 base = vec3(glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"]);
  const auto colours = glb.values<Bytes4>(glb.accessor(leaf, "COLOR_0"));
  ASSERT_EQ(colours.size(), 300U);
  EXPECT_EQ(glb.accessor(leaf, "COLOR_0")["normalized"], true);
  for (std::size_t i = 0; i < 100; ++i) {
    const Vec3 expected = scene.materials[0].tint() * scene.meshes[0].tints[i];
    for (std::size_t v = 3 * i; v < 3 * i + 3; ++v) {
      EXPECT_LT(glm::length(base * linear(colours[v]) - expected), 0.005F);
      EXPECT_EQ(colours[v][3], 255);
    }
  }
  EXPECT_FALSE(glb.json["meshes"][1]["primitives"][0]["attributes"].contains("COLOR_0"));
}

TEST(GltfLooks, WhereNodesShareMeshesAFewMaterialsStandForTheTints) {
  GltfOptions options{.instances = GltfInstances::nodes};
  options.flatten_triangles = 0;
  const MeshScene scene = tinted_scene(500);
  const Glb glb = written_glb(scene, options);
  ASSERT_EQ(glb.json["materials"].size(), 9U);
  EXPECT_EQ(glb.json["nodes"][0]["children"].size(), 500U);
  // The colour of every leaf is approximated, and the mean colour of all leaves is kept.
  DVec3 sum(0);
  DVec3 expected(0);
  for (std::size_t i = 0; i < 500; ++i) expected += DVec3(scene.materials[0].tint() * scene.meshes[0].tints[i]);
  for (const Json& child : glb.json["nodes"][0]["children"]) {
    const Json& mesh = glb.json["meshes"][glb.json["nodes"][child.get<int>()]["mesh"].get<int>()];
    const Json& material = glb.json["materials"][mesh["primitives"][0]["material"].get<int>()];
    sum += DVec3(vec3(material["pbrMetallicRoughness"]["baseColorFactor"]));
  }
  EXPECT_LT(glm::length(sum - expected), 1e-4 * glm::length(expected));
}

/// Returns the matrix of one row of a node's instances.
Frame row_frame(const Glb& glb, const Json& attributes, std::size_t row) {
  const Vec3 t = glb.values<Vec3>(glb.accessor(attributes["TRANSLATION"])).at(row);
  const Vec4 q = glb.values<Vec4>(glb.accessor(attributes["ROTATION"])).at(row);
  const Vec3 s = glb.values<Vec3>(glb.accessor(attributes["SCALE"])).at(row);
  EXPECT_NEAR(glm::length(q), 1, 1e-6);
  const Vec3 u(q);
  const auto turned = [&](Vec3 v) { return v + 2.0F * glm::cross(u, glm::cross(u, v) + q.w * v); };
  return {Mat3(s.x * turned({1, 0, 0}), s.y * turned({0, 1, 0}), s.z * turned({0, 0, 1})), t};
}

TEST(GltfLooks, RowsPlaceEveryInstanceWhereItsFrameDoes) {
  GltfOptions options;
  options.instances = GltfInstances::rows;
  const MeshScene scene = tinted_scene(300);
  const Glb glb = written_glb(scene, options);
  EXPECT_EQ(glb.json["extensionsUsed"], Json({kInstancing}));
  const Json& children = glb.json["nodes"][0]["children"];
  ASSERT_EQ(children.size(), 2U);  // plain and mirrored
  const std::vector<Frame>& frames = scene.meshes[0].frames;
  std::size_t found = 0;
  for (const bool mirrored : {false, true}) {
    const Json& node = glb.json["nodes"][children[mirrored ? 1 : 0].get<int>()];
    const Json& attributes = node["extensions"][kInstancing]["attributes"];
    const Json& primitive = glb.json["meshes"][node["mesh"].get<int>()]["primitives"][0];
    const auto positions = glb.values<Vec3>(glb.accessor(primitive, "POSITION"));
    const auto colours = glb.values<Bytes4>(glb.accessor(attributes["_COLOR_0"]));
    const Vec3 base =
        vec3(glb.json["materials"][primitive["material"].get<int>()]["pbrMetallicRoughness"]["baseColorFactor"]);
    std::size_t row = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      if ((i % 3 == 0) != mirrored) continue;
      const Frame frame = row_frame(glb, attributes, row);
      for (std::size_t v = 0; v < 3; ++v) {
        const Vec3 expected = frames[i].point(triangle()->positions[v]);
        EXPECT_LT(glm::length(frame.point(positions[v]) - expected), 2e-5F) << i;
      }
      EXPECT_LT(glm::length(base * linear(colours[row]) - scene.materials[0].tint() * scene.meshes[0].tints[i]),
                0.005F);
      ++row;
      ++found;
    }
  }
  EXPECT_EQ(found, 300U);
}

TEST(GltfLooks, InstancedFilesBakeShearsAndAreSmall) {
  GltfOptions options;
  options.instances = GltfInstances::rows;
  std::vector<Frame> frames(1000, shifted({1, 2, 3}));
  frames[7] = sheared();
  const Glb glb = written_glb(scene_of(strip(1000), frames), options);
  const Json& component = glb.json["nodes"][0];
  EXPECT_EQ(glb.accessor(glb.json["meshes"][component["mesh"].get<int>()]["primitives"][0], "POSITION")["count"], 1002);
  EXPECT_LT(glb.bytes.size(), 100'000U);
}

TEST(GltfLooks, HaveTheSameBytesOnAnyNumberOfThreads) {
  MeshScene scene = tinted_scene(20'000);
  scene.materials[0].texture = plain_texture();
  scene.meshes[0].mesh = triangle_with_tangents();
  for (const int mode : {0, 1, 2}) {
    GltfOptions options;
    if (mode == 1) options.instances = GltfInstances::rows;
    if (mode == 2) options = {.instances = GltfInstances::nodes, .flatten_triangles = 0};
    const auto bytes = [&](int threads) {
      const ThreadLimit limit(threads);
      return glb_bytes(scene, options);
    };
    const std::string expected = bytes(1);
    for (const int threads : {2, 3, 8}) EXPECT_TRUE(bytes(threads) == expected) << threads << " threads";
  }
}

}  // namespace meristem::gltf_looks_test
