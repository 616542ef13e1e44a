// SPDX-License-Identifier: Apache-2.0
// A plant in several places must give rays, boxes and files that equal the results for its copies in the world.
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "meristem/output/gltf/gltf.h"
#include "meristem/output/mesh/obj.h"
#include "meristem/output/picture/clouds.h"
#include "meristem/shape/rays/ray_scene.h"
#include "tests/support/read_glb.h"
#include "tests/support/sample_scenes.h"

namespace meristem::placed_scene_test {

using Json = nlohmann::json;

Frame turned(float angle, Vec3 origin, float scale) {
  return {scale * Mat3(std::cos(angle), 0, -std::sin(angle), 0, 1, 0, std::sin(angle), 0, std::cos(angle)), origin};
}

/// Returns a plant of a stem and 60 leaves in four places.
MeshScene placed_scene() {
  MeshScene scene;
  scene.materials = {{.name = "oak.stem"}, {.name = "oak.leaf"}};
  const auto places = std::make_shared<const std::vector<Frame>>(
      std::vector<Frame>{Frame{}, turned(1, {12, 0, 0}, 1), turned(2, {0, 0, 15}, 1.5F), turned(4, {-9, 1, -8}, 0.8F)});
  const RandomKey key(3);
  std::vector<Frame> leaves;
  for (std::uint64_t k = 0; k < 60; ++k) {
    leaves.push_back(frame_along(2.0F * key.direction(k) + Vec3(0, 4, 0), key.child("way").direction(k), kUp));
  }
  scene.meshes = {{"oak.stem", strip(9), 0, {Frame{}}}, {"oak.leaf", triangle(), 1, leaves}};
  for (MeshInstances& part : scene.meshes) part.places = places;
  return scene;
}

/// Returns the placed scene with each instance written out.
MeshScene copied_scene() {
  MeshScene scene = placed_scene();
  for (MeshInstances& part : scene.meshes) {
    std::vector<Frame> all;
    for (std::size_t i = 0; i < part.count(); ++i) all.push_back(part.frame(i));
    part.frames = std::move(all);
    part.places = nullptr;
  }
  return scene;
}

TEST(PlacedScene, CountsAndBoundsAreThoseOfItsCopies) {
  const MeshScene placed = placed_scene(), copied = copied_scene();
  EXPECT_EQ(placed.instance_count(), 4 * 61U);
  EXPECT_EQ(placed.instance_count(), copied.instance_count());
  EXPECT_EQ(placed.triangle_count(), copied.triangle_count());
  EXPECT_EQ(placed.bounds().low, copied.bounds().low);
  EXPECT_EQ(placed.bounds().high, copied.bounds().high);
}

TEST(PlacedScene, RaysMeetWhatTheyMeetOfItsCopies) {
  const MeshScene placed = placed_scene(), copied = copied_scene();
  Progress progress;
  const RayScene a(placed, progress), b(copied, progress);
  const RandomKey key(8);
  int hits = 0;
  for (std::uint64_t k = 0; k < 4000; ++k) {
    const Vec3 target(static_cast<float>(key.uniform(2 * k, -13, 16)), static_cast<float>(key.uniform(2 * k, 0, 7)),
                      static_cast<float>(key.uniform(2 * k + 1, -12, 18)));
    const Vec3 from = target + 30.0F * key.child("from").direction(k);
    const Ray ray{from, glm::normalize(target - from)};
    const auto one = a.first_hit(ray), other = b.first_hit(ray);
    ASSERT_EQ(one.has_value(), other.has_value()) << k;
    EXPECT_EQ(a.is_blocked(ray), one.has_value());
    if (!one) continue;
    ++hits;
    EXPECT_NEAR(one->distance, other->distance, 1e-4);
    EXPECT_EQ(one->part, other->part);
    EXPECT_EQ(one->instance, other->instance);
    EXPECT_EQ(one->triangle, other->triangle);
    EXPECT_LT(glm::distance(a.surface_point(*one).normal, b.surface_point(*other).normal), 1e-4F);
  }
  EXPECT_GT(hits, 200);
}

TEST(PlacedScene, AnObjFileHasTheTrianglesOfAllPlaces) {
  TemporaryFolder folder;
  Progress progress;
  const auto lines_of = [&](const MeshScene& scene, const std::string& name) {
    write_obj(scene, (folder / name).string(), {}, progress);
    std::ifstream file(folder / name);
    std::multiset<std::string> lines;
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with("v ")) lines.insert(line);
    }
    return lines;
  };
  EXPECT_EQ(lines_of(placed_scene(), "placed.obj"), lines_of(copied_scene(), "copied.obj"));
}

/// The corners of all triangles of a file, for each instance of a mesh, rounded to a millimetre.
class Corners {
 public:
  explicit Corners(const Glb& glb) : glb_(glb) {
    for (const Json& node : glb.json["scenes"][0]["nodes"]) visit(node.get<std::size_t>(), glm::mat4(1));
  }
  std::multiset<std::string> places;

