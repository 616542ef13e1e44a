// SPDX-License-Identifier: Apache-2.0
// Several plants in one file: a root, and below it one node per plant.
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "meristem/output/gltf/gltf.h"
#include "tests/support/read_glb.h"
#include "tests/support/sample_scenes.h"

namespace meristem::gltf_plants_test {

using Json = nlohmann::json;

constexpr std::size_t kLeaves = 300;

/// Returns three plants. Leaves alternate between the plants, and the stem's mesh belongs to the last plant.
MeshScene three_plants() {
  MeshScene scene = leafy_scene(kLeaves);
  scene.individuals = {{"bush", 0, {-5, 0, 0}}, {"bush", 1, {0, 0, 0}}, {"tree", 0, {5, 1, 0}}};
  for (std::size_t i = 0; i < kLeaves; ++i) scene.meshes[0].individuals.push_back(static_cast<std::uint32_t>(i % 3));
  scene.meshes[1].individuals = {2};
  return scene;
}

Vec3 vec3(const Json& json) { return {json[0].get<float>(), json[1].get<float>(), json[2].get<float>()}; }

/// Returns the node of a plant by its name.
const Json& node_named(const Json& json, const std::string& name) {
  const auto found = std::find_if(json["nodes"].begin(), json["nodes"].end(),
                                  [&](const Json& node) { return node.value("name", "") == name; });
  EXPECT_NE(found, json["nodes"].end()) << name;
  return *found;
}

TEST(GltfPlants, StandUnderOneRootWithTheirComponentsBelow) {
  GltfOptions options;
  options.provenance.name = "Hedge";
  const Json json = written_glb(three_plants(), options).json;
  ASSERT_EQ(json["scenes"][0]["nodes"], Json::array({0}));
  EXPECT_EQ(json["nodes"][0]["name"], "Hedge");
  EXPECT_EQ(json["nodes"][0]["children"], Json({1, 2, 3}));
  EXPECT_EQ(json["nodes"][1]["name"], "bush 0");
  EXPECT_EQ(vec3(json["nodes"][1]["translation"]), Vec3(-5, 0, 0));
  EXPECT_FALSE(json["nodes"][2].contains("translation"));
  const Json& tree = node_named(json, "tree 0");
  ASSERT_EQ(tree["children"].size(), 2U);
  EXPECT_EQ(json["nodes"][tree["children"][0].get<int>()]["name"], "leaf");
  EXPECT_EQ(json["nodes"][tree["children"][1].get<int>()]["name"], "stem");
  EXPECT_EQ(node_named(json, "bush 1")["children"].size(), 1U);
}

TEST(GltfPlants, BakedVerticesStandAtTheirPlantsFoot) {
  const MeshScene scene = three_plants();
  const Glb glb = written_glb(scene);
  std::size_t triangles = 0;
  for (std::size_t plant = 0; plant < 3; ++plant) {
    const Json& node = glb.json["nodes"][1 + plant];
    const Json& leaf = glb.json["nodes"][node["children"][0].get<int>()];
    const Json& primitive = glb.json["meshes"][leaf["mesh"].get<int>()]["primitives"][0];
    const auto positions = glb.values<Vec3>(glb.accessor(primitive, "POSITION"));
    ASSERT_EQ(positions.size(), kLeaves);  // a third of the leaves, with three corners each
    for (std::size_t k = 0; k < positions.size(); ++k) {
      const Vec3 expected = scene.meshes[0].frames[plant + 3 * (k / 3)].point(triangle()->positions[k % 3]);
      ASSERT_LT(glm::distance(positions[k] + scene.individuals[plant].foot, expected), 1e-5F);
    }
    for (const Json& child : node["children"]) {
      const Json& mesh = glb.json["meshes"][glb.json["nodes"][child.get<int>()]["mesh"].get<int>()];
      for (const Json& part : mesh["primitives"]) triangles += glb.indices(part)["count"].get<std::size_t>() / 3;
    }
  }
  EXPECT_EQ(triangles, scene.triangle_count());
}

TEST(GltfPlants, ShareOneMeshWhereInstancesAreRowsOrNodes) {
  for (const GltfInstances kind : {GltfInstances::rows, GltfInstances::nodes}) {
    GltfOptions options{.instances = kind};
    options.flatten_triangles = 0;
    const MeshScene scene = three_plants();
    const Glb glb = written_glb(scene, options);
    std::set<int> meshes;
    std::size_t instances = 0;
    for (std::size_t plant = 0; plant < 3; ++plant) {
      const Json& leaf = glb.json["nodes"][glb.json["nodes"][1 + plant]["children"][0].get<int>()];
      for (const Json& child : leaf["children"]) {
        const Json& node = glb.json["nodes"][child.get<int>()];
        meshes.insert(node["mesh"].get<int>());
        if (kind == GltfInstances::nodes) {
          const Json& m = node["matrix"];
          const Vec3 found(m[12].get<float>(), m[13].get<float>(), m[14].get<float>());
          const bool is_one = std::any_of(scene.meshes[0].frames.begin(), scene.meshes[0].frames.end(), [&](Frame f) {
            return glm::distance(f.origin, found + scene.individuals[plant].foot) < 1e-5F;
          });
          EXPECT_TRUE(is_one) << found.x;
          ++instances;
        } else {
          const Json& rows = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"];
          instances += glb.accessor(rows)["count"].get<std::size_t>();
        }
      }
    }
    EXPECT_EQ(instances, kLeaves);
    EXPECT_EQ(meshes.size(), kind == GltfInstances::rows ? 2U : 1U);  // plain and mirrored
  }
}

TEST(GltfPlants, WhatBelongsToNoneStandsBesideThem) {
  MeshScene scene = three_plants();
  scene.meshes[1].individuals = {kNoIndividual};
  const Json json = written_glb(scene).json;
  // The tree has only its leaves, and the stem is the root's last child.
  EXPECT_EQ(node_named(json, "tree 0")["children"].size(), 1U);
  ASSERT_EQ(json["nodes"][0]["children"].size(), 4U);
  EXPECT_EQ(json["nodes"][json["nodes"][0]["children"][3].get<int>()]["name"], "stem");
}

TEST(GltfPlants, OneAloneHasNoNodeOfItsOwn) {
  MeshScene scene = three_plants();
  const auto single = static_cast<std::uint32_t>(1);
  std::fill(scene.meshes[0].individuals.begin(), scene.meshes[0].individuals.end(), single);
  scene.meshes[1].individuals = {kNoIndividual};
  const Json json = written_glb(scene).json;
  EXPECT_EQ(json["nodes"].size(), 2U);
  EXPECT_EQ(json["scenes"][0]["nodes"], Json({0, 1}));
}

TEST(GltfPlants, MoreThanAThousandHaveNoNodes) {
  for (const std::uint32_t plants : {1000U, 1001U}) {
    MeshScene scene = scene_of(triangle(), std::vector<Frame>(plants));
    for (std::uint32_t k = 0; k < plants; ++k) {
      scene.individuals.push_back({"herb", k, Vec3(0)});
      scene.meshes[0].individuals.push_back(k);
    }
    EXPECT_EQ(written_glb(scene).json["nodes"].size(), plants == 1000 ? 2001U : 1U);
  }
}

}  // namespace meristem::gltf_plants_test
