// SPDX-License-Identifier: Apache-2.0
// Which of a document's plants each stem and organ belongs to.
#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "meristem/shape/assembly/make_mesh_scene.h"

namespace meristem::individuals_test {

GrownDocument grow(const std::string& components, const std::string& links) {
  const std::string text = R"({"meristem": 1, "components": {)" + components + R"(}, "links": [)" + links + "]}";
  Progress progress;
  return grow_document(read_document(text, "d.json", builtin_components()), progress);
}

constexpr const char* kLeafy = R"("leaf": {"type": "leaf", "length": 0.05})";

float flat_distance(Vec3 a, Vec3 b) { return glm::length(Vec2(a.x - b.x, a.z - b.z)); }

/// Expects each organ at its plant's foot, within `reach` of it, and each plant to have some.
void expect_organs_near_feet(const Plant& plant, float reach) {
  std::set<std::uint32_t> found;
  for (const Organ& organ : plant.organs) {
    ASSERT_LT(organ.individual, plant.individuals.size());
    EXPECT_LT(flat_distance(organ.frame.origin, plant.individuals[organ.individual].foot), reach);
    found.insert(organ.individual);
  }
  EXPECT_EQ(found.size(), plant.individuals.size());
}

/// Expects every vertex of every mesh that belongs to one plant near that plant's foot.
void expect_meshes_near_feet(const MeshScene& scene, float reach) {
  for (const MeshInstances& instances : scene.meshes) {
    for (std::size_t i = 0; i < instances.frames.size(); ++i) {
      ASSERT_LT(instances.individual(i), scene.individuals.size()) << instances.component;
      for (const Vec3 position : instances.mesh->positions) {
        const Vec3 foot = scene.individuals[instances.individual(i)].foot;
        ASSERT_LT(flat_distance(instances.frames[i].point(position), foot), reach) << instances.component;
      }
    }
  }
}

constexpr const char* kThreeRoots =
    R"("tree": {"type": "colonize", "crown": {"profile": [[0.2, 0.5], [0.5, 1], [0.2, 2]]},
  "points": 300, "step": 0.05, "influence": 0.5, "kill": 0.15, "roots": [[-9, 0, 0], [0, 0, 1], [9, 0, 0]]})";

TEST(Individuals, EachRootOfOneSkeletonIsOne) {
  const GrownDocument grown = grow(std::string(kThreeRoots) + "," + kLeafy,
                                   R"({"from": "tree", "to": "leaf", "kind": "branch", "density": 20})");
  ASSERT_EQ(grown.plant.individuals.size(), 3U);
  ASSERT_EQ(grown.plant.stems.size(), 1U);
  EXPECT_EQ(grown.plant.individuals[2].component, "tree");
  EXPECT_EQ(grown.plant.individuals[2].number, 2U);
  EXPECT_EQ(grown.plant.individuals[0].foot, Vec3(-9, 0, 0));
  EXPECT_EQ(grown.plant.individuals[1].foot, Vec3(0, 0, 1));
  expect_organs_near_feet(grown.plant, 2);
  expect_meshes_near_feet(grown.meshes, 2);
  // One stem gives a mesh per plant, of together the triangles that it has as one.
  const auto of_tree = [](const MeshInstances& instances) { return instances.component == "tree"; };
  EXPECT_EQ(std::count_if(grown.meshes.meshes.begin(), grown.meshes.meshes.end(), of_tree), 3);
  Plant undivided = grown.plant;
  undivided.individuals.clear();
  undivided.stems[0].individual_of_root.clear();
  for (Organ& organ : undivided.organs) organ.individual = 0;
  Progress progress;
  EXPECT_EQ(make_mesh_scene(undivided, {}, progress).triangle_count(), grown.meshes.triangle_count());
}

TEST(Individuals, EachInstanceInAFieldIsOneWithAllThatStandsOnIt) {
  const GrownDocument grown =
      grow(R"("field": {"type": "field", "rows": 2, "plants": 3, "spacing": 9, "row_spacing": 9},
    "trunk": {"type": "tree", "length": 2}, "limb": {"type": "tree", "length": 0.5}, )" +
               std::string(kLeafy),
           R"(["field", "trunk"], {"from": "trunk", "to": "limb", "kind": "branch", "count": 4},
    {"from": "limb", "to": "leaf", "kind": "branch", "count": 5})");
  ASSERT_EQ(grown.plant.individuals.size(), 6U);
  EXPECT_EQ(grown.plant.individuals[5].number, 5U);
  EXPECT_EQ(grown.plant.organs.size(), 6U * 4U * 5U);
  expect_organs_near_feet(grown.plant, 2);
  expect_meshes_near_feet(grown.meshes, 2);
}

TEST(Individuals, ComponentsUnderTheCameraAreCountedEach) {
  const GrownDocument grown = grow(R"("view": {"type": "camera"}, "ash": {"type": "tree"},
    "box": {"type": "tree", "frame": {"translate": [3, 0, 0]}})",
                                   R"(["view", "ash"], ["view", "box"])");
  ASSERT_EQ(grown.plant.individuals.size(), 2U);
  EXPECT_EQ(grown.plant.individuals[1].component, "box");
  EXPECT_EQ(grown.plant.individuals[1].number, 0U);
  EXPECT_EQ(grown.plant.individuals[1].foot, Vec3(3, 0, 0));
}

TEST(Individuals, AStarOfStemsIsOne) {
  const GrownDocument grown =
      grow(R"("tuft": {"type": "hydra", "number": 5}, "culm": {"type": "tree"}, )" + std::string(kLeafy),
           R"(["tuft", "culm"], ["culm", "leaf"])");
  EXPECT_EQ(grown.plant.individuals.size(), 1U);
  for (const MeshInstances& instances : grown.meshes.meshes) {
    for (std::size_t i = 0; i < instances.frames.size(); ++i) EXPECT_EQ(instances.individual(i), 0U);
  }
}

TEST(Individuals, OneBodyOfSeveralPlantsBelongsToNone) {
  std::string components = kThreeRoots;
  components.pop_back();
  const GrownDocument grown = grow(components + R"(, "surface": {"style": "blend", "resolution": 60}})", "");
  ASSERT_EQ(grown.meshes.meshes.size(), 1U);
  EXPECT_EQ(grown.meshes.meshes[0].individual(0), kNoIndividual);
}

}  // namespace meristem::individuals_test