 private:
  static glm::mat4 matrix_of(const Json& node) {
    if (!node.contains("matrix")) return glm::mat4(1);
    const auto numbers = node["matrix"].get<std::vector<float>>();
    return glm::make_mat4(numbers.data());
  }

  void visit(std::size_t number, const glm::mat4& above) {
    const Json& node = glb_.json["nodes"][number];
    const glm::mat4 matrix = above * matrix_of(node);
    if (node.contains("mesh")) {
      for (const glm::mat4& instance : instances_of(node)) add(node["mesh"].get<std::size_t>(), matrix * instance);
    }
    if (!node.contains("children")) return;
    for (const Json& child : node["children"]) visit(child.get<std::size_t>(), matrix);
  }

  std::vector<glm::mat4> instances_of(const Json& node) const {
    if (!node.contains("extensions")) return {glm::mat4(1)};
    const Json& attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    const auto moves = glb_.values<Vec3>(glb_.accessor(attributes["TRANSLATION"]));
    const auto turns = glb_.values<Vec4>(glb_.accessor(attributes["ROTATION"]));
    const auto scales = glb_.values<Vec3>(glb_.accessor(attributes["SCALE"]));
    std::vector<glm::mat4> instances;
    for (std::size_t k = 0; k < moves.size(); ++k) {
      const glm::mat3 turn = glm::mat3_cast(glm::quat(turns[k].w, turns[k].x, turns[k].y, turns[k].z));
      glm::mat4 matrix(turn * glm::mat3(scales[k].x, 0, 0, 0, scales[k].y, 0, 0, 0, scales[k].z));
      matrix[3] = glm::vec4(moves[k], 1);
      instances.push_back(matrix);
    }
    return instances;
  }

  void add(std::size_t mesh, const glm::mat4& matrix) {
    for (const Json& primitive : glb_.json["meshes"][mesh]["primitives"]) {
      for (const Vec3 position : glb_.values<Vec3>(glb_.accessor(primitive, "POSITION"))) {
        const Vec3 at = matrix * glm::vec4(position, 1);
        places.insert(fmt::format("{:.2f} {:.2f} {:.2f}", at.x + 100, at.y + 100, at.z + 100));
      }
    }
  }

  const Glb& glb_;
};

TEST(PlacedScene, AGlbFileHoldsEachMeshOnceAndAllOfItsPlaces) {
  const Glb copied = written_glb(copied_scene(), {});
  const std::multiset<std::string> expected = Corners(copied).places;
  for (const GltfInstances instances : {GltfInstances::automatic, GltfInstances::rows, GltfInstances::nodes}) {
    GltfOptions options;
    options.instances = instances;
    const Glb placed = written_glb(placed_scene(), options);
    EXPECT_EQ(Corners(placed).places, expected);
    EXPECT_LT(2 * placed.binary.size(), copied.binary.size());
    ASSERT_EQ(placed.json["scenes"][0]["nodes"], Json::array({0})) << "one root";
    const Json& plants = placed.json["nodes"][0]["children"];
    ASSERT_EQ(plants.size(), 4U) << "a node per place";
    const Json& last = placed.json["nodes"][plants[3].get<std::size_t>()];
    EXPECT_EQ(last["name"], "oak 3");
  }
}

TEST(PlacedScene, EveryNodeOfAGlbHasOneParent) {
  GltfOptions options;
  options.instances = GltfInstances::rows;
  const Glb glb = written_glb(placed_scene(), options);
  std::map<std::size_t, int> parents;
  for (const Json& root : glb.json["scenes"][0]["nodes"]) ++parents[root.get<std::size_t>()];
  for (const Json& node : glb.json["nodes"]) {
    if (!node.contains("children")) continue;
    for (const Json& child : node["children"]) ++parents[child.get<std::size_t>()];
  }
  EXPECT_EQ(parents.size(), glb.json["nodes"].size());
  for (const auto& [node, count] : parents) EXPECT_EQ(count, 1) << node;
}

// Point clouds.

TEST(Clouds, CoverTheirShareOfTheSkyAndNoneOfItWithoutOne) {
  const Vec3 blue(0.1F, 0.2F, 0.6F);
  const RandomKey key(2);
  double before = -1;
  for (const double share : {0.0, 0.3, 0.6, 1.0}) {
    const Clouds clouds(share, glm::normalize(Vec3(1, 1, 0)), Vec3(1), Vec3(0.3F));
    double covered = 0;
    for (std::uint64_t k = 0; k < 4000; ++k) {
      Vec3 up = key.direction(k);
      up.y = std::abs(up.y);
      if (up.y > 0.3F) covered += clouds.over(up, blue) == blue ? 0 : 1;
    }
    if (share == 0) {
      EXPECT_EQ(covered, 0);
    } else {
      EXPECT_GT(covered, before);
    }
    before = covered;
  }
}

TEST(Clouds, LeaveTheHorizonAsItIs) {
  const Clouds clouds(1, kUp, Vec3(1), Vec3(0.3F));
  EXPECT_EQ(clouds.over({1, 0, 0}, Vec3(0.5F)), Vec3(0.5F));
}

}  // namespace meristem::placed_scene_test
